# SPDX-License-Identifier: BSD-3-Clause
"""Frames of another generation are named by length and generation, in text and JSON."""

from __future__ import annotations

import json
import socket
import threading

import pytest
import surefoot
from surefoot import protocol
from surefoot.cli import main
from surefoot.virtual_robot import VirtualRobotSettings
from surefoot.virtual_robot.rejected_datagrams import RejectedDatagrams
from surefoot.virtual_robot.robot_link import RobotLink

PAIRS = [(sent, own) for sent in protocol.GENERATIONS for own in protocol.GENERATIONS]
SIZES = {name: protocol.frame_sizes(name) for name in protocol.GENERATIONS}


class Port:
    def __init__(self, frames: list[bytes]) -> None:
        self.frames = frames

    def receive(self, limit: int) -> list[tuple[bytes, tuple[str, int]]]:
        taken, self.frames = self.frames[:limit], self.frames[limit:]
        return [(frame, ("127.0.0.1", 9)) for frame in taken]

    def send(self, data: bytes, address: tuple[str, int]) -> bool:
        return True


@pytest.mark.parametrize(("sent", "own"), [p for p in PAIRS if SIZES[p[0]][0] != SIZES[p[1]][0]])
def test_robot_names_length_and_generation_that_it_got_and_expected(sent, own) -> None:
    frame = protocol.encode_low_cmd(surefoot.LowCmd(), sent)
    link = RobotLink(Port([frame] * 30), VirtualRobotSettings(sdk=own))
    assert link.receive(0.0) is None
    text = link.rejected.text()
    assert text.startswith("30 (wrong generation 30: ")
    got, expected = SIZES[sent][0], SIZES[own][0]
    assert f"{got} bytes of " in text and f"expected {expected} bytes of {own}" in text
    (row,) = link.rejected.lengths()
    assert (row["bytes"], row["count"], row["expected_bytes"]) == (got, 30, expected)
    assert sent in row["generations"] and row["expected_generation"] == own
    assert json.dumps(link.rejected.lengths())
    (line,) = link.rejected.take_news()  # once, with the remedy
    assert sent in line and f"--sdk {row['generations'][0]}" in line
    assert link.rejected.take_news() == []


def test_generations_with_the_same_length_are_all_named() -> None:
    rejected = RejectedDatagrams("a1-v3.3")
    rejected.add("wrong generation", bytes(614))
    assert "614 bytes of go1-v3.8 or b1-v3.8, expected 610 bytes of a1-v3.3" in rejected.text()


def test_random_lengths_do_not_fill_memory_or_line() -> None:
    rejected = RejectedDatagrams("go1-v3.8")
    for size in range(1000):
        rejected.add("wrong length", bytes(size))
    assert rejected.counts == {"wrong length": 1000}
    assert len(rejected.lengths()) == len(rejected.take_news()) == 8
    assert "no frame of any generation" not in rejected.text() and len(rejected.text()) < 300


@pytest.fixture
def robot_of_another_generation():
    """Answer every command with a LowState of go1-v3.4."""
    server = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    server.bind(("127.0.0.1", 0))
    server.settimeout(0.1)
    frame, stop = protocol.encode_low_state(surefoot.LowState(), "go1-v3.4"), threading.Event()

    def answer() -> None:
        while not stop.is_set():
            try:
                server.sendto(frame, server.recvfrom(2048)[1])
            except TimeoutError:
                continue

    thread = threading.Thread(target=answer)
    thread.start()
    yield server.getsockname()[1]
    stop.set()
    thread.join()
    server.close()


def test_run_names_length_and_generation_in_text_and_json(
    robot_of_another_generation, capfd, tmp_path, monkeypatch
) -> None:
    monkeypatch.chdir(tmp_path)
    port = str(robot_of_another_generation)
    assert main(["run", "--port", port, "--json", "out.json"]) == 1
    out, err = capfd.readouterr()
    got = "got 795 bytes, a frame of go1-v3.4, expected 807 bytes, a frame of go1-v3.8"
    assert f"does not use go1-v3.8: {got}; use --sdk go1-v3.4" in err
    assert f"a datagram was rejected: {got}" in out and "of another generation" in out
    result = json.loads((tmp_path / "out.json").read_text())
    assert (result["reason"], result["reject"]) == ("wrong_generation", got)
    assert result["rejected_frame"] == {
        "bytes": 795,
        "generation": "go1-v3.4",
        "expected_bytes": 807,
        "expected_generation": "go1-v3.8",
    }


def test_decoder_names_both_lengths() -> None:
    frame = protocol.encode_low_cmd(surefoot.LowCmd(), "a1-v3.3")
    with pytest.raises(surefoot.Error, match=r"got 610 bytes, a frame of a1-v3.3, expected 614 "):
        protocol.decode_low_cmd(frame)
    with pytest.raises(surefoot.Error, match=r"got 7 bytes, .*, expected 614 bytes, a frame of"):
        protocol.decode_low_cmd(bytes(7))

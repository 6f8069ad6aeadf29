"""DDS with the vendor's Python classes as peers, in other processes and of other versions."""

from __future__ import annotations

import json
import os
import shutil
import struct
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest
import surefoot
from dds_environments import ROOT, c_peer, library_path, new_domain, peer_python
from surefoot import DdsLink, DdsNetwork, DdsRobotPort, LowCmd, LowState

pytestmark = pytest.mark.real_time

PEER = Path(__file__).with_name("dds_peer.py")
VERSIONS = ("0.10.2", "11.0.1")
PEER_TIME = 4.0  # [s] time for which the peer sends
TAU = 0.25  # [N.m] in the commands of the peer


class Peer:
    """A process with the vendor's classes."""

    def __init__(self, role: str, version: str, domain: int) -> None:
        # -E: the path of this process is not that of the peer.
        command = [peer_python(version), "-E", str(PEER), role, str(domain), str(PEER_TIME)]
        self._process = subprocess.Popen(
            command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
        )

    @property
    def runs(self) -> bool:
        return self._process.poll() is None

    def result(self) -> dict[str, Any]:
        """Return what the peer printed; it must have ended without a crash."""
        output, errors = self._process.communicate(timeout=30)
        assert self._process.returncode == 0, errors
        return dict(json.loads(output.splitlines()[-1]))


@pytest.mark.parametrize("peer_version", VERSIONS)
@pytest.mark.parametrize("our_version", VERSIONS)
def test_vendor_commander_and_our_robot_exchange_messages(
    our_version: str, peer_version: str
) -> None:
    domain = new_domain()
    network = DdsNetwork("lo", domain, library=library_path(our_version))
    port = DdsRobotPort(network, "go2", discovery_time=0.2)
    peer = Peer("commander", peer_version, domain)
    state = LowState()
    state.imu.quaternion[:] = [1.0, 0.0, 0.0, 0.0]
    state.motorState[3].temperature = 40
    newest = None
    while peer.runs:
        state.tick += 2
        port.send(state)
        newest = port.receive() or newest
        time.sleep(0.002)
    result = peer.result()
    assert result["received"] > 300
    assert result["wrong_crc"] == 0
    assert newest is not None and newest.motorCmd[0].tau == TAU
    assert port.counts.wrong_crc == port.counts.not_servo == 0
    payload = bytes.fromhex(result["payload"])
    assert len(payload) == 1176
    assert struct.unpack_from("<f", payload, 24) == (1.0,)  # quaternion
    assert payload[124 + 48 * 2 + 32] == 40  # temperature of motor 3
    assert payload[1172:] != bytes(4)  # crc


@pytest.mark.parametrize(
    ("robot", "our_version", "peer_version"),
    [*(("go2", ours, peer) for ours in VERSIONS for peer in VERSIONS), ("b2", *VERSIONS[:1] * 2)],
)
def test_our_link_and_vendor_robot_exchange_messages(
    robot: str, our_version: str, peer_version: str
) -> None:
    domain = new_domain()
    network = DdsNetwork("lo", domain, library=library_path(our_version))
    peer = Peer("robot", peer_version, domain)
    link = DdsLink(network, robot)
    cmd = LowCmd()
    cmd.motorCmd[0].q, cmd.motorCmd[1].tau, cmd.motorCmd[1].Kd = 0.5, 1.5, 2.0
    while peer.runs:
        link.receive()
        link.send(cmd)
        time.sleep(0.002)
    result = peer.result()
    mode = 0x01 if robot == "go2" else 0x0A
    assert link.counts.valid > 300
    assert link.counts.corrupt == link.counts.duplicate == link.dds_counts.without_crc == 0
    assert link.state.bms.SOC == 80
    assert result["received"] > 300
    assert result["wrong_crc"] == 0
    assert result["modes"] == [mode] * 20
    payload = bytes.fromhex(result["payload"])
    assert len(payload) == 808
    assert payload[:3] == b"\xfe\xef\xff"
    assert payload[22] == mode  # motor 0
    assert struct.unpack_from("<f", payload, 24) == (0.5,)  # its q
    assert [payload[56 + 36 * i] for i in range(19)] == [mode] * 19  # motors 1 .. 19
    assert struct.unpack_from("<f", payload, 60 + 8) == (1.5,)  # tau of motor 1
    assert struct.unpack_from("<f", payload, 60 + 16) == (2.0,)  # kd of motor 1
    assert payload[740] == 0  # the battery is not switched off
    assert payload[804:] != bytes(4)  # crc


MULTICAST = (
    '<CycloneDDS><Domain><General><Interfaces><NetworkInterface name="lo" multicast="true"/>'
    "</Interfaces></General></Domain></CycloneDDS>"
)


@pytest.mark.build
@pytest.mark.parametrize("our_version", VERSIONS)
def test_c_peer_with_type_information_stays_alive(our_version: str, tmp_path: Path) -> None:
    domain = new_domain()
    network = DdsNetwork("lo", domain, library=library_path(our_version))
    port = DdsRobotPort(network, "go2", discovery_time=0.2)
    peer = subprocess.Popen(
        [c_peer(tmp_path), str(domain), "3"],
        stdout=subprocess.PIPE,
        text=True,
        env={**os.environ, "CYCLONEDDS_URI": MULTICAST},
    )
    state = LowState()
    while peer.poll() is None:
        state.tick += 2
        port.send(state)
        port.receive()
        time.sleep(0.002)
    assert peer.returncode == 0
    assert int(peer.communicate()[0]) > 300
    assert port.counts.wrong_crc > 300  # the peer computes none


def test_committed_descriptors_are_the_output_of_idlc(tmp_path: Path) -> None:
    if shutil.which("idlc") is None:
        pytest.skip("no idlc: apt install cyclonedds-tools")
    source = ROOT / "controller" / "src" / "dds"
    for name in ("unitree_go", "unitree_api"):
        subprocess.run(["idlc", "-t", source / "idl" / f"{name}.idl"], cwd=tmp_path, check=True)
        for ending in (".c", ".h"):
            made = (tmp_path / f"{name}{ending}").read_text().splitlines()
            committed = (source / "generated" / f"{name}{ending}").read_text().splitlines()
            assert [x for x in made if "Source:" not in x] == [
                x for x in committed if "Source:" not in x
            ]


def test_peer_that_ends_is_told_by_name() -> None:
    domain = new_domain()
    network = DdsNetwork("lo", domain)
    peer = Peer("robot", "11.0.1", domain)
    link = DdsLink(network, "go2", discovery_time=2.0)
    found = " ".join(link.take_news())
    assert "writer of rt/lowstate found: process python" in found
    peer.result()
    time.sleep(0.5)
    link.receive()
    assert "no valid LowState for 0.1 s from process python" in " ".join(link.take_news())


def test_domain_of_the_vendor_classes_in_this_process_is_refused_by_name() -> None:
    domain = new_domain()
    program = (
        "import cyclonedds.domain, surefoot\n"
        f"participant = cyclonedds.domain.DomainParticipant({domain})\n"
        f"surefoot.DdsNetwork('lo', {domain})\n"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert done.returncode == 1
    assert f"DDS domain {domain}: got a domain that this process has joined already" in done.stderr


def test_missing_libddsc_is_refused_in_one_line() -> None:
    with pytest.raises(surefoot.Error, match=r"^libddsc .*got none of /nowhere.*pip install"):
        DdsNetwork("lo", new_domain(), library="/nowhere/libddsc.so")

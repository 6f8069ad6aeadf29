import json
import re
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import surefoot
from surefoot.bench import BenchSettings, peers, record
from surefoot.bench.peers import RATIOS, PeerError, PeerOptions, cpp_program, run_peers
from surefoot.bench.peers.environment import Environment
from surefoot.bench.peers.paired_run_setup import PACKAGE_FOLDER
from surefoot.bench.peers.peer import OUR_PROGRAM, PEERS, Peer
from surefoot.bench.peers.problem import make_problem
from surefoot.bench.peers.problem_files import write_problem
from surefoot.bench.peers.surefoot_implementations import (
    SOLVED,
    StateToTorque,
    WholeTick,
    tick_width,
)
from surefoot.bench.peers.worker import Worker
from surefoot.cli import main
from surefoot.robot.description import describe_robot

pytestmark = pytest.mark.build

TICKS = 600  # includes the first push, at 1 s
WORKERS = Path(peers.__file__).parent / "workers"
# A fake peer: it reads the solutions from a file and corrupts them after tick 60.
FAKE_PEER_SCRIPT = """
import os, sys, time
sys.path.insert(0, {workers!r})
import numpy as np
from worker_loop import serve

class Fake:
    def __init__(self, problem):
        self.answers, self.k = np.load({answers!r}), -1
        print("a library that prints where it should not")
    def load(self, k):
        self.k += 1
    def tick(self):
        self.row = self.answers[self.k % len(self.answers)].copy()
        if self.k > 60:
            {corruption}
    def read_result(self):
        return self.row[2], self.row[3:15], self.row[15:]

serve(Fake, ["numpy"])
"""


class CurrentInterpreter(Environment):
    """A peer's environment that is this interpreter."""

    def prepare(self, options):
        return Path(sys.executable)


@pytest.fixture(scope="module")
def recording():
    whole = record(BenchSettings(), "push50")
    return replace(whole, low_states=whole.low_states[:TICKS])


@pytest.fixture(scope="module")
def problem(recording):
    return make_problem(recording, describe_robot("go1").urdf)


@pytest.fixture
def make_fake_peer(tmp_path, problem):
    np.save(tmp_path / "answers.npy", StateToTorque(problem).run_ticks(0, TICKS))

    def make(name, corruption="pass", environment=None):
        script = tmp_path / f"{name}.py"
        answers = str(tmp_path / "answers.npy")
        script.write_text(
            FAKE_PEER_SCRIPT.format(workers=str(WORKERS), answers=answers, corruption=corruption)
        )
        return Peer(
            name, environment or CurrentInterpreter(name, ()), str(script), None, "a tick", "none"
        )

    return make


@pytest.fixture
def options(tmp_path):
    return PeerOptions(folder=tmp_path / "venvs", cpp=False, timeout=10.0)


def test_working_peer_is_compared_in_paired_runs(recording, make_fake_peer, options):
    result = run_peers(recording, options, [make_fake_peer("tsid"), make_fake_peer("placo")])
    assert json.loads(json.dumps(result)) == result
    for ratio in RATIOS:
        assert result[ratio] > 0.0 and result[f"{ratio}_language"] == "python"
    for row in result["rows"]:
        assert row["reason"] is None and row["pairs"] == TICKS
        assert row["versions"] == {"numpy": np.__version__}
        for side in (row["theirs"], row["our_state_to_torque"], row["our_tick"]):
            assert side["wall_us"]["n"] == TICKS and side["cpu_us"]["p50"] > 0.0
            assert side["failures"] == 0 and side["tick"]
        assert row["answers"]["verdict"] == "same answer"
        assert row["answers"]["greatest_torque_difference_nm"]["all"] < 1e-3
    assert "tsid (python)" in peers.peers_text(result)


def test_recordings_are_pooled_and_one_failure_fails_the_peer(recording, make_fake_peer, options):
    short = replace(recording, low_states=recording.low_states[:50])
    both = [make_fake_peer("tsid", "os._exit(3)"), make_fake_peer("placo")]
    result = run_peers([short, recording], options, both)
    assert result["scenarios"] == {"push50": TICKS}
    failed, played = result["rows"]
    assert failed["reason"].startswith("ended with status 3")
    assert played["reason"] is None and played["pairs"] == TICKS + 50


@pytest.mark.parametrize(
    ("corruption", "said"),
    [
        ("sys.stderr.write('out of luck\\n'); sys.stderr.flush(); os.abort()", "SIGABRT.*luck"),
        ("raise ValueError('a bad thing')", "status 1: ValueError: a bad thing"),
        ("time.sleep(60.0)", "no answer within 1 s"),
        ("self.row[:] = float('nan')", "not finite"),
    ],
)
def test_peer_failure_is_reported_and_other_peers_continue(
    recording, make_fake_peer, options, corruption, said
):
    both = [make_fake_peer("tsid", corruption), make_fake_peer("placo")]
    result = run_peers(recording, replace(options, timeout=1.0), both)
    assert result["ratio_tick_over_tsid"] is None
    assert result["ratio_state_to_torque_over_placo"] > 0.0
    assert re.search(said, result["ratio_tick_over_tsid_reason"])
    assert "did not run" in peers.peers_text(result)


@pytest.mark.parametrize(
    ("corruption", "verdict"),
    [
        ("self.row[3:] = 0.0", "another answer: a foot force differs by up to"),
        # The total force does not change: dynamics determine it, but not the share of each foot.
        ("self.row[5] += 20.0; self.row[8] -= 20.0", "another answer: a foot force .* up to 20 N"),
        # At a single tick.
        (
            "self.row[3] += 20.0 * (self.k % 600 == 99)",
            "another answer: a foot force .* up to 20 N",
        ),
        ("self.row[15:] += 2.0", "another answer: torques differ by up to 2 N.m"),
    ],
)
def test_peer_with_a_different_solution_gets_no_ratio(
    recording, make_fake_peer, options, corruption, verdict
):
    result = run_peers(
        recording, options, [make_fake_peer("tsid", corruption), make_fake_peer("placo")]
    )
    row = result["rows"][0]
    assert row["reason"] is None and re.match(verdict, row["answers"]["verdict"])
    assert result["ratio_tick_over_tsid"] is result["ratio_tick_over_tsid_language"] is None
    assert re.match(verdict, result["ratio_tick_over_tsid_reason"])
    assert result["ratio_state_to_torque_over_placo"] > 0.0


def test_unsolved_ticks_of_a_peer_are_counted_and_give_no_ratio(recording, make_fake_peer, options):
    result = run_peers(recording, options, [make_fake_peer("tsid", "self.row[2] = self.k % 2")])
    failures = result["rows"][0]["theirs"]["failures"]
    assert failures == TICKS // 2
    for ratio in ("ratio_state_to_torque_over_tsid", "ratio_tick_over_tsid"):
        assert result[ratio] is None
        assert result[f"{ratio}_reason"] == f"unsolved ticks: {failures} of theirs"


def test_environment_creation_failure_is_reported_as_reason(
    recording, make_fake_peer, options, tmp_path
):
    (tmp_path / "venvs").write_text("no folder")
    peer = make_fake_peer("tsid", environment=Environment("tsid", ()))
    (row,) = run_peers(recording, options, [peer])["rows"]
    assert row["reason"].startswith("its environment could not be made")


def test_environment_is_rebuilt_only_when_its_pins_change(options, monkeypatch):
    from surefoot.bench.peers import environment

    ran = []

    def run(words):
        ran.append(words[1:4])
        python = Environment("tsid", ()).python(options)
        python.parent.mkdir(parents=True, exist_ok=True)
        python.touch()

    monkeypatch.setattr(environment, "_run", run)
    for pins, runs in ((("a==1",), 2), (("a==1",), 2), (("a==2",), 4)):
        Environment("tsid", (pins,)).prepare(options)
        assert len(ran) == runs
    assert [words[1] for words in ran] == ["venv", "pip", "venv", "pip"]


def test_robot_without_urdf_is_reported_as_reason(recording, options):
    config = recording.robot.config
    config.name = "homemade"
    text = recording.robot.serialized_model()
    homemade = surefoot.Robot.from_serialized_model(text, config)
    result = run_peers(replace(recording, robot=homemade), options)
    assert all("URDF" in result[f"{ratio}_reason"] for ratio in RATIOS)


def test_python_ratio_is_used_without_a_compiler(recording, make_fake_peer, options, monkeypatch):
    monkeypatch.setattr(cpp_program.shutil, "which", lambda _: None)
    peer = replace(make_fake_peer("tsid"), cpp_program=PEERS[0].cpp_program)
    result = run_peers(recording, replace(options, cpp=True), [peer])
    assert result["ratio_tick_over_tsid_language"] == "python"
    assert [row["language"] for row in result["rows"]] == ["python", "c++"]
    assert "no g++" in result["rows"][1]["reason"]


def test_cpp_ticks_match_python_ticks(recording, problem, options, tmp_path):
    file = write_problem(problem, recording.low_states, tmp_path)
    program = OUR_PROGRAM.build([PACKAGE_FOLDER, PACKAGE_FOLDER.parent / "cmeel.prefix"], options)
    sides = {
        "state_to_torque": StateToTorque(problem),
        "tick": WholeTick(problem, recording.low_states),
    }
    for name, ours in sides.items():
        worker = Worker([str(program), str(file), name], tick_width(problem), 10.0)
        ticks = np.vstack([worker.run_ticks(0, 100), worker.run_ticks(100, TICKS - 100)])
        worker.close()
        np.testing.assert_allclose(
            ticks[:, SOLVED:], ours.run_ticks(0, TICKS)[:, SOLVED:], atol=1e-6
        )


def test_worker_start_failure_raises_an_error():
    with pytest.raises(PeerError, match="could not be started"):
        Worker(["/no/such/program"], 27, 1.0)


@pytest.mark.parametrize(("field", "value"), [("block", 0), ("timeout", 0.0)])
def test_invalid_peer_options_are_refused(field, value):
    with pytest.raises(surefoot.Error, match=f"{field}: got 0"):
        PeerOptions(**{field: value})


def test_bench_command_adds_peer_ratios_to_the_result(monkeypatch, capsys, make_fake_peer):
    def compare(recordings, options):
        played = [replace(r, low_states=r.low_states[:TICKS]) for r in recordings[-1:]]
        return run_peers(played, replace(options, cpp=False), [make_fake_peer("tsid")])

    monkeypatch.setattr(peers.run, "run_peers", compare)
    words = ["bench", "--ticks", "100", "--scenario", "push50", "--peers", "--json", "-"]
    assert main(words) == 0
    figures = json.loads(capsys.readouterr().out)
    assert figures["ratio_tick_over_tsid"] == figures["peers"]["ratio_tick_over_tsid"] > 0.0
    assert figures["ratio_state_to_torque_over_placo"] is None
    assert figures["ratio_reason"] == "not requested"

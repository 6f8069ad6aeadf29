"""The solver benchmark tells the truth: of right answers, wrong ones, silence and crashes."""

import json
from pathlib import Path

import numpy as np
import pytest
from surefoot import Error
from surefoot.bench.problems import Sequence, load_sequence
from surefoot.bench.problems.sequence import FORMAT
from surefoot.bench.solvers import SOLVERS, run_solvers, solvers_text
from surefoot.bench.solvers.build import Builder
from surefoot.bench.solvers.figures import figures
from surefoot.bench.solvers.process import Work, run_program
from surefoot.bench.solvers.raw_file import MAGIC, write_raw

ADAPTERS = Path(__file__).parent / "solver_adapters"
FAKES = ["honest", "crasher", "liar"]
TICKS, SIZE = 8, 3


def hand_made() -> Sequence:
    """Minimise 1/2 |x|^2 + g'x, l <= x <= u: the answer is -g, clamped."""
    g = np.array([[(-1.0) ** t * (t + 1), 0.5, -4.0] for t in range(TICKS)])
    eye = np.tile(np.eye(SIZE), (TICKS, 1, 1))
    meta = {"format": FORMAT, "robot": "none", "scenario": "hand", "form": "made", "elastic": False}
    return Sequence(
        meta,
        np.arange(TICKS, dtype=np.int64),
        H=eye,
        g=g,
        A=np.zeros((TICKS, 0, SIZE)),
        b=np.zeros((TICKS, 0)),
        C=eye.copy(),
        l=np.tile([-2.0, -np.inf, -1.0], (TICKS, 1)),
        u=np.tile([2.0, 1.0, np.inf], (TICKS, 1)),
    )


def with_equalities() -> tuple[Sequence, np.ndarray]:
    """Programs made from their answers: x, y and z first, g and the bounds that belong to them."""
    rng = np.random.default_rng(1)
    n, n_eq, n_in = 6, 2, 5
    root = rng.normal(size=(TICKS, n, n))
    H = root @ root.transpose(0, 2, 1) + np.eye(n)
    A, C = rng.normal(size=(TICKS, n_eq, n)), rng.normal(size=(TICKS, n_in, n))
    x, y, z = (rng.normal(size=(TICKS, size)) for size in (n, n_eq, n_in))
    z = (
        np.sign(z) * (0.5 + np.abs(z)) * [1, 1, 0, 0, 0]
    )  # the first two rows push, from either side
    Ax, Cx = (np.einsum("tij,tj->ti", rows, x) for rows in (A, C))
    low, high = np.where(z < 0, Cx, Cx - 1.0), np.where(z > 0, Cx, Cx + 1.0)
    low[:, 3], high[:, 4] = -np.inf, np.inf
    g = -sum(np.einsum("tij,ti->tj", rows, by) for rows, by in ((H, x), (A, y), (C, z)))
    meta = {"format": FORMAT, "robot": "none", "scenario": "known", "form": "x", "elastic": False}
    ticks = np.arange(TICKS, dtype=np.int64)
    return Sequence(meta, ticks, H=H, g=g, A=A, b=Ax, C=C, l=low, u=high), x


@pytest.fixture(scope="module")
def builder(tmp_path_factory):
    return Builder(tmp_path_factory.mktemp("peers"))


@pytest.mark.parametrize("solver", SOLVERS)
def test_every_solver_that_is_installed_finds_a_known_answer_with_equalities(
    builder, tmp_path, solver
):
    program = builder.program(solver)
    if isinstance(program, str):
        pytest.skip(program)
    sequence, x = with_equalities()
    write_raw(sequence, tmp_path / "sequence")
    work = Work(tmp_path / "sequence", None, TICKS, tmp_path / "records")
    for mode in ("warm", "cold"):
        records, reason = run_program(program, work, mode, 1e-6, tmp_path / "answers")
        if records is None:
            assert (solver, mode) == ("eiquadprog", "warm")
            continue
        assert reason is None
        np.testing.assert_allclose(
            np.fromfile(tmp_path / "answers").reshape(TICKS, -1), x, atol=1e-4
        )
        found = figures(records, 1e-6)
        assert (found["failures"], found["wrong"]) == (0, 0), found["worst"]


@pytest.fixture(scope="module")
def result(tmp_path_factory):
    build = tmp_path_factory.mktemp("solvers")
    files = [ADAPTERS / f"{name}.cpp" for name in FAKES]
    return run_solvers([hand_made()], [*FAKES, "surefoot"], folder=build, extra=files)


@pytest.fixture
def solvers(result):
    return result["sequences"]["none-hand-made"]["solvers"]


@pytest.mark.parametrize("name", ["honest", "surefoot"])
@pytest.mark.parametrize("mode", ["warm", "cold"])
def test_right_answers_are_right(solvers, name, mode):
    found = solvers[name][mode]
    assert found["reason"] is None
    assert (found["n"], found["failures"], found["wrong"]) == (TICKS, 0, 0)
    assert found["allocations"]["max"] == 0
    assert found["worst"]["distance"] < 1e-9, "the reference is the answer that we know"
    assert 0.0 < found["wall_us"]["p50"] <= found["wall_us"]["max"]


def test_cold_is_from_nothing_and_warm_is_not(solvers):
    assert solvers["honest"]["warm"]["iterations"]["max"] == TICKS
    assert solvers["honest"]["cold"]["iterations"]["max"] == 1


def test_a_crash_is_told_and_takes_no_other_down(solvers):
    warm, cold = solvers["crasher"]["warm"], solvers["crasher"]["cold"]
    assert warm["reason"] == f"SIGSEGV after 2 of {TICKS} ticks"
    assert (warm["failures"], warm["not_reached"], warm["wrong"]) == (TICKS - 2, TICKS - 2, 0)
    assert cold["reason"] is None and cold["failures"] == 0


def test_a_lie_is_found_out(solvers):
    warm, cold = solvers["liar"]["warm"], solvers["liar"]["cold"]
    assert (warm["failures"], warm["wrong"], warm["said_solved_but_wrong"]) == (0, TICKS, TICKS)
    assert warm["worst"]["distance"] == pytest.approx(1e-4, rel=1e-2)
    assert (cold["no_status"], cold["said_failed_but_right"]) == (TICKS // 2, TICKS // 2)
    assert (cold["wrong"], cold["said_solved_but_wrong"]) == (0, 0)


def test_allocations_are_counted(solvers):
    assert solvers["liar"]["warm"]["allocations"]["mean"] >= 1.0


def test_the_result_is_json_and_a_table(result):
    assert json.loads(json.dumps(result, allow_nan=False)) == result
    text = solvers_text(result)
    assert "crasher warm: SIGSEGV after 2 of 8 ticks" in text
    assert "8 programs, 3 variables, 0 equalities, 3 two-sided rows" in text


def test_an_unknown_solver_is_refused():
    with pytest.raises(Error, match="got 'gurobi', expected some of surefoot"):
        run_solvers([], ["gurobi"])


def test_a_solver_that_is_not_installed_says_how_to_get_it(monkeypatch, tmp_path):
    monkeypatch.setenv("SUREFOOT_PEERS", str(tmp_path))
    monkeypatch.setattr("surefoot.bench.solvers.places.sites", lambda: iter([tmp_path]))
    result = run_solvers([hand_made()], ["daqp"], folder=tmp_path / "build")
    entry = result["sequences"]["none-hand-made"]["solvers"]["daqp"]
    assert "pip install casadi" in entry["reason"] and entry["warm"] is None
    assert "daqp: not installed" in solvers_text(result)
    assert "daqp" in SOLVERS


def test_sequences_round_trip(tmp_path):
    sequence = hand_made()
    again = load_sequence(sequence.save(tmp_path))
    assert again.meta == sequence.meta
    for name in ("tick", *"HgAbClu"):
        assert np.array_equal(getattr(again, name), getattr(sequence, name))
    write_raw(again, tmp_path / "raw")
    raw = (tmp_path / "raw").read_bytes()
    assert raw[:8] == MAGIC
    assert np.frombuffer(raw[8:40], dtype=np.int64).tolist() == [SIZE, 0, SIZE, TICKS]
    doubles = np.frombuffer(raw[40:])
    assert np.array_equal(doubles[: sequence.H.size], sequence.H.ravel())
    assert np.array_equal(doubles[-sequence.u.size :], sequence.u.ravel())

"""The solver benchmark detects right and wrong solutions, missing statuses and crashes."""

import json
from pathlib import Path

import numpy as np
import pytest
from surefoot import Error
from surefoot.bench.problems import QpSequence, load_sequence
from surefoot.bench.problems.qp_sequence import FORMAT
from surefoot.bench.solvers import SOLVERS, run_solvers, solvers_text
from surefoot.bench.solvers.raw_file import MAGIC, write_raw
from surefoot.bench.solvers.solver_build import SolverBuilder
from surefoot.bench.solvers.solver_process import SolverFiles, run_program
from surefoot.bench.solvers.solver_statistics import solver_statistics

pytestmark = pytest.mark.build

ADAPTERS = Path(__file__).parent / "solver_adapters"
TEST_ADAPTERS = ["correct", "crashing", "wrong_status"]
TICKS, SIZE = 8, 3


def box_sequence() -> QpSequence:
    """Return QPs: minimise 1/2 |x|^2 + g'x subject to l <= x <= u; x = clamp(-g, l, u)."""
    g = np.array([[(-1.0) ** t * (t + 1), 0.5, -4.0] for t in range(TICKS)])
    eye = np.tile(np.eye(SIZE), (TICKS, 1, 1))
    meta = {"format": FORMAT, "robot": "none", "scenario": "hand", "form": "made", "elastic": False}
    return QpSequence(
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


def known_solution_sequence() -> tuple[QpSequence, np.ndarray]:
    """Return QPs built from chosen x and multipliers y, z; also return x, (ticks, n)."""
    rng = np.random.default_rng(1)
    n, n_eq, n_in = 6, 2, 5
    root = rng.normal(size=(TICKS, n, n))
    H = root @ root.transpose(0, 2, 1) + np.eye(n)
    A, C = rng.normal(size=(TICKS, n_eq, n)), rng.normal(size=(TICKS, n_in, n))
    x, y, z = (rng.normal(size=(TICKS, size)) for size in (n, n_eq, n_in))
    z = (
        np.sign(z) * (0.5 + np.abs(z)) * [1, 1, 0, 0, 0]
    )  # the first two constraints are active, at either bound
    Ax, Cx = (np.einsum("tij,tj->ti", rows, x) for rows in (A, C))
    low, high = np.where(z < 0, Cx, Cx - 1.0), np.where(z > 0, Cx, Cx + 1.0)
    low[:, 3], high[:, 4] = -np.inf, np.inf
    g = -sum(np.einsum("tij,ti->tj", rows, by) for rows, by in ((H, x), (A, y), (C, z)))
    meta = {"format": FORMAT, "robot": "none", "scenario": "known", "form": "x", "elastic": False}
    ticks = np.arange(TICKS, dtype=np.int64)
    return QpSequence(meta, ticks, H=H, g=g, A=A, b=Ax, C=C, l=low, u=high), x


@pytest.fixture(scope="module", autouse=True)
def unoptimised():
    """Compile without optimisation, because no test compares times."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("CMAKE_BUILD_TYPE", "None")
        yield


@pytest.fixture(scope="module")
def build_folder(tmp_path_factory):
    """One folder, so that the harness and Surefoot's adapter are compiled once."""
    return tmp_path_factory.mktemp("solvers")


@pytest.fixture(scope="module")
def builder(build_folder):
    return SolverBuilder(build_folder)


@pytest.mark.parametrize("solver", SOLVERS)
def test_installed_solvers_solve_a_qp_with_known_solution(builder, tmp_path, solver):
    program = builder.build(solver)
    if isinstance(program, str):
        pytest.skip(program)
    sequence, x = known_solution_sequence()
    write_raw(sequence, tmp_path / "sequence")
    work = SolverFiles(tmp_path / "sequence", None, TICKS, tmp_path / "records")
    for mode in ("warm", "cold"):
        records, reason = run_program(program, work, mode, 1e-6, tmp_path / "answers")
        if records is None:
            assert (solver, mode) == ("eiquadprog", "warm")
            continue
        assert reason is None
        np.testing.assert_allclose(
            np.fromfile(tmp_path / "answers").reshape(TICKS, -1), x, atol=1e-4
        )
        found = solver_statistics(records, 1e-6)
        assert (found["failures"], found["wrong"]) == (0, 0), found["worst"]


@pytest.fixture(scope="module")
def result(build_folder):
    files = [ADAPTERS / f"{name}.cpp" for name in TEST_ADAPTERS]
    return run_solvers(
        [box_sequence()], [*TEST_ADAPTERS, "surefoot"], folder=build_folder, extra=files
    )


@pytest.fixture
def solvers(result):
    return result["sequences"]["none-hand-made"]["solvers"]


@pytest.mark.parametrize("name", ["correct", "surefoot"])
@pytest.mark.parametrize("mode", ["warm", "cold"])
def test_correct_solvers_are_scored_as_correct(solvers, name, mode):
    found = solvers[name][mode]
    assert found["reason"] is None
    assert (found["n"], found["failures"], found["wrong"]) == (TICKS, 0, 0)
    assert found["allocations"]["max"] == 0
    assert found["worst"]["distance"] < 1e-9, "the reference differs from the known solution"
    assert 0.0 < found["wall_us"]["p50"] <= found["wall_us"]["max"]


def test_cold_mode_resets_the_solver_and_warm_mode_does_not(solvers):
    assert solvers["correct"]["warm"]["iterations"]["max"] == TICKS
    assert solvers["correct"]["cold"]["iterations"]["max"] == 1


def test_solver_crash_is_reported_and_others_continue(solvers):
    warm, cold = solvers["crashing"]["warm"], solvers["crashing"]["cold"]
    assert warm["reason"] == f"SIGSEGV after 2 of {TICKS} ticks"
    assert (warm["failures"], warm["not_reached"], warm["wrong"]) == (TICKS - 2, TICKS - 2, 0)
    assert cold["reason"] is None and cold["failures"] == 0


def test_wrong_solver_status_is_detected(solvers):
    warm, cold = solvers["wrong_status"]["warm"], solvers["wrong_status"]["cold"]
    assert (warm["failures"], warm["wrong"], warm["said_solved_but_wrong"]) == (0, TICKS, TICKS)
    assert warm["worst"]["distance"] == pytest.approx(1e-4, rel=1e-2)
    assert (cold["no_status"], cold["said_failed_but_right"]) == (TICKS // 2, TICKS // 2)
    assert (cold["wrong"], cold["said_solved_but_wrong"]) == (0, 0)


def test_solver_allocations_are_counted(solvers):
    assert solvers["wrong_status"]["warm"]["allocations"]["mean"] >= 1.0


def test_result_is_valid_json_and_prints_as_a_table(result):
    assert json.loads(json.dumps(result, allow_nan=False)) == result
    text = solvers_text(result)
    assert "crashing warm: SIGSEGV after 2 of 8 ticks" in text
    assert "8 QPs, 3 variables, 0 equalities, 3 two-sided constraints" in text


def test_an_unknown_solver_is_refused():
    with pytest.raises(Error, match="got 'gurobi', expected some of surefoot"):
        run_solvers([], ["gurobi"])


def test_missing_solver_error_names_the_install_command(monkeypatch, tmp_path, build_folder):
    monkeypatch.setenv("SUREFOOT_PEERS", str(tmp_path))
    monkeypatch.setattr(
        "surefoot.bench.solvers.solver_paths.package_folders", lambda: iter([tmp_path])
    )
    result = run_solvers([box_sequence()], ["daqp"], folder=build_folder)
    entry = result["sequences"]["none-hand-made"]["solvers"]["daqp"]
    assert "pip install casadi" in entry["reason"] and entry["warm"] is None
    assert "daqp: not installed" in solvers_text(result)
    assert "daqp" in SOLVERS


def test_qp_sequences_round_trip_through_files(tmp_path):
    sequence = box_sequence()
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

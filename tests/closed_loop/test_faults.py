# SPDX-License-Identifier: BSD-3-Clause
"""Short form of the fault matrix, and defects that its judge must detect."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path

import pytest
import surefoot
from faulty_supervisor import FAULTY_SUPERVISORS, FaultySupervisor
from surefoot import cli
from surefoot.faults import FaultSettings, choose_cells, run_faults
from surefoot.faults.catalogue import ROWS
from surefoot.faults.kinds.signal_faults import INJECTIONS
from surefoot.faults.matrix.matrix_setup import MatrixSetup, make_setup
from surefoot.faults.matrix.run_cell import run_cell
from surefoot.robot.loading import describe_robot

pytestmark = pytest.mark.slow

SHORT = (
    *("healthy/off/*", "nan_in_state/garbage/*", "stale_tick/stuck/*", "emergency_stop/wrong/*"),
    *("packet_loss/off/standing", "reordered_tick/intermittent/pushed", "tick_wrap/wrong/standing"),
    *("motor_order/wrong/lying", "foot_sensor/off/standing", "command_jump/wrong/standing"),
    *("operator_link/off/rising", "battery/wrong/lying"),
)


def test_short_fault_matrix_passes() -> None:
    result = run_faults(FaultSettings("go1", seed=1, only=SHORT))
    assert result["failures"] == []
    assert result["passed"] == len(result["cells"]) == len(choose_cells(SHORT))
    assert all(cell["simulated_s"] > 0.5 for cell in result["cells"])


def test_short_fault_matrix_passes_with_takeover_while_standing() -> None:
    only = ("healthy/*/pushed", "nan_in_state/garbage/*", "operator_link/off/*", "battery/wrong/*")
    result = run_faults(FaultSettings("b1", seed=1, only=only, taken_over=True))
    assert result["failures"] == []
    assert {cell["mode"] for cell in result["cells"]} == {"standing", "pushed", "walking"}
    # The robot stands from the start, so no rise takes time.
    assert all(cell["simulated_s"] < 15.0 for cell in result["cells"])
    assert {cell["ended"] for cell in result["cells"]} >= {"stand", "damping", "passive"}


def test_takeover_excludes_cells_that_precede_standing() -> None:
    assert len(choose_cells(taken_over=True)) < 0.65 * len(choose_cells())
    with pytest.raises(surefoot.Error, match="motor_order"):
        choose_cells(["motor_order/wrong/lying"], taken_over=True)


def test_two_processes_give_the_same_result_as_one() -> None:
    only = ("nan_in_state/garbage/lying", "emergency_stop/wrong/rising")
    alone, together = (run_faults(FaultSettings("go1", 1, jobs, only)) for jobs in (1, 2))
    assert alone == together


@cache
def setup() -> MatrixSetup:
    return make_setup(describe_robot("go1"), 0)


@cache
def reason_without_defect(cell: str) -> str:
    """Return why the judge fails a cell of a healthy supervisor; "" if it passes."""
    return str(run_cell(setup(), cell)["reason"])


@pytest.mark.parametrize("defect", FAULTY_SUPERVISORS)
def test_judge_detects_a_supervisor_that(defect: str) -> None:
    change, cell, words = FAULTY_SUPERVISORS[defect]
    healthy = setup()
    faulty = MatrixSetup(
        healthy.description,
        healthy.seed,
        healthy.lying_qpos,
        healthy.standing_height,
        lambda robot, options: FaultySupervisor(
            surefoot.Supervisor(robot, options=options), change
        ),
    )
    assert reason_without_defect(cell) == ""
    result = run_cell(faulty, cell)
    assert result["verdict"] == "fail"
    assert words in result["reason"]


def test_every_row_has_cells_with_unique_names() -> None:
    cells = choose_cells()
    assert len({cell.id for cell in cells}) == len(cells)
    assert {cell.row.id for cell in cells} == {row.id for row in ROWS}
    assert {cell.case.injection for cell in cells} == set(INJECTIONS)
    for cell in cells:
        assert choose_cells([cell.id]) == [cell]


def test_every_reported_fault_is_injected() -> None:
    expected = {cell.expectation.fault for cell in choose_cells()}
    expected |= {cell.expectation.alternative for cell in choose_cells()}
    missing = {info.name for info in surefoot.fault_table()} - expected
    # None of these can be injected alone. An angle beyond its stop is also a jump, a push may trip
    # the power protection first, a torque step follows from another fault, and only surefoot run
    # knows the state of the link.
    assert missing == {"tilt", "joint_stop", "torque_rate", "link"}


def test_faults_command_lists_cells_and_refuses_invalid_arguments(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert cli.main(["faults", "--list", "--only", "tick_wrap/*"]) == 0
    assert capsys.readouterr().out.count("tick_wrap/") == 10
    assert cli.main(["faults", "--only", "nothing_such"]) == 2
    assert "nan_in_state" in capsys.readouterr().err
    assert cli.main(["faults", "--jobs", "0"]) == 2
    assert cli.main(["faults", "--seed", "-1"]) == 2


def test_fault_matrix_resumes_from_its_store(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    only, store = ("emergency_stop/wrong/lying", "emergency_stop/wrong/rising"), tmp_path / "cells"
    one = run_faults(FaultSettings("go1", 1, 1, only[:1], str(store)))
    ran = []

    def counted(setup: MatrixSetup, name: str) -> dict[str, object]:
        ran.append(name)
        return run_cell(setup, name)

    monkeypatch.setattr("surefoot.faults.matrix.run_matrix.run_cell", counted)
    both = run_faults(FaultSettings("go1", 1, 1, only, str(store)))
    assert ran == [only[1]]
    assert both["cells"][0] == one["cells"][0] and both["passed"] == 2
    with pytest.raises(surefoot.Error, match="differs in seed"):
        run_faults(FaultSettings("go1", 2, 1, only, str(store)))


def test_faults_command_writes_json_and_report(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    place, folder = tmp_path / "faults.json", tmp_path / "report"
    words = ["faults", "--jobs", "1", "--only", "emergency_stop/wrong/lying"]
    assert cli.main([*words, "--json", str(place), "--report", str(folder)]) == 0
    result = json.loads(place.read_text())
    assert result["passed"] == 1 and result["failures"] == []
    assert result["cells"][0]["ended"] == "damping"
    assert {"robot", "seed", "versions", "command", "power_level"} <= set(result)
    page = (folder / "index.html").read_text()
    assert "emergency_stop" in page and "1 of 1" in page
    assert (folder / "times.png").is_file() and (folder / "summary.json").is_file()
    assert "1 of 1 cells passed" in capsys.readouterr().out


def test_failed_cell_sets_exit_status_4(monkeypatch: pytest.MonkeyPatch) -> None:
    def fails(setup: MatrixSetup, name: str) -> dict[str, object]:
        raise ValueError("broken")

    monkeypatch.setattr("surefoot.faults.matrix.run_matrix.run_cell", fails)
    assert cli.main(["faults", "--jobs", "1", "--only", "emergency_stop/wrong/lying"]) == 4

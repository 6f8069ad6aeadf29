# SPDX-License-Identifier: BSD-3-Clause
"""Scores from results: percentiles, worst directions, conditions, faults, references."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import surefoot
from surefoot.assess import AssessSettings, Condition, ControllerUnderTest, Scorecard, assess_text
from surefoot.assess.fault_unit import FaultUnit
from surefoot.assess.plan import planned_work, push_units
from surefoot.assess.push_limits import PushLimits
from surefoot.assess.push_outcome import PushOutcome
from surefoot.assess.push_score import low_percentile, statistic
from surefoot.assess.score import score
from surefoot.assess.scorecard import standard_scorecard
from surefoot.assess.sweep import outcome_rows, run_sweep
from surefoot.assess.work_units import PushUnit, StandUnit, run_unit

CARD = Scorecard(
    "mine",
    directions=4,
    seeds=20,
    condition_directions=2,
    condition_seeds=3,
    references=True,
    conditions=(
        Condition("usual"),
        Condition("icy", friction=0.2, pushes=True),
        Condition("slope", slope_deg=10.0, headings_deg=(0.0, 90.0)),
    ),
)
ROBOT = surefoot.load_robot("go1")
LIMITS = PushLimits(ROBOT)


def pushed(survives: float, strict: float) -> dict[str, Any]:
    done = run_sweep(lambda level: PushOutcome(level <= survives, level <= strict, 1.0, 1.0, 0.1))
    return {"rows": outcome_rows(done)}


def result_of(unit: PushUnit | StandUnit | FaultUnit) -> dict[str, Any]:
    """Return a result: seed 0 and direction 90 are worse, one stand and one fault cell fail."""
    if isinstance(unit, PushUnit):
        bad = 50.0 * (unit.seed == 0) + 10.0 * (unit.direction_deg == 90.0)
        return pushed(110.0 - bad, 80.0 - bad)
    if isinstance(unit, StandUnit):
        failed = unit.heading == 90.0 and unit.seed == 2
        good = {"stood": True, "tilt_deg": 0.1, "height_mm": 1.0, "foot_mm": 0.5, "passed": True}
        return {**good, "tilt_deg": 3.0, "passed": False} if failed else good
    if unit.cell == "healthy/off/standing":
        return {"row": "healthy", "verdict": "fail", "reason": "a false alarm"}
    return {"row": unit.cell.partition("/")[0], "verdict": "pass", "reason": ""}


@pytest.fixture(scope="module")
def card() -> dict[str, Any]:
    settings = AssessSettings("go1", card=CARD)
    results = {
        (w.controller_under_test.name, w.unit.key): result_of(w.unit)
        for w in planned_work(settings, LIMITS)
    }
    return score(settings, ROBOT, LIMITS, results)


def test_statistic_is_a_percentile_of_many_seeds_and_a_minimum_of_few() -> None:
    assert low_percentile([float(k) for k in range(20)]) == pytest.approx(0.95)
    assert low_percentile([3.0, 1.0, 2.0]) == 1.0
    assert statistic(20) == "5th percentile of 20 seeds"
    assert statistic(3) == "minimum of 3 seeds"


def test_summary_is_the_5th_percentile_of_the_worst_direction(card: dict[str, Any]) -> None:
    push = card["push"]
    expected = np.percentile([50.0, *[100.0] * 19], 5.0)
    assert push["survive_percent_of_limit_p5"] == pytest.approx(expected)
    assert push["strict_percent_of_limit_p5"] == pytest.approx(expected - 30.0)
    assert push["statistic"] == "5th percentile of 20 seeds"
    for row in push["tables"][0]["directions"]:
        impulse = row["survive"]["percent_of_limit"] / 100.0 * row["limit_ns"]
        assert row["survive"]["ns"] == pytest.approx(impulse, rel=1e-4)
        share = row["survive"]["percent_of_lip"] * row["lip_ns"]
        assert share == pytest.approx(100.0 * impulse, rel=1e-4)


def test_conditions_have_separate_limits_and_pass_counts(card: dict[str, Any]) -> None:
    usual, icy, slope = card["conditions"]
    assert usual["settings"] == {} and usual["stand"]["passed"] == 3 and usual["push"] is None
    assert icy["settings"]["friction"] == 0.2 and icy["push"]["statistic"] == "minimum of 3 seeds"
    limit = card["push"]["tables"][0]["directions"][0]["limit_ns"]
    assert icy["push"]["tables"][0]["directions"][0]["limit_ns"] < 0.7 * limit
    assert icy["push"]["survive_percent_of_limit_p5"] == 60.0
    assert slope["push"] is None
    stand = slope["stand"]
    assert (stand["runs"], stand["passed"], stand["stood"]) == (6, 5, 6)
    assert stand["tilt_deg"] == 3.0 and stand["headings_deg"]["0"]["tilt_deg"] == 0.1


def test_impulse_per_kilogram_uses_the_pushed_mass() -> None:
    for more in ({"mass_share": 0.2}, {"payload_share": 0.4}):
        conditions = (Condition("usual"), Condition("heavy", pushes=True, **more))
        few = Scorecard("few", directions=1, seeds=1, condition_seeds=1, conditions=conditions)
        settings = AssessSettings("go1", ControllerUnderTest("pd"), few)
        results = {
            (w.controller_under_test.name, w.unit.key): result_of(w.unit)
            for w in planned_work(settings, LIMITS)
        }
        filled = score(settings, ROBOT, LIMITS, results)
        mass = (1.0 + sum(more.values())) * filled["pinned_pose"]["mass_kg"]
        survived = filled["conditions"][1]["push"]["tables"][0]["directions"][0]["survive"]
        assert survived["ns_per_kg"] == pytest.approx(survived["ns"] / mass, rel=1e-4)


def test_scorecard_contains_faults_and_reference_controllers(card: dict[str, Any]) -> None:
    assert card["faults"]["failures"] == {"healthy/off/standing": "a false alarm"}
    assert card["faults"]["rows"]["healthy"]["failed"] == 1 and card["faults"]["passed"] > 100
    assert set(card["references"]) == {"pd", "force_qp"}
    assert card["references"]["pd"]["survive_percent_of_limit_p5"] > 90.0
    text = assess_text(card)
    assert "reference pd" in text and "a false alarm" in text and "5 of 6" in text


def test_reference_controllers_get_the_pushes_of_the_summary() -> None:
    usual = {"directions": 1, "seeds": 1, "faults": "none", "references": True}
    for lengths, main in (((0.02, 0.1), (0.1, 0.0)), ((0.5, 0.02), (0.5, 0.0))):
        settings = AssessSettings("go1", card=Scorecard("mine", lengths_s=lengths, **usual))
        asked = {
            (w.controller_under_test.name, w.unit.duration, w.unit.push_height)
            for w in planned_work(settings, LIMITS)
            if isinstance(w.unit, PushUnit)
        }
        assert {push[1:] for push in asked if push[0] != "surefoot"} == {main}


def test_broken_direction_survives_zero_and_reports_the_reason() -> None:
    few = Scorecard("mine", directions=2, seeds=2, condition_seeds=0, faults="none")
    settings = AssessSettings("go1", ControllerUnderTest("pd"), few)
    results = {
        (w.controller_under_test.name, w.unit.key): pushed(100.0, 90.0)
        for w in planned_work(settings, LIMITS)
    }
    results[next(iter(results))] = {"broken": "threw ValueError"}
    card = score(settings, ROBOT, LIMITS, results)
    first, second = card["push"]["tables"][0]["directions"]
    assert first["survive"]["ns"] == 0.0 and first["broken"] == ["threw ValueError"]
    assert second["survive"]["percent_of_limit"] == 100.0 and second["broken"] == []
    assert card["push"]["broken"] == ["threw ValueError"] and card["faults"] is None


def test_first_seed_selects_seeds_not_used_in_tuning() -> None:
    level = Condition("level ground")
    card = Scorecard("mine", seeds=2, condition_seeds=3, first_seed=100, conditions=(level,))
    units = [
        w.unit for w in planned_work(AssessSettings("go1", ControllerUnderTest("pd"), card), LIMITS)
    ]
    assert {u.seed for u in units if isinstance(u, PushUnit)} == {100, 101}
    assert {u.seed for u in units if isinstance(u, StandUnit)} == {100, 101, 102}
    assert [u.start_level for u in push_units(card, LIMITS)][:2] == [10.0, 20.0]


def test_full_scorecard_has_5244_units_and_fine_steps_for_its_summary() -> None:
    settings = AssessSettings("go1", card=standard_scorecard("full"))
    units = [w.unit for w in planned_work(settings, LIMITS)]
    pushed = [u for u in units if isinstance(u, PushUnit)]
    assert (len(units), len(pushed)) == (5244, 4640)  # as in docs/reference/scorecard.md
    assert all(
        (u.finest_step == 2.5) == ((u.duration, u.push_height) == (0.1, 0.0)) for u in pushed
    )
    assert {u.start_level for u in pushed} == {10.0, 20.0, 30.0, 40.0, 50.0, 60.0}


def test_text_reports_failures_under_conditions_and_references() -> None:
    settings = AssessSettings("go1", card=CARD)
    results = {
        (w.controller_under_test.name, w.unit.key): result_of(w.unit)
        for w in planned_work(settings, LIMITS)
    }
    for key in results:
        if "push | icy" in key[1] and key[1].endswith("| 2"):
            results[key]["broken"] = "threw OSError"
        if key[0] == "pd" and key[1].endswith("| 19"):
            results[key] = {"broken": "its process died"}
    card = score(settings, ROBOT, LIMITS, results)
    assert card["conditions"][1]["push"]["survive_percent_of_limit_p5"] == 60.0
    assert card["references"]["pd"]["broken"] == ["its process died"]
    text = assess_text(card)
    assert "  broken: threw OSError" in text and "  broken: its process died" in text
    assert "reference pd, 5th percentile of 20 seeds" in text
    assert "5th percentile of 20 seeds, in steps of 2.5 %" in text


def test_fault_matrix_cell_runs_as_a_unit() -> None:
    unit = FaultUnit("emergency_stop/wrong/lying")
    found = run_unit(unit, "go1", ControllerUnderTest("surefoot"))
    assert found == {"row": "emergency_stop", "verdict": "pass", "reason": ""}


def test_factory_with_delay_parameter_receives_the_delay() -> None:
    told: list[float] = []

    def factory_with_delay(robot: surefoot.Robot, delay: float) -> Any:
        told.append(delay)
        return surefoot.StandController(robot)

    for latency in (0.0, 1.6, 20.0):  # the plant delays by whole physics steps
        unit = StandUnit(Condition("late", latency_ms=latency, quiet_s=0.1), 0.0, 1)
        run_unit(unit, "go1", ControllerUnderTest("factory_with_delay", factory=factory_with_delay))
    np.testing.assert_allclose(told, [0.004, 0.006, 0.024])

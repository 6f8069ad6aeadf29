# SPDX-License-Identifier: BSD-3-Clause
"""surefoot tune design: textbook loops, refused goals and output files."""

from __future__ import annotations

import functools
import json
import math
import shlex
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import surefoot

pytest.importorskip("casadi")

from surefoot.cli import main
from surefoot.robot.description import describe_robot
from surefoot.tune.design import (
    AXES,
    ClosedLoop,
    Design,
    DesignSettings,
    Direction,
    Goal,
    Observers,
    StandingBody,
    Timing,
    compute_standing_body,
    delay_margin,
    design_gains,
    gain_margins,
    max_stable_frequency,
    oscillation_boundary,
    parse_goal,
    unstable_goal,
)
from surefoot.tune.design.closed_loop import load_casadi
from surefoot.tune.design.loop_model import Tick
from surefoot.tune.design.margins import MAX_GAIN_FACTOR
from surefoot.tune.design.stability_search import last_stable

pytestmark = pytest.mark.slow

NO_LIMITS = np.array([[-1e6, -1e6], [0.0, 0.0], [1e6, 1e6]])
FRICTIONLESS_Z = Direction("z", False, 1.0, 0.0, 0.0, 1.0, 1.0, NO_LIMITS, 0.3)
FRICTIONLESS_YAW = replace(FRICTIONLESS_Z, name="yaw", rotates=True)
PUSH_OBSERVER_OFF = Observers(1e6, 0.016, 0.5, 0.0, 1.0)
PUSH_OBSERVER_ON = Observers(0.15, 0.016, 0.5, 20.0, 1.0)
FAST_TIMING = Timing(rate=2000.0, motor_lag=0.0)  # 1 ms from sample to torque


@functools.cache
def body(robot: str = "go1") -> StandingBody:
    return compute_standing_body(describe_robot(robot))


def continuous_delay_margin(goal: Goal) -> float:
    """Return the delay margin of (kp + kd s) / s^2: phase margin / crossover frequency [s]."""
    kp, kd = goal.kp, goal.kd
    w = math.sqrt((kd**2 + math.sqrt(kd**4 + 4.0 * kp**2)) / 2.0)
    return math.atan2(kd * w, kp) / w


@pytest.mark.parametrize(("frequency", "damping"), [(1.0, 0.4), (2.5, 0.8), (4.0, 0.6)])
def test_poles_match_the_goal_without_delay(frequency: float, damping: float) -> None:
    goal = Goal(frequency, damping)
    loop = ClosedLoop(FRICTIONLESS_Z, FAST_TIMING, PUSH_OBSERVER_OFF)
    s = (
        np.log(np.linalg.eigvals(loop.state_matrix(goal.kp, goal.kd)).astype(complex) + 1e-30)
        * FAST_TIMING.rate
    )
    wn = 2.0 * math.pi * frequency
    wanted = wn * complex(-damping, math.sqrt(1.0 - damping**2))
    # The sampled loop has 1.25 ms of delay, which moves the poles slightly.
    assert np.abs(s - wanted).min() < 0.05 * wn


@pytest.mark.parametrize("goal", [Goal(2.0, 0.4), Goal(2.5, 0.8), Goal(5.0, 0.7)])
def test_the_delay_margin_is_phase_margin_over_crossover(goal: Goal) -> None:
    loop = ClosedLoop(FRICTIONLESS_Z, FAST_TIMING, PUSH_OBSERVER_OFF)
    own = 2.5 * FAST_TIMING.period  # one period each way, half a period of zero-order hold
    expected = continuous_delay_margin(goal) - own
    assert delay_margin(loop, goal.kp, goal.kd) == pytest.approx(expected, abs=0.0003)


def test_gain_margin_matches_the_delayed_derivative_loop() -> None:
    # The loop kd exp(-j w T) / (j w) with T = 2.5 periods is unstable for kd >= pi / (2 T).
    timing = Timing(rate=500.0, motor_lag=0.0)
    loop = ClosedLoop(FRICTIONLESS_Z, timing, PUSH_OBSERVER_OFF)
    kd = 20.0
    down, up = gain_margins(loop, 1e-3, kd)
    assert up * kd == pytest.approx(math.pi / (2.0 * 2.5 * timing.period), rel=0.02)
    assert down == 0.0


def test_gyroscope_averaging_costs_half_a_period_of_delay_margin() -> None:
    goal = Goal(2.0, 0.8)
    straight = delay_margin(
        ClosedLoop(FRICTIONLESS_Z, Timing(), PUSH_OBSERVER_OFF), goal.kp, goal.kd
    )
    turning = delay_margin(
        ClosedLoop(FRICTIONLESS_YAW, Timing(), PUSH_OBSERVER_OFF), goal.kp, goal.kd
    )
    assert 0.0005 < straight - turning < 0.0015


def test_a_delay_between_two_steps_is_between_their_margins() -> None:
    goal = Goal(3.0, 0.8)
    found = [
        gain_margins(
            ClosedLoop(FRICTIONLESS_Z, Timing(delay=delay), PUSH_OBSERVER_OFF), goal.kp, goal.kd
        )[1]
        for delay in (0.004, 0.0041, 0.00425, 0.0049, 0.005)
    ]
    assert found == sorted(found, reverse=True)
    assert found[0] > found[-1]


def test_oscillation_boundary_equals_the_gain_margin_without_friction() -> None:
    goal = Goal(2.5, 0.8)
    loop = ClosedLoop(FRICTIONLESS_Z, Timing(delay=0.008), PUSH_OBSERVER_OFF)
    up = gain_margins(loop, goal.kp, goal.kd)[1]
    assert oscillation_boundary(loop, goal.kp, goal.kd) == pytest.approx(up, rel=0.05)


def test_friction_raises_and_push_observer_lowers_the_boundary() -> None:
    kp, kd = Goal(2.5, 0.8).kp, Goal(2.5, 0.8).kd
    timing = Timing(delay=0.008)
    limited = replace(FRICTIONLESS_Z, limits=np.array([[-8.0, -8.0], [0.0, 0.0], [8.0, 8.0]]))
    plain = oscillation_boundary(ClosedLoop(limited, timing, PUSH_OBSERVER_OFF), kp, kd)
    rubbing = oscillation_boundary(
        ClosedLoop(replace(limited, friction=0.5), timing, PUSH_OBSERVER_OFF), kp, kd
    )
    pushed = oscillation_boundary(ClosedLoop(limited, timing, PUSH_OBSERVER_ON), kp, kd)
    assert pushed < 0.7 * plain < plain < rubbing


@pytest.mark.parametrize("robot", ["a1", "go1", "go2", "b1"])
def test_measured_directions_match_the_robot_model(robot: str) -> None:
    directions = body(robot).directions
    for name in ("x", "y", "z"):
        assert 1.0 < directions[name].inertia / body(robot).robot.mass < 1.4
        assert 1.0 < directions[name].base_motion_ratio < 1.2
    # The hold-down limits the downward acceleration: it keeps hold_down of the weight on each foot.
    # On b1 the height task outweighs the hold-down penalty away from the edge, so feet carry less.
    # The desired acceleration is limited too: the feet keep edge_load - 0.35 of the weight.
    gains = body(robot).robot.config.gains
    held = 9.81 * min(1.0 - 4.0 * gains.hold_down, 1.35 - gains.edge_load)
    limits = directions["z"].limits
    falls = -np.interp(-10.0, limits[:, 0], limits[:, 1])
    assert held < falls < 9.81 if robot == "b1" else falls == pytest.approx(held, rel=0.01)
    for direction in directions.values():
        assert np.all(np.diff(direction.limits[:, 1]) >= 0.0)
        small = 0.1 * direction.limits[-1, 0] / 4.0
        given = np.interp(small, direction.limits[:, 0], direction.limits[:, 1])
        assert given == pytest.approx(small, rel=0.05)


@pytest.mark.parametrize("axis", AXES)
def test_reported_pole_is_not_an_observer_pole(axis: str) -> None:
    goals = {axis: Goal(2.5, 0.8)}
    design = design_gains(DesignSettings(describe_robot("a1"), goals, Timing(delay=0.012)))
    margins = next(each for each in design.axes if each.name == axis).margins
    # Delay raises the frequency of the pole and, up to a point, its damping.
    assert 2.5 < margins.pole_frequency < 5.0
    assert 0.7 < margins.pole_damping < 1.0


@pytest.mark.parametrize("band", [0.1, 0.5])
def test_push_time_share_matches_the_estimator(band: float) -> None:
    # tests/cpp/test_external_wrench.cpp has the same table: size in dead bands, share of push_time.
    shares = {2.9: 1.0, 3.5: 1.0 / 1.5, 4.0: 0.5, 5.0: 0.375, 20.0: 0.375}
    casadi = load_casadi()
    tick = Tick(
        casadi,
        replace(FRICTIONLESS_Z, name="x"),
        Timing(),
        replace(PUSH_OBSERVER_ON, push_dead_band=band),
    )
    for size, share in shares.items():
        for sign in (1.0, -1.0):
            found, surprised = tick._push_time_ratio(casadi.DM(sign * size * band), 0.0)
            assert float(found) == pytest.approx(share)
            assert float(surprised) == (pytest.approx(0.002) if size > 3.0 else 0.0)
    assert float(tick._push_time_ratio(casadi.DM(5.0 * band), 0.0495)[0]) == 1.0


def test_greatest_frequency_lies_on_the_stability_boundary() -> None:
    direction, timing = body().directions["pitch"], Timing(delay=0.01)
    observers = Observers.of(body().robot.config.gains)
    greatest = max_stable_frequency(direction, timing, observers, 0.8)
    loop = ClosedLoop(direction, timing, observers)
    goal = Goal(greatest, 0.8)
    bound = min(
        gain_margins(loop, goal.kp, goal.kd)[1], oscillation_boundary(loop, goal.kp, goal.kd)
    )
    assert bound == pytest.approx(1.0, abs=0.05)


def test_gains_without_a_goal_are_unchanged() -> None:
    design = design_gains(DesignSettings(describe_robot("go1"), {"sway": Goal(1.5, 0.9)}))
    own = body().robot.config.gains
    assert design.gains.com_kp_horizontal == pytest.approx((2.0 * math.pi * 1.5) ** 2)
    assert design.gains.com_kd_horizontal == pytest.approx(4.0 * math.pi * 0.9 * 1.5)
    assert design.gains.base_kp_tilt == own.base_kp_tilt
    assert [axis.uses_robot_gains for axis in design.axes] == [name != "sway" for name in AXES]


def test_higher_imu_trust_lowers_the_boundary() -> None:
    goals = {"height": Goal(2.0, 0.8)}
    settings = DesignSettings(describe_robot("go1"), goals, Timing(delay=0.006))
    found = {}
    for trust in (0.5, 2.0):
        design = design_gains(replace(settings, trust_imu=trust))
        found[trust] = next(a for a in design.axes if a.name == "height").margins.boundary
        assert design.gains.push_time == pytest.approx(body().robot.config.gains.push_time / trust)
    assert found[0.5] > found[2.0]


def test_design_measures_the_qp_with_the_start_gains(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file, boundary = tmp_path / "held.toml", {}
    words = "--height 2:0.8 --delay-ms 4 --json -".split()
    for hold_down in (body().robot.config.gains.hold_down, 0.2):
        file.write_text(f"hold_down = {hold_down}\n")
        assert run_cli(*words, "--gains", str(file)) == 0
        boundary[hold_down] = json.loads(capsys.readouterr().out)["axes"]["height"]["boundary"]
    usual, held = boundary.values()
    # With a hold-down of 4/5 of the weight, the body falls with g / 5 at most.
    assert usual == pytest.approx(6.46, rel=0.02)
    assert held == pytest.approx(13.18, rel=0.02)


def run_cli(*words: str) -> int:
    return main(["tune", "design", *words])


def test_written_gains_match_the_printed_gains(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file, numbers = tmp_path / "my gains.toml", tmp_path / "design.json"
    words = "--robot go1 --bandwidth 2.5 --damping 0.8 --delay-ms 4 --attitude 4:0.7".split()
    assert run_cli(*words, "--toml", str(file), "--json", str(numbers)) == 0
    shown, summary = capsys.readouterr().out, json.loads(numbers.read_text())
    command = shlex.join(["surefoot", "tune", "design", *words, "--toml", str(file)])
    assert command in file.read_text()
    gains = surefoot.load_gains(file, body().robot.config.gains)
    for axis, (kp, kd, _) in AXES.items():
        assert getattr(gains, kp) == pytest.approx(summary["axes"][axis]["kp"], rel=1e-12)
        assert getattr(gains, kd) == pytest.approx(summary["axes"][axis]["kd"], rel=1e-12)
        assert f"{summary['axes'][axis]['boundary']:.2f}" in shown
    assert gains.base_kp_tilt == pytest.approx((8.0 * math.pi) ** 2)
    assert gains.foot_kp == body().robot.config.gains.foot_kp


@pytest.mark.parametrize("delay", ["11", "12", "13", "14", "15", "16"])
def test_unstable_goal_is_refused_with_the_highest_stable_frequency(
    delay: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "gains.toml"
    assert run_cli("--height", "6", "--delay-ms", delay, "--toml", str(file)) == 2
    lines = capsys.readouterr().err.splitlines()
    assert len(lines) == 1 and "height" in lines[0] and f"{delay} ms" in lines[0]
    assert not file.exists()
    # Use the printed text: a user who enters it must not be refused again.
    greatest = lines[0].split("at most ")[1].split(" Hz")[0]
    assert 1.0 < float(greatest) < 6.0
    assert run_cli("--height", greatest, "--delay-ms", delay) == 0
    assert "warning: height" in capsys.readouterr().out


def test_reported_greatest_frequency_is_stable() -> None:
    limit = 4.87654
    low, high = last_stable(lambda f: f > limit, 0.2, 40.0)
    assert low <= limit < high <= 1.01 * low
    assert last_stable(lambda f: False, 0.2, 40.0) == (40.0, 40.0)


@pytest.mark.parametrize(
    ("asked", "greatest", "said"),
    [
        (6.0, 4.8799, "; expected at most 4.87 Hz at this damping"),
        (0.1, 4.8799, "; expected 0.2 .. 4.87 Hz at this damping"),  # the goal is too slow
        (6.0, 0.0, "; no frequency from 0.2 Hz up is stable at this damping"),
    ],
)
def test_refusal_rounds_the_stable_frequency_down(
    asked: float, greatest: float, said: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(unstable_goal, "max_stable_frequency", lambda *_: greatest)
    line = unstable_goal.unstable_goal_text(
        "height: ", Goal(asked, 0.8), Timing(), [FRICTIONLESS_Z], PUSH_OBSERVER_OFF
    )
    assert line.startswith("height: ") and line.endswith(said)


def test_delay_and_rate_limits_keep_the_margin_search_finite() -> None:
    # 0.2 s at 500 Hz is the longest delay allowed; the search adds up to 0.1 s to it.
    slow = ClosedLoop(FRICTIONLESS_Z, Timing(delay=0.2), PUSH_OBSERVER_OFF)
    assert delay_margin(slow, Goal(0.1, 0.8).kp, Goal(0.1, 0.8).kd) == pytest.approx(0.1)
    fast = Timing(rate=10_000.0, delay=0.01)
    assert fast.max_extra_delay == pytest.approx(50 / 10_000.0)
    loop = ClosedLoop(FRICTIONLESS_Z, fast, PUSH_OBSERVER_OFF)
    assert delay_margin(loop, Goal(1.0, 0.8).kp, Goal(1.0, 0.8).kd) == fast.max_extra_delay
    settings = DesignSettings(describe_robot("go1"), {"height": Goal(2.0, 0.8)})
    for timing in (Timing(delay=0.25), Timing(rate=10_000.0, delay=0.012)):
        with pytest.raises(surefoot.Error, match="additional delay: got"):
            design_gains(replace(settings, timing=timing))


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ([], "no frequency"),
        (["--bandwidth", "fast"], "FREQ[:DAMPING]"),
        (["--bandwidth", "2:0.7:1"], "FREQ[:DAMPING]"),
        (["--bandwidth", "0"], "--bandwidth: got 0 Hz, expected 0.01 .. 7.1 Hz"),
        (["--bandwidth", "nan"], "--bandwidth: got nan Hz, expected 0.01 .. 7.1 Hz"),
        (["--bandwidth", "1e300"], "--bandwidth: got 1e+300 Hz, expected 0.01 .. 7.1 Hz"),
        (["--sway", "1e-300:0.8"], "--sway: got 1e-300 Hz, expected 0.01 .. 7.1 Hz"),
        (["--bandwidth", "2", "--damping", "-1"], "above 0"),
        (["--bandwidth", "9"], "--bandwidth: got 9 Hz, expected 0.01 .. 7.1 Hz"),
        (["--bandwidth", "2", "--delay-ms", "-1"], "--delay-ms: got -1 ms, expected 0 .. 200 ms"),
        (["--bandwidth", "2", "--delay-ms", "201"], "--delay-ms: got 201 ms, expected 0 .. 200 ms"),
        (["--bandwidth", "0.3", "--delay-ms", "150"], "no frequency from 0.2 Hz up is stable"),
        (["--bandwidth", "2", "--rate", "0"], "--rate: got 0 Hz, expected 10 .. 10000 Hz"),
        (
            ["--bandwidth", "2", "--rate", "10000", "--delay-ms", "20"],
            "--delay-ms: got 20 ms at --rate 10000 Hz, which are 200 periods, expected at most 100",
        ),
        (
            ["--bandwidth", "2", "--motor-lag-ms", "nan"],
            "--motor-lag-ms: got nan ms, expected 0 .. 100 ms",
        ),
        (
            ["--bandwidth", "2", "--joint-friction-scale", "nan"],
            "--joint-friction-scale: got nan, expected 0 .. 10",
        ),
        (
            ["--bandwidth", "2", "--joint-friction-scale", "-1"],
            "--joint-friction-scale: got -1, expected 0 .. 10",
        ),
        (["--bandwidth", "2", "--trust-imu", "0"], "trust_imu"),
        (["--bandwidth", "2", "--robot", "dog"], "unknown robot"),
        (["--bandwidth", "2", "--toml", "/nowhere/g.toml"], "--toml"),
    ],
)
def test_invalid_tune_design_arguments_give_one_error_line(
    words: list[str], said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run_cli(*words) == 2
    lines = capsys.readouterr().err.splitlines()
    assert len(lines) == 1 and said in lines[0]


def test_missing_casadi_error_names_the_install_command(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(sys.modules, "casadi", None)
    assert run_cli("--bandwidth", "2") == 2
    assert "pip install surefoot[tune]" in capsys.readouterr().err


def test_goal_uses_its_own_or_the_common_damping() -> None:
    assert parse_goal("--sway", "2", 0.8) == Goal(2.0, 0.8)
    assert parse_goal("--sway", "2:1.1", 0.8) == Goal(2.0, 1.1)


def test_margins_beyond_the_search_limit_are_not_drawn() -> None:
    pytest.importorskip("matplotlib")
    from surefoot.tune.design.plots import draw_poles, draw_responses

    design = design_gains(DesignSettings(describe_robot("go1"), {"height": Goal(2.0, 0.8)}))
    beyond, *others = design.axes
    margins = replace(beyond.margins, boundary=MAX_GAIN_FACTOR, gain_up=MAX_GAIN_FACTOR)
    design = replace(design, axes=[replace(beyond, margins=margins), *others])
    for draw, kinds in ((draw_responses, 3), (draw_poles, 2)):
        figure = draw(design)
        shown = [len(ax.get_legend_handles_labels()[1]) for ax in figure.axes]
        assert shown == [1, kinds, kinds, kinds]
        # The legend covers all four plots; the first plot has only one kind of curve.
        assert len(figure.legends[0].get_texts()) == kinds


def test_delay_map_ends_at_the_longest_allowed_delay(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    pytest.importorskip("matplotlib")
    from surefoot.tune.design import stability_maps

    design = design_gains(DesignSettings(describe_robot("go1"), {"height": Goal(2.0, 0.8)}))
    seen: list[float] = []

    def greatest(design: Design, axis: object, delay: float, damping: float) -> tuple[float, float]:
        seen.append(replace(design.settings.timing, delay=delay).delay)
        return 1.0, 2.0

    monkeypatch.setattr(stability_maps, "_max_frequencies", greatest)
    for rate, longest in ((500.0, 0.03), (10_000.0, 0.01)):
        settings = replace(design.settings, timing=Timing(rate=rate))
        stability_maps.draw_delay_map(replace(design, settings=settings))
        assert seen[-1] == pytest.approx(longest)


def test_design_report_contains_maps_and_summary(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    folder = tmp_path / "report"
    assert run_cli("--bandwidth", "2", "--report", str(folder)) == 0
    page = (folder / "index.html").read_text()
    for name in ("delay_map.png", "damping_map.png", "responses.png", "poles.png"):
        assert name in page and (folder / name).stat().st_size > 10_000
    assert json.loads((folder / "summary.json").read_text())["robot"] == "go1"

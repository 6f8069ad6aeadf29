"""Text and JSON summary of a design."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

from surefoot.tune.design.directions import AXES
from surefoot.tune.design.gain_design import AxisDesign, Design
from surefoot.tune.design.margins import MAX_GAIN_FACTOR, Margins
from surefoot.tune.design.settings import IMU_NOISE_GAINS, LEG_NOISE_GAINS

_HEADER = f"{'':9} {'f':>6} {'zeta':>5} {'kp':>8} {'kd':>7}  {'pole':>12}"
_MARGIN_HEADER = f"{'gain':>7} {'delay':>9}   {'gain':>7} {'delay':>9}"


def design_text(design: Design) -> str:
    """Return gains and margins as a table, followed by warnings."""
    timing = design.settings.timing
    lines = [
        f"{design.body.robot.name}: {timing.rate:g} Hz, {1000.0 * timing.delay:g} ms of additional "
        f"delay, motor lag {1000.0 * timing.motor_lag:g} ms",
        f"{'':56}  {'at rest':^17}   {'after a push':^17}",
        f"{_HEADER}  {_MARGIN_HEADER}",
        f"{'':9} {'Hz':>6} {'':>5} {'1/s^2':>8} {'1/s':>7}  {'Hz, damping':>12}  "
        f"{'x':>7} {'ms':>9}   {'x':>7} {'ms':>9}",
    ]
    lines += [_row(axis, timing.max_extra_delay) for axis in design.axes]
    if any(axis.uses_robot_gains for axis in design.axes):
        lines.append("* the robot's own gains")
    lines += [f"warning: {text}" for text in design.warnings]
    return "\n".join(lines)


def design_summary(design: Design) -> dict[str, Any]:
    """Return a design as JSON values; frequencies in Hz, times in s."""
    settings = design.settings
    return {
        "robot": design.body.robot.name,
        "rate_hz": settings.timing.rate,
        "delay_s": settings.timing.delay,
        "motor_lag_s": settings.timing.motor_lag,
        "trust_imu": settings.trust_imu,
        "trust_legs": settings.trust_legs,
        "joint_friction_scale": settings.joint_friction_scale,
        "axes": {axis.name: _axis_summary(axis) for axis in design.axes},
        "gains": {name: getattr(design.gains, name) for name in _designed_gain_names(design)},
        "warnings": design.warnings,
    }


def _row(axis: AxisDesign, max_extra_delay: float) -> str:
    goal, m = axis.goal, axis.margins
    name = axis.name + ("*" if axis.uses_robot_gains else "")
    pole = f"{m.pole_frequency:.2f}, {m.pole_damping:.2f}"
    return (
        f"{name:9} {goal.frequency:6.2f} {goal.damping:5.2f} {goal.kp:8.1f} {goal.kd:7.2f}  "
        f"{pole:>12}  {_factor(m.gain_up)} {_delay(m.delay, max_extra_delay)}   "
        f"{_factor(m.boundary)} {_delay(m.push_delay, max_extra_delay)}"
    )


def _factor(value: float) -> str:
    return f"{f'>{MAX_GAIN_FACTOR:g}' if value >= MAX_GAIN_FACTOR else f'{value:.2f}':>7}"


def _delay(value: float, max_extra_delay: float) -> str:
    most = f">{1000.0 * max_extra_delay:.3g}"
    return f"{most if value >= max_extra_delay else f'{1000.0 * value:.1f}':>9}"


def _axis_summary(axis: AxisDesign) -> dict[str, Any]:
    return {
        "frequency_hz": axis.goal.frequency,
        "damping": axis.goal.damping,
        "kp": axis.goal.kp,
        "kd": axis.goal.kd,
        "own_gains": axis.uses_robot_gains,
        "direction": axis.direction,
        **_margin_summary(axis.margins),
        "directions": {name: _margin_summary(m) for name, m in axis.directions.items()},
    }


def _margin_summary(margins: Margins) -> dict[str, Any]:
    names = {
        "pole_frequency": "pole_frequency_hz",
        "pole_damping": "pole_damping",
        "spectral_radius": "spectral_radius",
        "gain_up": "gain_margin",
        "gain_down": "gain_margin_down",
        "delay": "delay_margin_s",
        "boundary": "boundary",
        "push_delay": "boundary_delay_s",
    }
    values = asdict(margins)
    return {names[name]: values[name] for name in values}


def _designed_gain_names(design: Design) -> list[str]:
    """Return the names of the gains of all axes, and of the noise gains changed by the design."""
    own = design.settings.start or design.body.robot.config.gains
    axis_gains = [name for kp, kd, _ in AXES.values() for name in (kp, kd)]
    noise_gains = (*IMU_NOISE_GAINS, *LEG_NOISE_GAINS)
    return axis_gains + [n for n in noise_gains if getattr(design.gains, n) != getattr(own, n)]

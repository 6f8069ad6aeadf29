"""Search space: frequencies and damping ratios of the tasks, and gains by name."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from surefoot._core import Error, Gains, gain_table, get_gain, set_gain
from surefoot.robot.robot_toml import suggest

TWO_PI = 2.0 * math.pi

# Tasks whose gains the search describes by frequency and damping ratio. In terms of kp and kd, the
# good values form a narrow curved valley, in which a sampler works badly.
TASK_GAINS = {
    "sway": ("com_kp_horizontal", "com_kd_horizontal"),
    "height": ("com_kp_vertical", "com_kd_vertical"),
    "tilt": ("base_kp_tilt", "base_kd_tilt"),
    "yaw": ("base_kp_yaw", "base_kd_yaw"),
    "foot": ("foot_kp", "foot_kd"),
}
# Chosen ranges, widened if the initial value is outside (docs/how-to/tune-with-a-search.md). Upper
# ends: below the largest gains, 7.1 Hz for kp = 2000 1/s^2 (foot: larger).
FREQUENCY_RANGE = 0.3, 6.0  # [Hz] natural frequency of the body's tasks
FOOT_FREQUENCY_RANGE = 1.0, 11.0  # [Hz] natural frequency of the foot task
DAMPING_RANGE = 0.2, 2.5  # damping ratio of all tasks


@dataclass(frozen=True)
class Parameter:
    """One parameter of the search, on a logarithmic scale.

    Attributes:
        name: "sway_frequency", "sway_damping" ..., or the name of a gain.
        low: Smallest value, above 0.
        high: Largest value.
        unit: Unit of the value.
    """

    name: str
    low: float
    high: float
    unit: str

    def get(self, gains: Gains) -> float:
        """Return the value of this parameter in `gains`, clamped to the range."""
        pair = task_gains(self.name)
        if pair is None:
            value = get_gain(gains, self.name)
        else:
            kp, kd = (get_gain(gains, name) for name in pair)
            rate = math.sqrt(max(kp, 1e-9))
            value = rate / TWO_PI if self.name.endswith("_frequency") else kd / (2.0 * rate)
        return min(max(value, self.low), self.high)


def task_gains(name: str) -> tuple[str, str] | None:
    """Return the names of the stiffness and damping gains that a task's parameter sets.

    None: the parameter is a gain.
    """
    task, _, what = name.rpartition("_")
    return TASK_GAINS.get(task) if what in ("frequency", "damping") else None


def include_start(parameter: Parameter, start: Gains) -> Parameter:
    """Return the parameter, with its range widened to include its value in the start gains.

    Raises:
        Error: The start value is 0, which a logarithmic scale does not have.
    """
    value = replace(parameter, low=0.0, high=math.inf).get(start)
    if not value > 1e-4:
        raise Error(
            f"gain: got start value {value:g} of {parameter.name}, expected above 0 for the "
            "logarithmic scale; use another start value, or search another gain"
        )
    return replace(parameter, low=min(parameter.low, value), high=max(parameter.high, value))


def default_space() -> list[Parameter]:
    """Return frequency and damping ratio of the five tasks as parameters."""
    space = []
    for task in TASK_GAINS:
        low, high = FOOT_FREQUENCY_RANGE if task == "foot" else FREQUENCY_RANGE
        space.append(Parameter(f"{task}_frequency", low, high, "Hz"))
        space.append(Parameter(f"{task}_damping", *DAMPING_RANGE, "1"))
    return space


# Gains of a walk that shape gait and swing. Limits of speed and acceleration are not among them:
# they say what the robot should do. Chosen ranges: outside them a trot falls or its feet drag.
_WALK_RANGES = {
    "gait_period": (1.6, 3.2),
    "gait_duty": (0.45, 0.65),
    "gait_stance_travel": (0.5, 1.3),
    "gait_swing_speed": (0.6, 1.6),
    "foothold_feedback": (0.4, 1.1),
    "swing_height": (0.08, 0.3),
    "swing_landing_speed": (0.05, 0.35),
    "walk_joint_limit_rate": (40.0, 200.0),
}


def walk_space() -> list[Parameter]:
    """Return the gains of a walk that shape gait and swing as parameters."""
    units = {info.name: info.unit for info in gain_table()}
    return [Parameter(name, *span, units[name]) for name, span in _WALK_RANGES.items()]


def parse_parameter(text: str) -> Parameter:
    """Parse NAME or NAME=LOW:HIGH. NAME is a task's frequency or damping, or a gain.

    Raises:
        Error: The name is unknown, or the range is not positive or not within the gain's range.
    """
    name, _, span = text.partition("=")
    known = {parameter.name: parameter for parameter in default_space()}
    suggested = {parameter.name: parameter for parameter in walk_space()}
    infos = {info.name: info for info in gain_table()}
    if name in known:
        low, high, unit = known[name].low, known[name].high, known[name].unit
    elif name in suggested:
        low, high, unit = suggested[name].low, suggested[name].high, suggested[name].unit
    elif name in infos:
        info = infos[name]
        default = info.default or info.maximum
        low, high = max(info.minimum, 0.1 * default), min(info.maximum, 10.0 * default)
        unit = info.unit
    else:
        names = [*known, *infos]
        raise Error(f"gain: got '{name}'{suggest(name, names)}; valid names: {', '.join(names)}")
    if span:
        low, high = _parse_range(name, span, infos[name] if name in infos else known[name])
    return Parameter(name, low, high, unit)


def _parse_range(name: str, span: str, limits: object) -> tuple[float, float]:
    least = getattr(limits, "minimum", getattr(limits, "low", 0.0))
    most = getattr(limits, "maximum", getattr(limits, "high", math.inf))
    try:
        low, high = (float(part) for part in span.split(":"))
    except ValueError:
        raise Error(f"gain: got '{name}={span}', expected {name}=LOW:HIGH") from None
    if not (0.0 < low < high and least <= low and high <= most):
        raise Error(
            f"gain: got '{name}={span}', expected 0 < LOW < HIGH within {least:g} .. {most:g}"
        )
    return low, high


def apply_parameters(values: dict[str, float], start: Gains) -> Gains:
    """Return `start`, changed to the values of a trial (parameter name to value).

    Raises:
        Error: A gain is out of its range.
    """
    gains = start.__copy__()
    for name, value in values.items():
        if name in {info.name for info in gain_table()}:
            set_gain(gains, name, value)
    for task, (kp, kd) in TASK_GAINS.items():
        frequency, damping = values.get(f"{task}_frequency"), values.get(f"{task}_damping")
        if frequency is None and damping is None:
            continue
        rate = TWO_PI * frequency if frequency is not None else math.sqrt(get_gain(start, kp))
        if damping is None:
            damping = get_gain(start, kd) / (2.0 * math.sqrt(max(get_gain(start, kp), 1e-9)))
        set_gain(gains, kp, rate**2)
        set_gain(gains, kd, 2.0 * damping * rate)
    gains.validate()
    return gains

"""Invalid options and gains: the supervisor must refuse each of them and name it in the error."""

from __future__ import annotations

from collections.abc import Callable

from surefoot._core import Error, Gains, Robot, Supervisor, SupervisorOptions
from surefoot.faults.kinds.fault import Fault


class InvalidConfig(Fault):
    """An operator constructs supervisors with invalid options and gains, once at the onset."""

    def __init__(self) -> None:
        self._robot: Robot | None = None
        self._problems: list[str] = []

    def assumed_robot(self, robot: Robot) -> Robot:
        """Store the robot model and return it unchanged."""
        self._robot = robot
        return robot

    def operate(self, supervisor: Supervisor, k: int) -> None:
        """Construct the supervisors once; each error must name the invalid option or gain."""
        robot = self._robot
        if k or robot is None:
            return
        attempts: dict[str, Callable[[], object]] = {
            "power_level": lambda: Supervisor(robot, options=SupervisorOptions(power_level=11)),
            "arming_time": lambda: Supervisor(robot, options=SupervisorOptions(arming_time=-1.0)),
            "temperature_warning": lambda: Supervisor(
                robot, options=SupervisorOptions(temperature_warning=float("nan"))
            ),
            "damping_kd": lambda: Supervisor(robot, gains=_gains(damping_kd=float("nan"))),
            "slip_friction": lambda: Supervisor(robot, gains=_gains(slip_friction=-1.0)),
        }
        for name, attempt in attempts.items():
            try:
                attempt()
            except Error as refusal:
                if name not in str(refusal):
                    self._problems.append(f"{name}: the error does not name it: {refusal}")
            else:
                self._problems.append(f"{name}: accepted")

    def problems(self) -> list[str]:
        """Return the invalid values that were accepted, or whose error does not name them."""
        return self._problems


def _gains(**values: float) -> Gains:
    gains = Gains()
    for name, value in values.items():
        setattr(gains, name, value)
    return gains

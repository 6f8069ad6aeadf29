"""Settings that the runs of all simulated controllers have in common."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from surefoot._core import ControllerOptions, Error, Gains, QpForm
from surefoot.robot.description import RobotDescription
from surefoot.sim import PlantSettings
from surefoot.stand.push_request import PushRequest
from surefoot.stand.reference_request import ReferenceRequest

# [s] Longest run. Derived from the memory: the log of such a run at 500 Hz takes about 1 GB.
MAX_DURATION = 600.0


@dataclass(frozen=True)
class SimulationSettings:
    """Settings of a simulated run: robot, plant, pushes and options of the controller's tick.

    Equal settings give equal runs.

    Attributes:
        robot: A name of surefoot.available_robots(), or a description from describe_robot().
        duration: Duration of the run [s]; a fall ends the run earlier.
        plant: Sensors, ground, payload, control rate and seed. The control period must be a whole
            number of milliseconds, the unit of LowState.tick.
        pushes: Requested pushes, in any order.
        references: Requested body poses; requests for the same time apply in the order of this
            tuple.
        gains: Gains of the controller; None: the robot's own gains.
        motor_damping: Motor-side damping in every command [N.m.s/rad]; 0: torque mode.
        form: Form of the controller's QP.
        predicted_delay: Delay [s] from a measurement until the resulting command acts. The
            controller predicts the state over this delay. The setting does not delay the plant;
            PlantSettings.extra_delay does.
    """

    robot: str | RobotDescription = "go1"
    duration: float = 10.0
    plant: PlantSettings = field(default_factory=lambda: PlantSettings(seed=1))
    pushes: tuple[PushRequest, ...] = ()
    references: tuple[ReferenceRequest, ...] = ()
    gains: Gains | None = None
    motor_damping: float = 0.0
    form: QpForm = QpForm.AUTO
    predicted_delay: float = 0.0

    def __post_init__(self) -> None:
        if not 0.0 < self.duration <= MAX_DURATION:
            raise Error(
                f"duration: got {self.duration} s, expected above 0 and up to {MAX_DURATION:.0f} s"
            )
        check_rate(self.plant.control_rate)
        for push in self.pushes:
            self.check_time(f"push '{push}'", push.time)
            if push.time + push.duration > self.duration:
                raise Error(
                    f"push '{push}': ends at {push.time + push.duration:g} s, expected by the end "
                    f"of the run at {self.duration:g} s"
                )
        for request in self.references:
            self.check_time(f"reference '{request}'", request.time)

    def check_time(self, what: str, time: float) -> None:
        """Raise Error unless a time [s] is before the end of the run; `what` begins the message."""
        if time >= self.duration:
            raise Error(
                f"{what}: got time {time} s, expected one before the end of the run at "
                f"{self.duration} s"
            )

    @property
    def options(self) -> ControllerOptions:
        """Options of the controller's tick."""
        return ControllerOptions(self.motor_damping, self.predicted_delay, self.form)

    @property
    def ticks(self) -> int:
        """Number of control periods in the run."""
        return max(1, round(self.duration * self.plant.control_rate))


def check_rate(rate: float) -> None:
    """Raise Error unless the control period is a whole number of milliseconds."""
    period = 1000.0 / rate if rate > 0.0 else math.nan
    if not (period >= 1.0 and abs(period - round(period)) < 1e-9):
        raise Error(
            f"rate: got {rate:g} Hz, expected one whose period is a whole number of milliseconds "
            "(LowState.tick counts them): 1000, 500, 250, 200, 125, 100 ..."
        )

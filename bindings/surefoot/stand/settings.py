"""What a stand is asked to be."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from surefoot._core import Error, Gains, QpForm, StandOptions
from surefoot.robot.description import RobotDescription
from surefoot.sim import PlantSettings
from surefoot.stand.push_request import PushRequest
from surefoot.stand.reference_request import ReferenceRequest

MAX_DURATION = 600.0  # [s]; a log of 500 Hz then takes about a gigabyte


@dataclass(frozen=True)
class StandSettings:
    """Robot, plant, pushes, references and controller of one run; the same give the same run.

    Attributes:
        robot: A name of surefoot.available_robots(), or what describe_robot() returns of files.
        duration: Of the run, unless the robot falls [s].
        plant: Sensors, ground, payload, control rate and seed. The rate must make the control
            period a whole number of milliseconds, for that is what LowState.tick counts.
        pushes: In any order.
        references: Where the body is asked to be; those of the same time in this order.
        gains: Of the controller; None for the robot's own.
        motor_damping: Motor-side damping in every command [N.m.s/rad]; 0 is pure torque mode.
        form: Of the controller's program.
        predicted_delay: Delay that the controller predicts across, from a measurement to its command's
            action [s]; the plant's own delay is PlantSettings.extra_delay.
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
            self._check_time(f"push '{push}'", push.time)
            if push.time + push.duration > self.duration:
                raise Error(
                    f"push '{push}': ends at {push.time + push.duration:g} s, expected by the end "
                    f"of the run at {self.duration:g} s"
                )
        for request in self.references:
            self._check_time(f"reference '{request}'", request.time)

    def _check_time(self, what: str, time: float) -> None:
        if time >= self.duration:
            raise Error(
                f"{what}: got time {time} s, expected one before the end of the run at "
                f"{self.duration} s"
            )

    @property
    def options(self) -> StandOptions:
        """Of the StandController."""
        return StandOptions(self.motor_damping, self.predicted_delay, self.form)

    @property
    def ticks(self) -> int:
        """Control periods in the run."""
        return max(1, round(self.duration * self.plant.control_rate))


def check_rate(rate: float) -> None:
    """Raise Error unless the control period is a whole number of milliseconds."""
    period = 1000.0 / rate if rate > 0.0 else math.nan
    if not (period >= 1.0 and abs(period - round(period)) < 1e-9):
        raise Error(
            f"rate: got {rate:g} Hz, expected one whose period is a whole number of milliseconds "
            "(LowState.tick counts them): 1000, 500, 250, 200, 125, 100 ..."
        )

"""What a stand is asked to be."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from surefoot._core import Error, Gains
from surefoot.sim import PlantSettings
from surefoot.stand.pushes import PushRequest

MAX_DURATION = 600.0  # [s]; a log of 500 Hz then takes about a gigabyte


@dataclass(frozen=True)
class StandSettings:
    """Robot, plant, pushes and controller of one run; the same settings give the same run.

    Attributes:
        robot: A name of surefoot.available_robots().
        duration: Of the run, unless the robot falls [s].
        plant: Sensors, ground, payload, control rate and seed. The rate must make the control
            period a whole number of milliseconds, for that is what LowState.tick counts.
        pushes: In any order.
        gains: Of the controller; None for the robot's own.
        motor_damping: Motor-side damping in every command [N.m.s/rad]; 0 is pure torque mode.
    """

    robot: str = "go1"
    duration: float = 10.0
    plant: PlantSettings = field(default_factory=lambda: PlantSettings(seed=1))
    pushes: tuple[PushRequest, ...] = ()
    gains: Gains | None = None
    motor_damping: float = 0.0

    def __post_init__(self) -> None:
        if not 0.0 < self.duration <= MAX_DURATION:
            raise Error(
                f"duration: got {self.duration} s, expected above 0 and up to {MAX_DURATION:.0f} s"
            )
        check_rate(self.plant.control_rate)
        for push in self.pushes:
            if push.time >= self.duration:
                raise Error(
                    f"push '{push}': got time {push.time} s, expected one before the end of the "
                    f"run at {self.duration} s"
                )

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

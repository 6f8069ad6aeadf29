"""Settings of a walk."""

from __future__ import annotations

from dataclasses import dataclass, field

from surefoot._core import Error, Gait, WalkOptions
from surefoot.robot.setting_checks import check_number
from surefoot.sim import PlantSettings
from surefoot.stand import SimulationSettings
from surefoot.walk.velocity_request import VelocityRequest


def walking_plant() -> PlantSettings:
    """Return the default plant of a walk: sensor errors, soles and collisions that walking adds."""
    return PlantSettings(walking_sensors=True, soft_soles=True, leg_collisions=True, seed=1)


@dataclass(frozen=True)
class WalkSettings(SimulationSettings):
    """Settings of a simulated walk: those of SimulationSettings, velocities and gait.

    Equal settings give equal runs.

    Attributes:
        plant: Sensors, ground, payload, control rate and seed; by default with walking sensors,
            soft soles and leg collisions.
        velocities: Commanded velocities, in any order; the velocity is 0 before the first one.
        gait: Gait of the controller.
        lost_frames: Share of frames lost in each direction [%]. When a LowState is lost, the
            controller receives the one before again; when a LowCmd is lost, the motors keep the one
            before.
    """

    plant: PlantSettings = field(default_factory=walking_plant)
    velocities: tuple[VelocityRequest, ...] = ()
    gait: Gait = Gait.AUTO
    lost_frames: float = 0.0

    def __post_init__(self) -> None:
        super().__post_init__()
        check_number("lost_frames", self.lost_frames, 0.0, 90.0)
        times = [request.time for request in self.velocities]
        for request in self.velocities:
            self.check_time(f"velocity '{request}'", request.time)
            if times.count(request.time) > 1:
                raise Error(
                    f"velocity '{request}': got another velocity for {request.time:g} s, expected "
                    "one for each time"
                )

    @property
    def walk_options(self) -> WalkOptions:
        """Options of the WalkController."""
        return WalkOptions(self.options)

"""Interface between the page and a robot, simulated or on UDP."""

from __future__ import annotations

from typing import Protocol

from surefoot._core import Error, Gait, Robot, WalkController, WalkVelocity
from surefoot.robot.description import RobotDescription
from surefoot.tune.live.gain_editor import GainEditor
from surefoot.tune.live.gain_limiter import GainLimiter
from surefoot.tune.live.metric_curves import Curves
from surefoot.tune.live.scene_state import SceneState

# Chosen: motions that a person sees; the controller stops the body at the limits of its reach.
REFERENCE_RANGES = {
    "x": ("m", -0.08, 0.08),
    "y": ("m", -0.08, 0.08),
    "height": ("m", -0.12, 0.08),
    "roll": ("deg", -20.0, 20.0),
    "pitch": ("deg", -20.0, 20.0),
    "yaw": ("deg", -25.0, 25.0),
}
"""Unit, smallest value and largest value on the page, for each field of BodyReference."""


class Session(Protocol):
    """Robot that stands or walks, whose gains can be edited.

    One thread owns a session. Only this thread calls methods, unless their docstrings permit any
    thread.

    Attributes:
        description: The robot's files.
        robot: The controller's model of the robot.
        editor: Editor of the desired gains; the session passes these gains to the controller.
        gain_limiter: Limits of the gains for a robot on UDP; None for a simulated robot.
        scene_state: Present state. Every update replaces the object, so any thread may read it.
        curves: Metrics of the last seconds.
        period: Time that tick() advances [s].
        attended: Whether someone watches the robot; any thread may set it. While it is False, the
            controller receives no velocity, so the velocity times out and the robot stops.
        velocity_version: Number of times that the session itself has set the velocity to 0.
    """

    description: RobotDescription
    robot: Robot
    editor: GainEditor
    gain_limiter: GainLimiter | None
    scene_state: SceneState
    curves: Curves
    period: float
    attended: bool
    velocity_version: int

    @property
    def status(self) -> str:
        """Status of the robot in a few words."""
        ...

    @property
    def healthy(self) -> bool:
        """True if the robot stands or walks, and its controller works."""
        ...

    def tick(self) -> None:
        """Advance by one period.

        In a simulation this is one control period. For a robot on UDP it reads the status messages
        and moves the gains; the control process runs the controller.
        """
        ...

    def update_view(self) -> None:
        """Update `scene_state`."""
        ...

    def set_reference(self, values: dict[str, float]) -> None:
        """Set the body reference, by axis as in REFERENCE_RANGES [m, deg]."""
        ...

    def set_velocity(self, velocity: WalkVelocity) -> None:
        """Command a velocity until another one is set or `attended` is False."""
        ...

    def set_gait(self, gait: Gait) -> None:
        """Set the gait."""
        ...

    def walk_text(self) -> str:
        """Return velocity, limits and figures of the walk as Markdown."""
        ...

    def close(self) -> None:
        """End control of the robot."""
        ...


def velocity_range(robot: Robot) -> tuple[tuple[float, ...], tuple[float, ...]] | None:
    """Return lowest and highest vx, vy [m/s] and yaw rate [rad/s] of the robot's own gains.

    None: the robot cannot walk.
    """
    try:
        probe = WalkController(robot)
    except Error:
        return None
    limits = []
    for sign in (-1.0, 1.0):
        probe.set_velocity(WalkVelocity(sign * 1e3, sign * 1e3, sign * 1e3))
        v = probe.commanded_velocity
        limits.append((v.vx, v.vy, v.yaw_rate))
    return limits[0], limits[1]

"""What the page needs of a robot, simulated or on UDP."""

from __future__ import annotations

from typing import Protocol

from surefoot._core import Robot
from surefoot.robot.description import RobotDescription
from surefoot.tune.live.gain_editor import GainEditor
from surefoot.tune.live.gain_limiter import GainLimiter
from surefoot.tune.live.metric_curves import Curves
from surefoot.tune.live.scene_state import SceneState

REFERENCE_RANGES = {
    "x": ("m", -0.08, 0.08),
    "y": ("m", -0.08, 0.08),
    "height": ("m", -0.12, 0.08),
    "roll": ("deg", -20.0, 20.0),
    "pitch": ("deg", -20.0, 20.0),
    "yaw": ("deg", -25.0, 25.0),
}
"""Of the body reference, BodyReference's names: unit, least and greatest value on the page."""


class Session(Protocol):
    """A robot that stands under gains that can be edited; used by one thread at a time.

    Attributes:
        description: The robot's files.
        robot: The robot as its controller knows it.
        editor: Gains that are wanted; the session takes them to the controller.
        gain_limiter: What keeps the gains near the robot's own; None for one that may fall.
        scene_state: The present instant; replaced, never changed, so any thread may look.
        curves: The last seconds in numbers.
        period: Time that tick() advances [s].
    """

    description: RobotDescription
    robot: Robot
    editor: GainEditor
    gain_limiter: GainLimiter | None
    scene_state: SceneState
    curves: Curves
    period: float

    @property
    def status(self) -> str:
        """How the robot is, in a few words."""
        ...

    @property
    def healthy(self) -> bool:
        """Whether the controller has the robot under control."""
        ...

    def tick(self) -> None:
        """Advance by one period."""
        ...

    def update_view(self) -> None:
        """Bring `scene_state` up to date."""
        ...

    def set_reference(self, values: dict[str, float]) -> None:
        """Ask for another pose of the body, by axis as AXES has them; m and deg."""
        ...

    def close(self) -> None:
        """Let go of the robot."""
        ...

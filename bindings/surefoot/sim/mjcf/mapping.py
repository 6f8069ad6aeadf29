"""What was found in an MJCF file, and how the plant uses it."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class JointMatch:
    """A motor of the controller's robot and the joint of the file that it moves.

    Attributes:
        motor: Name of the joint of the controller's robot.
        joint: Name of the joint in the file.
        sign: 1.0, or -1.0 if the file's axis points the other way.
        offset: Angle [rad] of the controller's robot where sign times the file's angle is 0.
        armature: Rotor inertia [kg.m^2].
        damping: Viscous friction [N.m.s/rad].
        friction: Dry friction [N.m].
    """

    motor: str
    joint: str
    sign: float
    offset: float
    armature: float
    damping: float
    friction: float


@dataclass(frozen=True)
class FootMatch:
    """A foot: name of its frame, of its geom and body in the file, and its radius [m]."""

    frame: str
    geom: str
    body: str
    radius: float


@dataclass(frozen=True)
class ModelMapping:
    """What was found in an MJCF file; str() gives it as a table.

    Attributes:
        path: The file.
        robot: Name of the controller's robot.
        base: Body with the free joint.
        mass: Mass of the file's robot [kg].
        joints: Twelve joints, SDK motor order.
        feet: Feet FR FL RR RL.
        imu: Where the IMU mount was found, in words.
        imu_position: Position of the IMU in the base frame [m].
        ground: Name of the ground plane, or what replaces it, in words.
        notes: What is used, changed or ignored, one sentence each.
        doubts: Values that are possible but unusual, one sentence each.
    """

    path: Path
    robot: str
    base: str
    mass: float
    joints: tuple[JointMatch, ...]
    feet: tuple[FootMatch, ...]
    imu: str
    imu_position: tuple[float, float, float]
    ground: str
    notes: tuple[str, ...]
    doubts: tuple[str, ...]

    def __str__(self) -> str:
        """Return the mapping as lines of text."""
        x, y, z = self.imu_position
        lines = [
            f"{self.path} as {self.robot}: base '{self.base}', {self.mass:.3f} kg",
            f"  IMU     {self.imu}, at ({x:.4g}, {y:.4g}, {z:.4g}) m",
            f"  ground  {self.ground}",
            f"  {'motor':<16}{'joint of the file':<22}{'angle':<16}armature  damping  friction",
        ]
        for joint in self.joints:
            angle = ("" if joint.sign > 0.0 else "-") + "q" + _signed(joint.offset)
            lines.append(
                f"  {joint.motor:<16}{joint.joint:<22}{angle:<16}{joint.armature:<10.4g}"
                f"{joint.damping:<9.4g}{joint.friction:.4g}"
            )
        for foot in self.feet:
            where = f"geom '{foot.geom}' of body '{foot.body}'"
            lines.append(f"  {foot.frame:<16}{where}, radius {foot.radius:.4g} m")
        lines += [f"  {note}" for note in self.notes]
        lines += [f"  doubt: {doubt}" for doubt in self.doubts]
        return "\n".join(lines)


def _signed(offset: float) -> str:
    return "" if abs(offset) < 5e-4 else f" {offset:+.3f} rad"

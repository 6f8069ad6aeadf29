"""External sine torques on joints of a hung robot, to test the power protection."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from surefoot._core import Error
from surefoot.geometry.rotations import Array
from surefoot.messages.low_state_layout import LEGS, MOTOR_COUNT
from surefoot.robot.setting_checks import check_number

_FORMAT = "JOINT:TORQUE:HZ@TIME[:DURATION]"
_JOINTS = ("hip", "thigh", "calf")


@dataclass(frozen=True)
class Shake:
    """External torque on a joint: torque * sin(2 pi frequency (t - time)).

    Attributes:
        motor: SDK motor of the joint, 0 .. 11.
        torque: Amplitude [N.m].
        frequency: Frequency [Hz].
        time: Start [s].
        duration: Duration [s].
    """

    motor: int
    torque: float
    frequency: float
    time: float
    duration: float = math.inf

    def __post_init__(self) -> None:
        check_number("shake: torque", self.torque, -1000.0, 1000.0)
        check_number("shake: frequency", self.frequency, 0.0, 100.0)
        check_number("shake: time", self.time, 0.0, 1e9)
        check_number("shake: duration", self.duration, 0.0, math.inf)


def parse_shake(text: str) -> Shake:
    """Parse JOINT:TORQUE:HZ@TIME[:DURATION]; JOINT is FR_2, FR_calf or 2; raises Error."""
    try:
        joint_part, time_part = text.split("@")
        joint, torque, frequency = joint_part.split(":")
        numbers = [float(word) for word in (torque, frequency, *time_part.split(":"))]
    except ValueError:
        numbers = []
    if len(numbers) not in (3, 4):
        raise Error(f"shake: got '{text}', expected {_FORMAT}, such as FR_1:8:5@2.0:3")
    return Shake(find_motor(joint), *numbers)


def find_motor(name: str) -> int:
    """Return the SDK motor, 0 .. 11, for a name such as FR_2, FR_calf or 2; raises Error."""
    if re.fullmatch(r"\d{1,2}", name) and int(name) < MOTOR_COUNT:
        return int(name)
    leg, _, joint = name.partition("_")
    if leg in LEGS and joint in _JOINTS:
        return 3 * LEGS.index(leg) + _JOINTS.index(joint)
    if leg in LEGS and joint in ("0", "1", "2"):
        return 3 * LEGS.index(leg) + int(joint)
    raise Error(f"shake: got joint '{name}', expected FR_0 .. RL_2, FR_hip .. RL_calf or 0 .. 11")


class JointShaker:
    """Sum of all shakes of a run."""

    def __init__(self, shakes: Sequence[Shake]) -> None:
        self._shakes = tuple(shakes)
        self._end = max((shake.time + shake.duration for shake in shakes), default=-math.inf)

    def torque(self, time: float) -> Array | None:
        """Return the torques (12,) [N.m] at a time [s], or None after the end of all shakes."""
        if time >= self._end:
            return None
        torque = np.zeros(MOTOR_COUNT)
        for shake in self._shakes:
            elapsed = time - shake.time
            if 0.0 <= elapsed < shake.duration:
                angle = 2.0 * math.pi * shake.frequency * elapsed
                torque[shake.motor] += shake.torque * math.sin(angle)
        return torque

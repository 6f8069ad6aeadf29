"""External sine torques on the joints of a hung robot, to test the power protection."""

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
    """External torque on a joint at time t: torque * sin(2 pi frequency (t - time)).

    Attributes:
        motor: Number of the joint in motor order, 0 .. 11.
        torque: Amplitude of the torque [N.m].
        frequency: Frequency of the torque [Hz].
        time: Time at which the torque begins [s].
        duration: Duration of the torque [s].
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
    """Parse a shake of the form JOINT:TORQUE:HZ@TIME[:DURATION].

    Args:
        text: The shake as text. JOINT is a name such as FR_2, FR_calf or 2; TORQUE is in N.m, HZ in
            Hz, TIME and DURATION are in s. Without DURATION the shake does not end.

    Raises:
        Error: The text does not have this form, or a value is invalid.
    """
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
    """Return the number in motor order, 0 .. 11, of a joint name such as FR_2, FR_calf or 2.

    Raises:
        Error: There is no joint with this name.
    """
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
        """Return the joint torques (12,) [N.m] at a time [s]; None after the end of all shakes."""
        if time >= self._end:
            return None
        torque = np.zeros(MOTOR_COUNT)
        for shake in self._shakes:
            elapsed = time - shake.time
            if 0.0 <= elapsed < shake.duration:
                angle = 2.0 * math.pi * shake.frequency * elapsed
                torque[shake.motor] += shake.torque * math.sin(angle)
        return torque

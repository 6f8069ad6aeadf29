"""Joint PD: every motor holds its angle of the first sample."""

from __future__ import annotations

from surefoot._core import LowCmd, LowState, Robot
from surefoot.messages.low_state_layout import MOTOR_COUNT

# Chosen: of 6 to 40 and 0.15 to 0.8 that were tried, these survive and stand best (docs/assess.md).
# KD_PER_KG is the end of its range. sim/physics/standing_pose.py holds the robot with the same.
KP_PER_KG = 25.0  # [N.m/rad] per kilogram of robot
KD_PER_KG = 0.8  # [N.m.s/rad] per kilogram of robot
SERVO = 0x0A  # motor mode, as in the SDK's comm.h


class JointPd:
    """Controller that holds the joint angles with the motors' own Kp and Kd; tau = 0.

    Args:
        robot: Model of the robot; Kp and Kd are proportional to its mass.
    """

    def __init__(self, robot: Robot) -> None:
        self._kp, self._kd = KP_PER_KG * robot.mass, KD_PER_KG * robot.mass
        self._command: LowCmd | None = None

    def update(self, state: LowState) -> LowCmd:
        """Return the command; it is the same in every tick."""
        if self._command is None:
            self._command = LowCmd()
            for i in range(MOTOR_COUNT):
                motor = self._command.motorCmd[i]
                motor.mode, motor.q, motor.dq, motor.tau = SERVO, state.motorState[i].q, 0.0, 0.0
                motor.Kp, motor.Kd = self._kp, self._kd
        return self._command

"""Joint PD: every motor holds the angle that it has in the first sample."""

from __future__ import annotations

from surefoot._core import LowCmd, LowState, Robot
from surefoot.messages.low_state_layout import MOTOR_COUNT

# Chosen: KP_PER_KG from 6 to 40 and KD_PER_KG from 0.15 to 0.8 were tried; the robot survives and
# stands best with these values (docs/reference/scorecard.md). KD_PER_KG is at the end of the range
# that was tried. sim/physics/standing_pose.py uses the same values.
KP_PER_KG = 25.0  # [N.m/rad] per kilogram of robot
KD_PER_KG = 0.8  # [N.m.s/rad] per kilogram of robot
SERVO = 0x0A  # motor mode in comm.h of the SDK


class JointPd:
    """Controller that holds the joint angles by Kp and Kd of the motor commands, with tau = 0.

    Args:
        robot: Model of the robot; Kp and Kd are proportional to its mass.
    """

    def __init__(self, robot: Robot) -> None:
        self._kp, self._kd = KP_PER_KG * robot.mass, KD_PER_KG * robot.mass
        self._command: LowCmd | None = None

    def update(self, state: LowState) -> LowCmd:
        """Return the command of one tick; it is the same in every tick."""
        if self._command is None:
            self._command = LowCmd()
            for i in range(MOTOR_COUNT):
                motor = self._command.motorCmd[i]
                motor.mode, motor.q, motor.dq, motor.tau = SERVO, state.motorState[i].q, 0.0, 0.0
                motor.Kp, motor.Kd = self._kp, self._kd
        return self._command

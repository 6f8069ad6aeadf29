"""Plain joint PD: every motor holds the angle at which it was found."""

from __future__ import annotations

from surefoot._core import LowCmd, LowState, Robot
from surefoot.messages.low_state_layout import MOTOR_COUNT

KP_PER_KG = 25.0  # [N.m/rad] per kilogram of robot
KD_PER_KG = 0.8  # [N.m.s/rad] per kilogram of robot
SERVO = 0x0A


class JointPd:
    """Holds joint angles with the motors' own stiffness and damping; tau = 0.

    Args:
        robot: For its mass, which stiffness and damping are in proportion to.
    """

    def __init__(self, robot: Robot) -> None:
        self._kp, self._kd = KP_PER_KG * robot.mass, KD_PER_KG * robot.mass
        self._command: LowCmd | None = None

    def update(self, state: LowState) -> LowCmd:
        """Return the command, the same every time."""
        if self._command is None:
            self._command = LowCmd()
            for i in range(MOTOR_COUNT):
                motor = self._command.motorCmd[i]
                motor.mode, motor.q, motor.dq, motor.tau = SERVO, state.motorState[i].q, 0.0, 0.0
                motor.Kp, motor.Kd = self._kp, self._kd
        return self._command

"""Line of text about the status of a virtual robot."""

from __future__ import annotations

import math

import numpy as np

from surefoot.sim.hardware.motors import SERVO_MODE
from surefoot.virtual_robot.dds_robot_link import DdsRobotLink
from surefoot.virtual_robot.robot import VirtualRobot
from surefoot.virtual_robot.robot_link import RobotLink


class StatusLine:
    """Source of status lines; each line has rates and the peak power since the line before.

    Args:
        robot: The robot; the status line only reads it.
    """

    def __init__(self, robot: VirtualRobot) -> None:
        self._robot = robot
        self._last_values = (0.0, 0.0, 0, 0)
        self._peak = 0.0

    def observe(self) -> None:
        """Update the peak power; call after every cycle."""
        self._peak = max(self._peak, self._robot.power)

    def line(self, elapsed: float) -> str:
        """Return the next status line.

        Args:
            elapsed: Clock time since the start of the run [s].
        """
        robot, link = self._robot, self._robot.link
        values = (elapsed, robot.time, link.sent, link.commands)
        seconds, simulated, sent, commands = (
            a - b for a, b in zip(values, self._last_values, strict=True)
        )
        seconds = max(seconds, 1e-9)
        peak, self._last_values, self._peak = self._peak, values, 0.0
        return " | ".join(
            (
                f"{robot.time:.1f} s",
                f"samples {sent / seconds:.0f} Hz",
                f"commands {commands / seconds:.0f} Hz, {commands_text(link)}",
                f"rejected {link.rejected_text()}",
                mode_text(robot),
                f"height {robot.height:.3f} m",
                f"tilt {math.degrees(robot.tilt):.1f} deg",
                f"power {robot.power:.0f} W, peak {peak:.0f} W",
                f"real time x {simulated / seconds:.2f}",
            )
        )


def commands_text(link: RobotLink | DdsRobotLink) -> str:
    """Return the counts of valid, repeated and overtaken commands and of lost datagrams as text."""
    lost_in, lost_out = link.lost
    parts = [f"{link.commands} in all"]
    parts += [f"{link.repeated} repeated"] if link.repeated else []
    parts += [f"{link.overtaken} overtaken"] if link.overtaken else []
    parts += [f"lost {lost_in} in, {lost_out} out"] if lost_in or lost_out else []
    return ", ".join(parts)


def mode_text(robot: VirtualRobot) -> str:
    """Return the mode of the motors as text."""
    if not robot.watchdog.received_any:
        return f"motors {'damp' if robot.settings.lying else 'hold'}, no command yet"
    times = len(robot.watchdog.intervals)
    if robot.watchdog.damping:
        return f"motors DAMP, commands missing ({times} times)"
    servo = int(np.count_nonzero(robot.plant.motors.law.mode == SERVO_MODE))
    text = "servo" if servo == 12 else "damping" if servo == 0 else f"servo {servo} of 12"
    return f"motors {text}" + (f" (commands missing {times} times)" if times else "")

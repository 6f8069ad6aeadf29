"""Log and summary of a run of a virtual robot, as JSON values."""

from __future__ import annotations

import math
from collections import Counter, deque
from typing import Any

import numpy as np

from surefoot.geometry.rotations import Array
from surefoot.messages.low_state_layout import MOTOR_COUNT
from surefoot.sim.hardware.wire_format import MotorCommands
from surefoot.virtual_robot.robot import VirtualRobot

# [s] Longest log; the log of a longer run contains only its end. Chosen: bounds the memory. Equal
# to the largest --log-time of `surefoot run`.
MAX_LOG_TIME = 600.0
_DIGITS = 6  # number of decimals of the values in the log
_COMMAND_FIELDS = ("mode", "q", "dq", "tau", "kp", "kd")


class RunRecorder:
    """Recorder of the log of a virtual robot, and of its largest power.

    Args:
        robot: The robot; the recorder only reads it.

    Attributes:
        peak_power: Largest value of VirtualRobot.power in any LowState [W].
    """

    def __init__(self, robot: VirtualRobot) -> None:
        self._robot = robot
        settings = robot.settings
        rate = settings.log_rate
        self._log_interval = max(1, round(settings.rate / rate)) if rate > 0.0 else 0
        self._rate = settings.rate / self._log_interval if self._log_interval else 0.0
        # Each row has q, dq, tau of 12 motors, then time, height and tilt. An entry also has the
        # command (not copied, because no command changes later) and whether commands were missing.
        self._rows: deque[tuple[Array, MotorCommands | None, bool]] = deque(
            maxlen=max(1, round(MAX_LOG_TIME * self._rate))
        )
        self._cycles = 0
        self.peak_power = 0.0

    def observe(self) -> None:
        """Record the state of the robot; call after every cycle."""
        robot = self._robot
        self.peak_power = max(self.peak_power, robot.power)
        self._cycles += 1
        if not self._log_interval or self._cycles % self._log_interval:
            return
        plant, row = robot.plant, np.empty(3 * MOTOR_COUNT + 3)
        row[0:12] = plant.data.qpos[plant.handles.motor_q]
        row[12:24] = plant.data.qvel[plant.handles.motor_v]
        row[24:36] = plant.motors.torque
        row[36:] = robot.time, robot.height, robot.tilt
        self._rows.append((row, robot.command, robot.watchdog.damping))

    def log(self) -> dict[str, Any]:
        """Return the log as lists by name, with one entry per row.

        The entries of the lists ``command_...`` are None before the first command.
        """
        table = np.array([row for row, _, _ in self._rows]).reshape(-1, 3 * MOTOR_COUNT + 3)
        log: dict[str, Any] = {
            "rate": self._rate,
            "time": _json_numbers(table[:, 36]),
            "q": _json_numbers(table[:, 0:12]),
            "dq": _json_numbers(table[:, 12:24]),
            "tau": _json_numbers(table[:, 24:36]),
            "height": _json_numbers(table[:, 37]),
            "tilt": _json_numbers(table[:, 38]),
            "damping": [damping for _, _, damping in self._rows],
        }
        for name in _COMMAND_FIELDS:
            log[f"command_{name}"] = [
                None
                if command is None
                else _json_numbers(np.asarray(getattr(command, name), float))
                for _, command, _ in self._rows
            ]
        return log


def summarise(
    robot: VirtualRobot, recorder: RunRecorder, real_time_factor: float, slipped: float
) -> dict[str, Any]:
    """Return settings, counts, damping intervals, fall, power and log of a run as JSON values.

    Args:
        robot: The robot after the run.
        recorder: Recorder of the run.
        real_time_factor: Ratio of simulated time to clock time.
        slipped: Sum of the delays that the run did not catch up [s].
    """
    settings, link = robot.settings, robot.link
    intervals = robot.watchdog.intervals
    return {
        "robot": robot.plant.robot.name,
        "sdk": settings.generation,
        "rate": settings.rate,
        "hung": settings.hung,
        "lying": settings.lying,
        "seed": settings.seed,
        "duration": round(robot.time, _DIGITS),
        "received": link.received,
        "commands": link.commands,
        "overtaken": link.overtaken,
        "repeated": link.repeated,
        "rejected": dict(Counter(link.rejected_counts()).most_common()),
        "rejected_lengths": link.rejected_lengths(),
        "sent": link.sent,
        "unsent": link.unsent,
        "lost_in": link.lost[0],
        "lost_out": link.lost[1],
        "damping": [[round(t, _DIGITS) if t is not None else None for t in i] for i in intervals],
        "fell": robot.fell_at is not None,
        "fell_at": robot.fell_at,
        "peak_power": round(recorder.peak_power, 3) if math.isfinite(recorder.peak_power) else None,
        "real_time_factor": round(real_time_factor, 4),
        "slipped": round(slipped, 4),
        "log": recorder.log(),
    }


def _json_numbers(values: Array) -> Any:
    # JSON has no NaN and no infinity, so both become None (null).
    rounded = np.round(values, _DIGITS).astype(object)
    rounded[~np.isfinite(values)] = None
    return rounded.tolist()

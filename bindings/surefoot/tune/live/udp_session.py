"""A robot on UDP as a Session: a control process at one end of a pipe, the page at the other."""

from __future__ import annotations

import multiprocessing
import threading
from typing import Any

import mujoco
import numpy as np

from surefoot._core import Error, Gains
from surefoot.robot.description import RobotDescription
from surefoot.robot.gain_files import gain_values
from surefoot.robot.loading import build_robot, load_pinocchio_model
from surefoot.sim.model.mujoco_handles import find_handles
from surefoot.sim.model.mujoco_model import build_model
from surefoot.sim.pinocchio_adapter import PinocchioAdapter
from surefoot.sim.settings import PlantSettings
from surefoot.tune.live.control_process import (
    STATUS_PERIOD,
    RobotAddress,
    RunnerStatus,
    run_control_process,
)
from surefoot.tune.live.gain_editor import GainEditor
from surefoot.tune.live.gain_limiter import GainLimiter
from surefoot.tune.live.metric_curves import Curves, TickMetrics
from surefoot.tune.live.scene_state import SceneState

_NO_METRICS = TickMetrics(0.0, 0.0, 0.0, 0.0, 0.0)
_START_TIMEOUT, _EXIT_TIMEOUT = 30.0, 5.0  # [s] that the process may take to begin and to end


class UdpSession:
    """A Session on a robot that speaks the SDK's UDP frames; gains move within a Guard.

    Args:
        description: The robot's files.
        place: Where it is.
        gains: To begin with, within the guarded ranges; None for the robot's own.

    Attributes:
        runner_status: What the control process said last.

    Raises:
        Error: A gain out of its range, or what UdpLink raises.
    """

    def __init__(
        self, description: RobotDescription, place: RobotAddress, gains: Gains | None = None
    ) -> None:
        self.description, self._address = description, place
        self.robot = build_robot(description)
        robot_gains = self.robot.config.gains
        self.gain_limiter: GainLimiter | None = GainLimiter(robot_gains)
        self.editor = GainEditor(robot_gains, gains, self.gain_limiter.check)
        self._active_gains = self.editor.gains
        self.curves, self.period = Curves(), STATUS_PERIOD
        self._model = build_model(self.robot, description, PlantSettings())
        self._data = mujoco.MjData(self._model)
        self._handles = find_handles(self._model, self.robot)
        self._adapter = PinocchioAdapter(self._model, load_pinocchio_model(description))
        self.runner_status = RunnerStatus(
            "waiting", "", None, np.zeros((3, 4)), np.zeros(4, dtype=bool), _NO_METRICS
        )
        self._time, self._refused = 0.0, 0
        self._send_lock = threading.Lock()
        self._data.qpos[self._handles.joint_q] = self.robot.config.q_standing
        self.update_view()
        self._start()

    @property
    def status(self) -> str:
        """How the robot is, in a few words."""
        runner_status = self.runner_status
        if not self._process.is_alive() and runner_status.phase != "ended":
            return f"{self._address}: the control process has ended"
        reason_text = f": {runner_status.reason}" if runner_status.reason else ""
        hint = "; Re-arm stands it up" if runner_status.phase in ("damping", "passive") else ""
        if runner_status.phase == "damping" and runner_status.refused > self._refused:
            hint = "; not re-armed, for no LowState comes"
        return f"{self._address}: {runner_status.phase}{reason_text}{hint}"

    @property
    def healthy(self) -> bool:
        """Whether the robot stands under control."""
        return self._process.is_alive() and self.runner_status.phase == "standing"

    @property
    def active_gains(self) -> Gains:
        """The gains that the controller has, on their way to those that are wanted; a copy."""
        return self._active_gains.__copy__()

    def tick(self) -> None:
        """Take reports, and move the gains on by what the guard allows."""
        try:
            while self._pipe.poll():
                self.runner_status = self._pipe.recv()
                self._time += self.period
                self.curves.add(self._time, self.runner_status.sample)
        except (EOFError, OSError):
            return
        if self._active_gains != self.editor.gains:
            assert self.gain_limiter is not None  # set in __init__
            self._active_gains = self.gain_limiter.step_towards(
                self._active_gains, self.editor.gains, self.period
            )
            self._send("gains", gain_values(self._active_gains))

    def update_view(self) -> None:
        """Bring `scene_state` up to date: estimated pose, and forces that the program asks for."""
        runner_status, data, handles = self.runner_status, self._data, self._handles
        if runner_status.q is not None:
            data.qpos[:] = self._adapter.qpos_from_pinocchio(runner_status.q)
        mujoco.mj_kinematics(self._model, data)
        mujoco.mj_comPos(self._model, data)
        down = np.array([0.0, 0.0, self.robot.config.foot_radius])
        self.scene_state = SceneState(
            qpos=data.qpos.copy(),
            contact_points=data.xpos[handles.foot_bodies] - down,
            forces=runner_status.forces.T,
            contact=runner_status.contact,
            com=data.subtree_com[handles.root].copy(),
            ground=np.array([1.0, 0.0, 0.0, 0.0]),
        )

    def set_reference(self, values: dict[str, float]) -> None:
        """Ask for another pose of the body, by axis; m and deg."""
        self._send("reference", values)

    def damp(self) -> None:
        """Let the motors brake, and stay so; from any thread."""
        self._send("damp")

    def rearm(self) -> None:
        """Stand again after a damping, in the pose it then has; from any thread."""
        self._refused = self.runner_status.refused
        self._send("rearm")

    def close(self) -> None:
        """Let the motors brake and end the control process."""
        self._send("stop")
        self._pipe.close()
        self._process.join(_EXIT_TIMEOUT)
        if self._process.is_alive():
            self._process.terminate()  # which damps as well

    def _start(self) -> None:
        # A fresh interpreter: threads and sockets of the page are none of its business.
        context = multiprocessing.get_context("spawn")
        self._pipe, child_pipe = context.Pipe()
        process_args = (
            child_pipe,
            self.description,
            self._address,
            gain_values(self._active_gains),
        )
        self._process = context.Process(target=run_control_process, args=process_args, daemon=True)
        self._process.start()
        child_pipe.close()
        try:
            problem = self._pipe.recv() if self._pipe.poll(_START_TIMEOUT) else "no answer"
        except EOFError:
            problem = "it ended at once"
        if problem:
            self._process.join(_EXIT_TIMEOUT)
            raise Error(f"{self._address}: {problem}")

    def _send(self, word: str, values: Any = None) -> None:
        with self._send_lock:
            try:
                self._pipe.send((word, values))
            except OSError:  # its end shows in `status`
                return

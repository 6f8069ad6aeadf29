"""Session on a robot on UDP: a control process runs the controller, connected by a pipe."""

from __future__ import annotations

import multiprocessing
import threading
from typing import Any

import mujoco
import numpy as np

from surefoot._core import Error, Gains, Gait, WalkVelocity
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
# Chosen: loading a robot takes seconds; the loop damps for 0.2 s at its end.
_START_TIMEOUT, _EXIT_TIMEOUT = 30.0, 5.0  # [s] longest time for start and end of the process


class UdpSession:
    """Session on a robot that receives the SDK's UDP frames; a GainLimiter limits the gains.

    Args:
        description: The robot's files.
        address: Address of the robot.
        gains: Initial gains, within the ranges of the GainLimiter. None: the robot's own gains.

    Attributes:
        runner_status: Last status of the control process.
        attended: See Session.
        velocity_version: Number of times that the velocity was set to 0 because the robot did not
            walk.

    Raises:
        Error: A gain is out of its range, or UdpLink cannot be opened.
    """

    def __init__(
        self, description: RobotDescription, address: RobotAddress, gains: Gains | None = None
    ) -> None:
        self.description, self._address = description, address
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
        # _refused: number of refused re-arms at the last rearm().
        self._time, self._refused = 0.0, 0
        self._velocity = WalkVelocity()
        self.attended, self.velocity_version = True, 0
        self._send_lock = threading.Lock()
        self._data.qpos[self._handles.joint_q] = self.robot.config.q_standing
        self.update_view()
        self._start()

    @property
    def status(self) -> str:
        """Address and status of the robot in a few words."""
        runner_status = self.runner_status
        if not self._process.is_alive() and runner_status.phase != "ended":
            return f"{self._address}: the control process has ended"
        reason_text = f": {runner_status.reason}" if runner_status.reason else ""
        hint = "; Re-arm makes it stand" if runner_status.phase in ("damping", "passive") else ""
        if runner_status.phase == "damping" and runner_status.refused > self._refused:
            hint = "; not re-armed: no LowState, or arming checks fail"
        if runner_status.refusal:
            hint = f"; {runner_status.refusal}"
        return f"{self._address}: {runner_status.phase}{reason_text}{hint}"

    @property
    def healthy(self) -> bool:
        """True if the control process runs and the robot stands or walks."""
        return self._process.is_alive() and self.runner_status.phase in ("standing", "walking")

    @property
    def active_gains(self) -> Gains:
        """Copy of the controller's gains; they follow the desired gains at a limited rate."""
        return self._active_gains.__copy__()

    def tick(self) -> None:
        """Read the status messages, send the velocity, and move the gains by one limited step."""
        try:
            while self._pipe.poll():
                self.runner_status = self._pipe.recv()
                self._time += self.period
                self.curves.add(self._time, self.runner_status.metrics)
        except (EOFError, OSError):
            return
        self._send_velocity()
        if self._active_gains != self.editor.gains:
            assert self.gain_limiter is not None  # set in __init__
            self._active_gains = self.gain_limiter.step_towards(
                self._active_gains, self.editor.gains, self.period
            )
            self._send("gains", gain_values(self._active_gains))

    def update_view(self) -> None:
        """Update `scene_state` with the estimated pose and the contact forces of the QP."""
        runner_status, data, handles = self.runner_status, self._data, self._handles
        if runner_status.q is not None:
            data.qpos[:] = self._adapter.qpos_from_pinocchio(runner_status.q)
        mujoco.mj_kinematics(self._model, data)
        mujoco.mj_comPos(self._model, data)
        # Offset from a contact point up to the centre of the foot.
        contact_to_centre = np.array([0.0, 0.0, self.robot.config.foot_radius])
        self.scene_state = SceneState(
            qpos=data.qpos.copy(),
            contact_points=data.xpos[handles.foot_bodies] - contact_to_centre,
            forces=runner_status.forces.T,
            contact=runner_status.contact,
            com=data.subtree_com[handles.root].copy(),
            ground=np.array([1.0, 0.0, 0.0, 0.0]),
        )

    def set_reference(self, values: dict[str, float]) -> None:
        """Set the body reference, by axis as in REFERENCE_RANGES [m, deg]."""
        self._send("reference", values)

    def set_velocity(self, velocity: WalkVelocity) -> None:
        """Command a velocity; it is 0 again when the robot does not walk."""
        self._velocity = velocity

    def set_gait(self, gait: Gait) -> None:
        """Set the gait."""
        self._send("gait", gait.name)

    def walk_text(self) -> str:
        """Return the command of the walk as Markdown."""
        return self.runner_status.walk or "The robot does not walk: _Walk_ begins."

    def request_walk(self) -> None:
        """Let the standing robot walk at the commanded velocity; callable from any thread."""
        self._send("walk")

    def request_stand(self) -> None:
        """Let the robot stop on four feet and stand; callable from any thread."""
        self._send("stand")

    def damp(self) -> None:
        """Damp the robot until rearm(); callable from any thread."""
        self._send("damp")

    def rearm(self) -> None:
        """Let the damped robot stand again, in its present pose; callable from any thread."""
        self._refused = self.runner_status.refused
        self._send("rearm")

    def close(self) -> None:
        """Damp and end the control process."""
        self._send("stop")
        self._pipe.close()
        self._process.join(_EXIT_TIMEOUT)
        if self._process.is_alive():
            self._process.terminate()  # SIGTERM: the process damps and ends

    def _start(self) -> None:
        # Spawn a new interpreter, because a fork would copy the page's sockets and locks.
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

    def _send_velocity(self) -> None:
        """Send the velocity of a walking robot: the Runner lets a velocity time out."""
        v = self._velocity
        if self.runner_status.phase == "walking":
            if self.attended:
                self._send("velocity", (v.vx, v.vy, v.yaw_rate))
        elif v != WalkVelocity():
            self._velocity = WalkVelocity()
            self.velocity_version += 1

    def _send(self, word: str, values: Any = None) -> None:
        with self._send_lock:
            try:
                self._pipe.send((word, values))
            except OSError:  # the process has ended; `status` reports it
                return

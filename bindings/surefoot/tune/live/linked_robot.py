"""A robot on UDP as a Session: a control process at one end of a pipe, the page at the other."""

from __future__ import annotations

import multiprocessing
import threading
from typing import Any

import mujoco
import numpy as np

from surefoot._core import Error, Gains
from surefoot.gain_files import gain_values
from surefoot.robot_files import RobotDescription
from surefoot.robots import build_robot, load_pinocchio_model
from surefoot.sim.adapter import Adapter
from surefoot.sim.handles import find_handles
from surefoot.sim.model import build_model
from surefoot.sim.settings import PlantSettings
from surefoot.tune.live.curves import Curves, Sample
from surefoot.tune.live.gain_editor import GainEditor
from surefoot.tune.live.guard import Guard
from surefoot.tune.live.robot_process import (
    REPORT_PERIOD,
    Place,
    Report,
    control,
)
from surefoot.tune.live.view import View

_NONE = Sample(0.0, 0.0, 0.0, 0.0, 0.0)
_START, _END = 30.0, 5.0  # [s] that the process may take to begin and to end


class LinkedRobot:
    """A Session on a robot that speaks the SDK's UDP frames; gains move within a Guard.

    Args:
        description: The robot's files.
        place: Where it is.
        gains: To begin with, within the guarded ranges; None for the robot's own.

    Attributes:
        report: What the control process said last.

    Raises:
        Error: A gain out of its range, or what UdpLink raises.
    """

    def __init__(
        self, description: RobotDescription, place: Place, gains: Gains | None = None
    ) -> None:
        self.description, self._place = description, place
        self.robot = build_robot(description)
        own = self.robot.config.gains
        self.guard: Guard | None = Guard(own)
        self.editor = GainEditor(own, gains, self.guard.check)
        self._present = self.editor.gains
        self.curves, self.period = Curves(), REPORT_PERIOD
        self._model = build_model(self.robot, description, PlantSettings())
        self._data = mujoco.MjData(self._model)
        self._handles = find_handles(self._model, self.robot)
        self._adapter = Adapter(self._model, load_pinocchio_model(description))
        self.report = Report("waiting", "", None, np.zeros((3, 4)), np.zeros(4, dtype=bool), _NONE)
        self._time, self._refused = 0.0, 0
        self._saying = threading.Lock()
        self._data.qpos[self._handles.joint_q] = self.robot.config.q_standing
        self.look()
        self._start()

    @property
    def status(self) -> str:
        """How the robot is, in a few words."""
        report = self.report
        if not self._process.is_alive() and report.phase != "ended":
            return f"{self._place}: the control process has ended"
        why = f": {report.reason}" if report.reason else ""
        how = "; Re-arm stands it up" if report.phase in ("damping", "passive") else ""
        if report.phase == "damping" and report.refused > self._refused:
            how = "; not re-armed, for no LowState comes"
        return f"{self._place}: {report.phase}{why}{how}"

    @property
    def healthy(self) -> bool:
        """Whether the robot stands under control."""
        return self._process.is_alive() and self.report.phase == "standing"

    @property
    def present(self) -> Gains:
        """The gains that the controller has, on their way to those that are wanted; a copy."""
        return self._present.__copy__()

    def tick(self) -> None:
        """Take reports, and move the gains on by what the guard allows."""
        try:
            while self._pipe.poll():
                self.report = self._pipe.recv()
                self._time += self.period
                self.curves.add(self._time, self.report.sample)
        except (EOFError, OSError):
            return
        if self._present != self.editor.gains:
            assert self.guard is not None  # set in __init__
            self._present = self.guard.approach(self._present, self.editor.gains, self.period)
            self._say("gains", gain_values(self._present))

    def look(self) -> None:
        """Bring `view` up to date: estimated pose, and forces that the program asks for."""
        report, data, handles = self.report, self._data, self._handles
        if report.q is not None:
            data.qpos[:] = self._adapter.qpos_from_pinocchio(report.q)
        mujoco.mj_kinematics(self._model, data)
        mujoco.mj_comPos(self._model, data)
        down = np.array([0.0, 0.0, self.robot.config.foot_radius])
        self.view = View(
            qpos=data.qpos.copy(),
            contact_points=data.xpos[handles.foot_bodies] - down,
            forces=report.forces.T,
            contact=report.contact,
            com=data.subtree_com[handles.root].copy(),
            ground=np.array([1.0, 0.0, 0.0, 0.0]),
        )

    def set_reference(self, values: dict[str, float]) -> None:
        """Ask for another pose of the body, by axis; m and deg."""
        self._say("reference", values)

    def damp(self) -> None:
        """Let the motors brake, and stay so; from any thread."""
        self._say("damp")

    def rearm(self) -> None:
        """Stand again after a damping, in the pose it then has; from any thread."""
        self._refused = self.report.refused
        self._say("rearm")

    def close(self) -> None:
        """Let the motors brake and end the control process."""
        self._say("stop")
        self._pipe.close()
        self._process.join(_END)
        if self._process.is_alive():
            self._process.terminate()  # which damps as well

    def _start(self) -> None:
        # A fresh interpreter: threads and sockets of the page are none of its business.
        context = multiprocessing.get_context("spawn")
        self._pipe, other = context.Pipe()
        words = (other, self.description, self._place, gain_values(self._present))
        self._process = context.Process(target=control, args=words, daemon=True)
        self._process.start()
        other.close()
        try:
            problem = self._pipe.recv() if self._pipe.poll(_START) else "no answer"
        except EOFError:
            problem = "it ended at once"
        if problem:
            self._process.join(_END)
            raise Error(f"{self._place}: {problem}")

    def _say(self, word: str, values: Any = None) -> None:
        with self._saying:
            try:
                self._pipe.send((word, values))
            except OSError:  # its end shows in `status`
                return

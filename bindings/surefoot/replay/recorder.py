"""Recorder of all inputs and commands of a controller."""

from __future__ import annotations

from typing import Any

import numpy as np

from surefoot._core import Gains, LowCmd, LowState, Robot
from surefoot.replay.calls import answer_name, json_argument, make_call
from surefoot.replay.recording import (
    Call,
    Controller,
    Options,
    Recording,
    make_controller,
    recording_header,
)


class Recorder:
    """A controller, and the recording of its inputs and commands.

    The recording contains the calls of update() and call(); make them from one thread. Calls that
    only read the state of the controller can go to `controller` directly.

    Args:
        robot: Model of the robot.
        options: ControllerOptions for a StandController, WalkOptions for a WalkController,
            SupervisorOptions for a Supervisor.
        gains: Gains of the controller; None: the robot's own gains.

    Raises:
        Error: The constructor of the controller raised this error, for example for an invalid gain.

    Attributes:
        controller: The controller, of the class that fits the options.
    """

    def __init__(self, robot: Robot, options: Options, gains: Gains | None = None) -> None:
        self._header = recording_header(robot, gains, options)
        gains = gains if gains is not None else robot.config.gains
        kind, options_values = self._header["kind"], self._header["options"]
        self.controller: Controller = make_controller(robot, gains, kind, options_values)
        self._samples: list[bytes] = []
        self._commands: list[bytes] = []
        self._calls: list[Call] = []

    def update(self, state: LowState) -> LowCmd:
        """Update the controller with a LowState, record both, and return the LowCmd."""
        self._samples.append(state.to_bytes())
        command: LowCmd = self.controller.update(state)
        self._commands.append(command.to_bytes())
        return command

    def call(self, name: str, *arguments: Any) -> Any:
        """Call a method of the controller or set an attribute, record it, and return the result.

        Args:
            name: Name of the method or attribute, one of calls.CALLS.
            arguments: The argument of the method, or the value; none if there is no argument.

        Raises:
            Error: The controller has no such method, or the arguments do not fit the method.
        """
        argument = json_argument(name, *arguments)
        answer = make_call(self.controller, name, *arguments)
        self._calls.append(Call(len(self._samples), name, argument, answer_name(answer)))
        return answer

    def recording(self) -> Recording:
        """Return the recording up to now."""
        samples, commands = (
            np.frombuffer(b"".join(rows), dtype=np.uint8).reshape(len(rows), width)
            for rows, width in (
                (self._samples, len(LowState().raw)),
                (self._commands, len(LowCmd().raw)),
            )
        )
        return Recording(
            **self._header, samples=samples, commands=commands, calls=tuple(self._calls)
        )

"""A controller whose every call is kept."""

from __future__ import annotations

from typing import Any

import numpy as np

from surefoot._core import Error, Gains, LowCmd, LowState, Robot
from surefoot.replay.calls import answer_name, json_argument
from surefoot.replay.recording import (
    Call,
    Controller,
    Options,
    Recording,
    make_controller,
    recording_header,
)


class Recorder:
    """Makes a controller and keeps what goes in and comes out.

    Whatever is to be on the tape must go through update() and call(), by one thread; to look at
    the controller is free.

    Args:
        robot: Its model.
        options: StandOptions for a StandController, SupervisorOptions for a Supervisor.
        gains: None for the robot's own.

    Raises:
        Error: As the controller's constructor.

    Attributes:
        controller: It.
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
        """Take a tick."""
        self._samples.append(state.to_bytes())
        command: LowCmd = self.controller.update(state)
        self._commands.append(command.to_bytes())
        return command

    def call(self, name: str, *arguments: Any) -> Any:
        """Make one of calls.CALLS, and return its answer; raises Error."""
        argument = json_argument(name, *arguments)
        method = getattr(self.controller, name, None)
        if method is None:
            raise Error(f"call: got '{name}', which {type(self.controller).__name__} has not")
        answer = method(*arguments)
        self._calls.append(Call(len(self._samples), name, argument, answer_name(answer)))
        return answer

    def recording(self) -> Recording:
        """Return what there is so far."""
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

"""A controller whose every call is kept."""

from __future__ import annotations

from typing import Any

import numpy as np

from surefoot._core import Error, Gains, LowCmd, LowState, Robot
from surefoot.replay.calls import answer_name, plain_argument
from surefoot.replay.tape import Call, Controller, Options, Tape, head, make_controller


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
        self._head = head(robot, gains, options)
        gains = gains if gains is not None else robot.config.gains
        kind, its_options = self._head["kind"], self._head["options"]
        self.controller: Controller = make_controller(robot, gains, kind, its_options)
        self._reports: list[bytes] = []
        self._commands: list[bytes] = []
        self._calls: list[Call] = []

    def update(self, state: LowState) -> LowCmd:
        """Take a tick."""
        self._reports.append(state.to_bytes())
        command: LowCmd = self.controller.update(state)
        self._commands.append(command.to_bytes())
        return command

    def call(self, name: str, *arguments: Any) -> Any:
        """Make one of calls.CALLS, and return its answer; raises Error."""
        argument = plain_argument(name, *arguments)
        method = getattr(self.controller, name, None)
        if method is None:
            raise Error(f"call: got '{name}', which {type(self.controller).__name__} has not")
        answer = method(*arguments)
        self._calls.append(Call(len(self._reports), name, argument, answer_name(answer)))
        return answer

    def tape(self) -> Tape:
        """Return what there is so far."""
        reports, commands = (
            np.frombuffer(b"".join(rows), dtype=np.uint8).reshape(len(rows), width)
            for rows, width in (
                (self._reports, len(LowState().raw)),
                (self._commands, len(LowCmd().raw)),
            )
        )
        return Tape(**self._head, reports=reports, commands=commands, calls=tuple(self._calls))

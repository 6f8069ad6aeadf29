"""A tape: all that went into a controller, in order, and every command that came out."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt

from surefoot._core import (
    Error,
    Gains,
    Robot,
    StandController,
    StandOptions,
    Supervisor,
    SupervisorOptions,
)
from surefoot.replay.build_id import build_id
from surefoot.replay.options import json_options, options_from_json
from surefoot.robot.gain_files import gain_values, gains_from_values

Bytes = npt.NDArray[np.uint8]
Options = StandOptions | SupervisorOptions
Controller = StandController | Supervisor

_CONTROLLERS: dict[str, tuple[type[Controller], type[Options]]] = {
    "StandController": (StandController, StandOptions),
    "Supervisor": (Supervisor, SupervisorOptions),
}


@dataclass(frozen=True)
class Call:
    """A call of the controller other than update(), by the thread that updates it.

    Attributes:
        row: It came after the update of row - 1 and before that of row.
        name: One of calls.CALLS.
        argument: As JSON knows it; None for none.
        answer: Name of the RequestStatus that came back; "" for none.
    """

    row: int
    name: str
    argument: Any = None
    answer: str = ""


@dataclass(frozen=True)
class Recording:
    """One run of a controller, from its making on.

    A robot's model is not in it, nor are tasks of one's own and what a link says besides LowStates
    (Supervisor.update_without_state(), lose(), count_samples()).

    Attributes:
        kind: "StandController" or "Supervisor".
        robot: The robot's name.
        gains: That the controller was made with, by name.
        options: The same of its options.
        samples: (n, 937) bytes of the LowStates, one an update().
        commands: (n, 734) bytes of the LowCmds that came back.
        calls: In order.
        build: What made the commands: build.build_id() of then.
    """

    kind: str
    robot: str
    gains: dict[str, float]
    options: dict[str, Any]
    samples: Bytes
    commands: Bytes
    calls: tuple[Call, ...] = ()
    build: str = field(default_factory=build_id)

    def make(self, robot: Robot) -> Controller:
        """Return a controller as the tape's was when it was new; raises Error for another robot."""
        if robot.name != self.robot:
            raise Error(f"robot: got '{robot.name}', expected '{self.robot}', which the log is of")
        return make_controller(robot, gains_from_values(self.gains), self.kind, self.options)


def make_controller(robot: Robot, gains: Gains, kind: str, options: dict[str, Any]) -> Controller:
    """Return a controller of a kind; raises Error."""
    if kind not in _CONTROLLERS:
        raise Error(f"log: got controller '{kind}', expected {' or '.join(_CONTROLLERS)}")
    controller, options_class = _CONTROLLERS[kind]
    return controller(robot, gains, options_from_json(options, options_class()))  # type: ignore[arg-type]


def controller_kind(options: Options) -> str:
    """Return the kind of controller that options are for; raises Error."""
    for kind, (_, options_class) in _CONTROLLERS.items():
        if isinstance(options, options_class):
            return kind
    expected = " or ".join(options_class.__name__ for _, options_class in _CONTROLLERS.values())
    raise Error(f"options: got {type(options).__name__}, expected {expected}")


def recording_header(robot: Robot, gains: Gains | None, options: Options) -> dict[str, Any]:
    """Return the fields of a Tape that are known when its controller is made."""
    return {
        "kind": controller_kind(options),
        "robot": robot.name,
        "gains": gain_values(gains if gains is not None else robot.config.gains),
        "options": json_options(options),
    }

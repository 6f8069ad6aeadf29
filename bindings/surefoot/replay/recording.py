"""Recording of a controller: all its inputs in order, and all its commands."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt

from surefoot._core import (
    ControllerOptions,
    Error,
    Gains,
    Robot,
    StandController,
    Supervisor,
    SupervisorOptions,
    WalkController,
    WalkOptions,
)
from surefoot.replay.build_id import build_id
from surefoot.replay.options_json import json_options, options_from_json
from surefoot.robot.gain_files import gain_values, gains_from_values

Bytes = npt.NDArray[np.uint8]
Options = ControllerOptions | WalkOptions | SupervisorOptions
Controller = StandController | WalkController | Supervisor

_CONTROLLERS: dict[str, tuple[type[Controller], type[Options]]] = {
    "StandController": (StandController, ControllerOptions),
    "WalkController": (WalkController, WalkOptions),
    "Supervisor": (Supervisor, SupervisorOptions),
}


@dataclass(frozen=True)
class Call:
    """Call of the controller except update().

    Attributes:
        row: The call was made after update() of row - 1 and before update() of row.
        name: Name of the controller's method, one of calls.CALLS.
        argument: Argument as a JSON value; None: the method has no argument.
        answer: Name of the returned RequestStatus; "" if the method does not return a
            RequestStatus.
    """

    row: int
    name: str
    argument: Any = None
    answer: str = ""


@dataclass(frozen=True)
class Recording:
    """One run of a controller, beginning with its construction.

    The recording does not contain the model of the robot, user-defined tasks, and the calls by
    which a link reports missing samples (Supervisor.update_without_state(), lose(),
    count_samples()).

    Attributes:
        kind: "StandController", "WalkController" or "Supervisor".
        robot: Name of the robot.
        gains: Gains passed to the constructor, by name.
        options: Options passed to the constructor, by name.
        samples: (n, 937) bytes of the LowStates, one row per update().
        commands: (n, 734) bytes of the returned LowCmds.
        calls: Calls except update(), in the order in which they were made.
        build: build_id() of the library that made the recording.
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
        """Construct the recorded controller again, in its initial state.

        Raises:
            Error: The robot has another name, or the gains or options are invalid.
        """
        if robot.name != self.robot:
            raise Error(f"robot: got '{robot.name}', expected '{self.robot}' as in the log")
        return make_controller(robot, gains_from_values(self.gains), self.kind, self.options)


def make_controller(robot: Robot, gains: Gains, kind: str, options: dict[str, Any]) -> Controller:
    """Construct a controller.

    Args:
        robot: Model of the robot.
        gains: Gains of the controller.
        kind: "StandController", "WalkController" or "Supervisor".
        options: Options as JSON values by name.

    Raises:
        Error: The kind is unknown, or the options are invalid.
    """
    if kind not in _CONTROLLERS:
        raise Error(f"log: got controller '{kind}', expected {' or '.join(_CONTROLLERS)}")
    controller, options_class = _CONTROLLERS[kind]
    return controller(
        robot,
        gains,
        options_from_json(options, options_class()),  # type: ignore[arg-type]
    )


def controller_kind(options: Options) -> str:
    """Return the kind of the controller that has these options.

    Raises:
        Error: `options` is of another class.
    """
    for kind, (_, options_class) in _CONTROLLERS.items():
        if isinstance(options, options_class):
            return kind
    expected = " or ".join(options_class.__name__ for _, options_class in _CONTROLLERS.values())
    raise Error(f"options: got {type(options).__name__}, expected {expected}")


def recording_header(robot: Robot, gains: Gains | None, options: Options) -> dict[str, Any]:
    """Return the fields of a Recording that are known when the controller is constructed."""
    return {
        "kind": controller_kind(options),
        "robot": robot.name,
        "gains": gain_values(gains if gains is not None else robot.config.gains),
        "options": json_options(options),
    }

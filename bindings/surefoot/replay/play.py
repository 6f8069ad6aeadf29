"""Replay of a recording through a new controller, with a comparison of all commands."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from surefoot._core import Error, LowState, Robot
from surefoot.messages.low_cmd_layout import LOW_CMD
from surefoot.messages.low_state_layout import LOW_STATE
from surefoot.replay.build_id import build_id
from surefoot.replay.calls import repeat_call
from surefoot.replay.recording import Bytes, Call, Recording

Progress = Callable[[str, int, int], None]
"""Function that receives the name of an activity, the steps done, and the total of its steps."""


@dataclass(frozen=True)
class Difference:
    """First difference between a recording and its replay.

    Attributes:
        row: Row of the recording; the number of rows if a call after the last update() differs.
        tick: LowState.tick of this row [ms]; of the last row for a call after the last update().
        field: Field of LowCmd, such as motorCmd[4].tau, or "answer of NAME()" for a call.
        logged: Value in the recording.
        replayed: Value in the replay.
    """

    row: int
    tick: int
    field: str
    logged: Any
    replayed: Any


@dataclass(frozen=True)
class Replay:
    """Result of a replay.

    Attributes:
        commands: (n, 734) bytes of the replayed LowCmds.
        differing: Number of rows whose commands differ in any byte.
        first: First difference; None if all commands and answers are identical.
        same_build: True if the recording was made with the same build of the library.
    """

    commands: Bytes
    differing: int
    first: Difference | None
    same_build: bool


def play(recording: Recording, robot: Robot, progress: Progress | None = None) -> Replay:
    """Replay a whole recording, also after the first difference.

    Args:
        recording: Recording to replay.
        robot: Model of the robot, with the name in the recording.
        progress: Function that is called as progress("replay", done, total) after each tick.

    Raises:
        Error: `recording` is not a Recording, the robot has another name, or the recording has
            invalid gains, options or calls.
    """
    if not isinstance(recording, Recording):
        raise Error(
            f"recording: got {type(recording).__name__}, expected a Recording of read_recording()"
        )
    controller = recording.make(robot)
    calls: dict[int, list[Call]] = {}
    for call in recording.calls:
        calls.setdefault(call.row, []).append(call)
    commands = np.zeros_like(recording.commands)
    answer_differences: list[Difference] = []
    state, ticks = LowState(), recording.samples.view(LOW_STATE)[:, 0]["tick"]

    def repeat_calls(k: int) -> None:
        for call in calls.get(k, ()):
            answer = repeat_call(controller, call.name, call.argument)
            if answer != call.answer:
                field = f"answer of {call.name}()"
                tick = int(ticks[min(k, len(ticks) - 1)])
                answer_differences.append(Difference(k, tick, field, call.answer, answer))

    for k, sample in enumerate(recording.samples):
        repeat_calls(k)
        state.raw[:] = sample
        commands[k] = controller.update(state).raw
        if progress is not None:
            progress("replay", k + 1, len(commands))
    repeat_calls(len(commands))  # after the last update
    rows = np.flatnonzero((commands != recording.commands).any(axis=1))
    differences = answer_differences[:1]
    if len(rows) and not (differences and differences[0].row <= rows[0]):
        k = int(rows[0])
        differences = [_difference(k, int(ticks[k]), recording.commands[k], commands[k])]
    first = differences[0] if differences else None
    return Replay(commands, len(rows), first, recording.build == build_id())


def _difference(row: int, tick: int, logged: Bytes, replayed: Bytes) -> Difference:
    """Return the difference in the first field in which two commands differ."""
    byte = int(np.flatnonzero(logged != replayed)[0])
    name, kind, start = field_at(LOW_CMD, byte)
    span = slice(start, start + kind.itemsize)
    logged_value, replayed_value = (
        np.ascontiguousarray(c[span]).view(kind)[0].item() for c in (logged, replayed)
    )
    return Difference(row, tick, name.removeprefix("."), logged_value, replayed_value)


def field_at(layout: np.dtype[Any], byte: int) -> tuple[str, np.dtype[Any], int]:
    """Return name, type and first byte of the field that contains a byte of a struct.

    Args:
        layout: Type of the struct.
        byte: Number of the byte, from 0.
    """
    if layout.subdtype is not None:
        element = layout.subdtype[0]
        index, offset = divmod(byte, element.itemsize)
        name, kind, start = field_at(element, offset)
        return f"[{index}]{name}", kind, index * element.itemsize + start
    for part, entry in (layout.fields or {}).items():
        inner, field_start = entry[0], entry[1]
        if field_start <= byte < field_start + inner.itemsize:
            name, kind, start = field_at(inner, byte - field_start)
            return f".{part}{name}", kind, field_start + start
    return "", layout, 0

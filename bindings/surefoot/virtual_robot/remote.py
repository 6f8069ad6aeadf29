"""Wireless remote: its state, and scripts of its operation."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from surefoot._core import Button, Error, WirelessRemote
from surefoot.robot.robot_toml import suggest

# Axes of wirelessRemote, with positions -1 .. 1: x and y of both sticks, and the analogue trigger
# L2. The trigger also has a button L2.
AXES = ("lx", "ly", "rx", "ry", "L2")
_BUTTONS = {name.upper(): button for name, button in Button.__members__.items()}


@dataclass(frozen=True)
class RemoteEvent:
    """One operation of the remote: a button is pressed or released, or an axis is moved.

    Attributes:
        time: Time of the operation [s].
        action: "press", "release", or the axis that is moved: "lx", "ly" (left stick), "rx", "ry"
            (right stick), "L2" (trigger).
        button: Button that is pressed or released; None if an axis is moved.
        value: New position of the axis, -1 .. 1; unused for a button.
    """

    time: float
    action: str
    button: Button | None = None
    value: float = 0.0


def read_remote_script(path: str | Path) -> tuple[RemoteEvent, ...]:
    """Read a script with lines "TIME press A", "TIME release A", "TIME lx 0.5"; # is a comment.

    Returns:
        Events in order of time.

    Raises:
        Error: The file cannot be read, or a line is invalid; the message has the line number.
    """
    try:
        lines = Path(path).read_text(encoding="utf-8-sig").splitlines()
    except (OSError, UnicodeDecodeError) as problem:
        reason = getattr(problem, "strerror", None) or "it is not text"
        raise Error(f"remote: cannot read '{path}': {reason}") from None
    events = []
    for number, line in enumerate(lines, start=1):
        words = line.partition("#")[0].split()
        if not words:
            continue
        try:
            events.append(parse_event(words))
        except Error as problem:
            raise Error(f"remote: {path}, line {number}: {problem}") from None
    return tuple(sorted(events, key=lambda event: event.time))


def parse_event(words: Sequence[str]) -> RemoteEvent:
    """Parse the words of one line of a script.

    Raises:
        Error: The words are not an operation of the remote, or a value is out of range.
    """
    if len(words) != 3:
        raise Error(
            f"got {len(words)} words, expected TIME press|release BUTTON or TIME AXIS POSITION"
        )
    time, action, argument = _number("time", words[0], 0.0, 1e9), words[1], words[2]
    if action in AXES:
        return RemoteEvent(time, action, value=_number(action, argument, -1.0, 1.0))
    if action not in ("press", "release"):
        valid = ("press", "release", *AXES)
        raise Error(f"got '{action}'{suggest(action, valid)}, expected one of {', '.join(valid)}")
    if argument.upper() not in _BUTTONS:
        raise Error(f"got button '{argument}', expected one of {', '.join(_BUTTONS)}")
    return RemoteEvent(time, action, _BUTTONS[argument.upper()])


def _number(name: str, word: str, low: float, high: float) -> float:
    try:
        value = float(word)
    except ValueError:
        value = float("nan")
    if not low <= value <= high:
        raise Error(f"{name}: got '{word}', expected a number from {low:g} to {high:g}")
    return value


class Remote:
    """Present state of the remote.

    Args:
        events: Events of a script, in order of time.

    Attributes:
        bytes: The 40 bytes of LowState.wirelessRemote; None before the first event.
    """

    def __init__(self, events: Sequence[RemoteEvent] = ()) -> None:
        self._events, self._next_event = events, 0
        self._state = WirelessRemote()
        self.bytes: bytes | None = None

    def advance(self, time: float) -> None:
        """Apply the events of the script up to a time [s]."""
        while self._next_event < len(self._events) and self._events[self._next_event].time <= time:
            self.apply(self._events[self._next_event])
            self._next_event += 1

    def apply(self, event: RemoteEvent) -> None:
        """Apply an event to the state."""
        state = self._state
        if event.button is None:
            setattr(state, event.action, event.value)
        elif event.action == "press":
            state.press(event.button)
        else:
            state.buttons &= ~event.button.value & 0xFFFF
        self.bytes = state.to_bytes()

    def stick(self, name: str) -> float:
        """Return the present position of an axis, -1 .. 1."""
        return float(getattr(self._state, name))

"""Find the column and the component that a name in a log refers to.

All common spellings are accepted. A name has three parts: an optional field path of the SDK, the
column's name or an alias (upper or lower case), and an optional component. Examples:
`accelerometer_0`, `imu.accelerometer[0]`, `acc.x`, `quat_w`, `q_FR_hip_joint`, `motorState[3].q`,
`motorState_3_q`, `footForce_RL`, `truth_foot_forces_FR_z`. The path may begin with a topic or a
variable: `/lowstate/motor_state[3]/q`, `field.imu.quaternion0`. foreign_names.py has the names of
other tools.
"""

from __future__ import annotations

import re

from surefoot.messages.low_state_layout import LEGS
from surefoot.sensor_log.column_definitions import (
    COLUMN_BY_NAME,
    COLUMNS,
    JOINTS,
    MOTOR_NAMES,
    Column,
)
from surefoot.sensor_log.foreign_names import find_foreign

_FIELD = r"(?:tick$|gyro|acc|quat|foot_?force|motor_?state)"
_PATH = re.compile(
    rf"^/?(?:(?:.*[./])?imu(?:_?state)?[._/]|.*[./](?={_FIELD})|low_?state[._/])?"
    r"(?:motor_?state[._/](?=[a-z]))?"
)
_MOTOR = re.compile(r"^motor_?state[._\[/]?(\d+)\]?[._/](\w+)$")
_NAMES = sorted(
    ((name, column) for column in COLUMNS for name in (column.name.lower(), *column.aliases)),
    key=lambda pair: -len(pair[0]),
)


def find_column(text: str) -> tuple[Column, int | None] | None:
    """Return the column and component that a name refers to, or None if the name is unknown.

    The component is None if the name refers to the whole column. For a column of width 1, the
    component may be 0 or None, with the same meaning.
    """
    return _find_own(text) or _find_foreign(text)


def _find_foreign(text: str) -> tuple[Column, int | None] | None:
    found = find_foreign(text.strip().lower())
    return None if found is None else (COLUMN_BY_NAME[found[0]], found[1])


def _find_own(text: str) -> tuple[Column, int | None] | None:
    word = _PATH.sub("", text.strip().lower())
    motor = _MOTOR.match(word)
    if motor:
        column = _column_named(motor.group(2))
        index = int(motor.group(1))
        known = column is not None and column.labels == MOTOR_NAMES and index < column.width
        return (column, index) if column is not None and known else None
    for name, column in _NAMES:  # longest first: footforceest, then footforce
        if word.startswith(name):
            rest = word[len(name) :]
            if not rest:
                return column, None
            component = _component(column, rest)
            if component is not None:
                return column, component
    return None


def _column_named(word: str) -> Column | None:
    return next((column for name, column in _NAMES if name == word), None)


def _component(column: Column, rest: str) -> int | None:
    """Return the component that `rest`, the text after a column's name, means; None if unknown."""
    if not (rest[0] in "_.[/ " or rest[0].isdigit()):
        return None
    words = [word for word in re.split(r"[_.\[\]/ ]+", rest) if word and word != "joint"]
    if len(words) == 1 and words[0].isdigit():
        index = int(words[0])
        return index if index < column.width else None
    names = [_label_part(part, column, k) for k, part in enumerate(words)]
    label = "_".join(name for name in names if name is not None).lower()
    labels = [entry.lower() for entry in column.labels]
    return labels.index(label) if None not in names and label in labels else None


def _label_part(part: str, column: Column, place: int) -> str | None:
    """Return one part of a component's label, with a joint or axis number replaced by its name.

    Example: the part "0" of q_FR_0 becomes "hip".
    """
    if not part.isdigit() or place == 0:
        return part
    parts = JOINTS if column.labels == MOTOR_NAMES else ("x", "y", "z")
    of_legs = len(column.labels) == len(LEGS) * len(parts)
    return parts[int(part)] if of_legs and int(part) < len(parts) else None

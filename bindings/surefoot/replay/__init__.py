"""Replay: what a controller was told, told to a fresh one; are its commands the same?"""

from surefoot.replay.file import read_tape, tape_columns, write_tape
from surefoot.replay.play import Difference, Replay, play
from surefoot.replay.recorder import Recorder
from surefoot.replay.tape import Call, Tape

__all__ = [
    "Call",
    "Difference",
    "Recorder",
    "Replay",
    "Tape",
    "play",
    "read_tape",
    "tape_columns",
    "write_tape",
]

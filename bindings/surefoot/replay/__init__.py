"""Recording of a controller, and replay: runs a new controller on the recorded inputs.

A replay compares the commands of the new controller with the recorded ones.
"""

from surefoot.replay.play import Difference, Replay, play
from surefoot.replay.recorder import Recorder
from surefoot.replay.recording import Call, Recording
from surefoot.replay.recording_file import read_recording, recording_columns, write_recording

__all__ = [
    "Call",
    "Difference",
    "Recorder",
    "Recording",
    "Replay",
    "play",
    "read_recording",
    "recording_columns",
    "write_recording",
]

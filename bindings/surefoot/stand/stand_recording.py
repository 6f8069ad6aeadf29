"""Recording of a run for surefoot replay."""

from __future__ import annotations

from surefoot.replay import Call, Recording
from surefoot.replay.calls import json_argument
from surefoot.replay.recording import recording_header
from surefoot.stand.reference_request import body_references
from surefoot.stand.sensor_recorder import SensorRecorder
from surefoot.stand.stand_log import StandLog


def stand_recording(log: StandLog, sensors: SensorRecorder) -> Recording:
    """Return the recording of a run: the controller's inputs and its commands.

    Args:
        log: Log of the run.
        sensors: Recorder that was passed to the same run.
    """
    settings = log.settings
    calls = tuple(
        Call(row, "set_body_reference", json_argument("set_body_reference", body))
        for row, body in sorted(body_references(settings.references, log.rate).items())
        if row < len(log.commands)
    )
    header = recording_header(log.robot, settings.gains, settings.options)
    return Recording(**header, samples=sensors.low_states, commands=log.commands, calls=calls)

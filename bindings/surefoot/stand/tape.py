"""A run as a tape that surefoot replay plays."""

from __future__ import annotations

from surefoot.replay import Call, Tape
from surefoot.replay.calls import plain_argument
from surefoot.replay.tape import head
from surefoot.stand.log import StandLog
from surefoot.stand.references import body_references
from surefoot.stand.sensor_recorder import SensorRecorder


def stand_tape(log: StandLog, sensors: SensorRecorder) -> Tape:
    """Return what went into the controller of a run, and its commands.

    Args:
        log: Of the run.
        sensors: That was given to the same run.
    """
    settings = log.settings
    calls = tuple(
        Call(row, "set_body_reference", plain_argument("set_body_reference", body))
        for row, body in sorted(body_references(settings.references, log.rate).items())
        if row < len(log.commands)
    )
    made = head(log.robot, settings.gains, settings.options)
    return Tape(**made, reports=sensors.reports, commands=log.commands, calls=calls)

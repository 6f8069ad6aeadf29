"""The stand: a robot under its controller in simulation, logged, measured and reported."""

from surefoot.stand.fields import FIELDS
from surefoot.stand.log import StandLog
from surefoot.stand.loop import run_stand
from surefoot.stand.metrics import summarise
from surefoot.stand.pushes import PushRequest, parse_push
from surefoot.stand.references import ReferenceRequest, parse_reference
from surefoot.stand.sensor_recorder import SensorRecorder
from surefoot.stand.settings import StandSettings
from surefoot.stand.tape import stand_tape
from surefoot.summary_field import Field

__all__ = [
    "FIELDS",
    "Field",
    "PushRequest",
    "ReferenceRequest",
    "SensorRecorder",
    "StandLog",
    "StandSettings",
    "parse_push",
    "parse_reference",
    "run_stand",
    "stand_tape",
    "summarise",
]

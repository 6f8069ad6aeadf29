"""The stand: a robot under its controller in simulation, logged, measured and reported."""

from surefoot.stand.fields import FIELDS, Field
from surefoot.stand.log import StandLog
from surefoot.stand.loop import run_stand
from surefoot.stand.metrics import summarise
from surefoot.stand.pushes import PushRequest, parse_push
from surefoot.stand.settings import StandSettings

__all__ = [
    "FIELDS",
    "Field",
    "PushRequest",
    "StandLog",
    "StandSettings",
    "parse_push",
    "run_stand",
    "summarise",
]

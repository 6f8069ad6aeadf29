"""Stand: a simulated run of a standing robot, with its log, its metrics and its report."""

from surefoot.reports.summary_field import Field
from surefoot.stand.metrics import summarise
from surefoot.stand.push_request import PushRequest, parse_push
from surefoot.stand.reference_request import ReferenceRequest, parse_reference
from surefoot.stand.sensor_recorder import SensorRecorder
from surefoot.stand.settings import StandSettings
from surefoot.stand.simulation_log import SimulationLog
from surefoot.stand.simulation_loop import run_stand
from surefoot.stand.simulation_settings import SimulationSettings
from surefoot.stand.stand_log import StandLog
from surefoot.stand.stand_recording import stand_recording
from surefoot.stand.summary_fields import FIELDS

__all__ = [
    "FIELDS",
    "Field",
    "PushRequest",
    "ReferenceRequest",
    "SensorRecorder",
    "SimulationLog",
    "SimulationSettings",
    "StandLog",
    "StandSettings",
    "parse_push",
    "parse_reference",
    "run_stand",
    "stand_recording",
    "summarise",
]

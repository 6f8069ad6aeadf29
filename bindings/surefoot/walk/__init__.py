"""Walk: a simulated run of a walking robot, with its log, its metrics and its report."""

from surefoot.walk.metrics import summarise
from surefoot.walk.settings import WalkSettings
from surefoot.walk.simulation_loop import run_walk, simulate_walk
from surefoot.walk.summary_fields import FIELDS
from surefoot.walk.velocity_request import VelocityRequest, parse_velocity
from surefoot.walk.walk_log import WalkLog

__all__ = [
    "FIELDS",
    "VelocityRequest",
    "WalkLog",
    "WalkSettings",
    "parse_velocity",
    "run_walk",
    "simulate_walk",
    "summarise",
]

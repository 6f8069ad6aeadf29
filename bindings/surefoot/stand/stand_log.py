"""Log of a stand, tick by tick."""

from __future__ import annotations

from dataclasses import dataclass

from surefoot.stand.settings import StandSettings
from surefoot.stand.simulation_log import SimulationLog


@dataclass(frozen=True)
class StandLog(SimulationLog):
    """Log of one stand: the arrays of SimulationLog.

    Attributes:
        settings: Settings of the run.
    """

    settings: StandSettings

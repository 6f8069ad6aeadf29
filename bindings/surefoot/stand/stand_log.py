"""Log of a stand, tick by tick."""

from __future__ import annotations

from dataclasses import dataclass

from surefoot.stand.settings import StandSettings
from surefoot.stand.simulation_log import IntArray, SimulationLog


@dataclass(frozen=True)
class StandLog(SimulationLog):
    """Log of one stand: the arrays of SimulationLog, and the reach of the body reference.

    Attributes:
        settings: Settings of the run.
        reach: (n,) surefoot.ReachLimit that stops the body reference before its target.
        reach_motor: (n,) motor whose joint limit stops the body reference; -1: none.
    """

    settings: StandSettings
    reach: IntArray
    reach_motor: IntArray

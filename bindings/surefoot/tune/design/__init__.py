"""Gains and stability margins for requested frequency and damping, from a model of the loop.

docs/how-to/design-gains.md derives the model. Needs CasADi: ``pip install surefoot[tune]``.
"""

from surefoot.tune.design.closed_loop import ClosedLoop
from surefoot.tune.design.directions import AXES, Direction, StandingBody
from surefoot.tune.design.gain_design import AxisDesign, Design, design_gains
from surefoot.tune.design.goals import Goal, parse_goal
from surefoot.tune.design.margins import (
    Margins,
    delay_margin,
    gain_margins,
    max_stable_frequency,
    oscillation_boundary,
)
from surefoot.tune.design.settings import DesignSettings
from surefoot.tune.design.standing_body import compute_standing_body
from surefoot.tune.design.timing import Observers, Timing

__all__ = [
    "AXES",
    "AxisDesign",
    "ClosedLoop",
    "Design",
    "DesignSettings",
    "Direction",
    "Goal",
    "Margins",
    "Observers",
    "StandingBody",
    "Timing",
    "compute_standing_body",
    "delay_margin",
    "design_gains",
    "gain_margins",
    "max_stable_frequency",
    "oscillation_boundary",
    "parse_goal",
]

"""Gains and margins from frequency, damping and delay: a model of the sampled closed loop.

docs/tuning-design.md derives the model. Needs CasADi: ``pip install surefoot[tune]``.
"""

from surefoot.tune.design.axes import AXES, Body, Direction
from surefoot.tune.design.design import AxisDesign, Design, design_gains
from surefoot.tune.design.goals import Goal, parse_goal
from surefoot.tune.design.loop import ClosedLoop
from surefoot.tune.design.margins import (
    Margins,
    delay_margin,
    gain_margins,
    greatest_frequency,
    oscillation_boundary,
)
from surefoot.tune.design.measure import measure_body
from surefoot.tune.design.settings import DesignSettings
from surefoot.tune.design.timing import Observers, Timing

__all__ = [
    "AXES",
    "AxisDesign",
    "Body",
    "ClosedLoop",
    "Design",
    "DesignSettings",
    "Direction",
    "Goal",
    "Margins",
    "Observers",
    "Timing",
    "delay_margin",
    "design_gains",
    "gain_margins",
    "greatest_frequency",
    "measure_body",
    "oscillation_boundary",
    "parse_goal",
]

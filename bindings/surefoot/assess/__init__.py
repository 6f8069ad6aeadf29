"""Scorecards of a quadruped that stands or walks, for any controller LowState -> LowCmd."""

from surefoot.assess.condition import Condition
from surefoot.assess.controller_under_test import ControllerUnderTest
from surefoot.assess.run import run_assess
from surefoot.assess.scorecard import Scorecard, read_scorecard, standard_scorecard
from surefoot.assess.scorecard_text import assess_text
from surefoot.assess.settings import AssessSettings
from surefoot.assess.walking.walk_scorecard import (
    WalkScorecard,
    read_walk_scorecard,
    standard_walk_scorecard,
)
from surefoot.assess.walking.walk_text import walk_text

__all__ = [
    "AssessSettings",
    "Condition",
    "ControllerUnderTest",
    "Scorecard",
    "WalkScorecard",
    "assess_text",
    "read_scorecard",
    "read_walk_scorecard",
    "run_assess",
    "standard_scorecard",
    "standard_walk_scorecard",
    "walk_text",
]

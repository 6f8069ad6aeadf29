"""Push and stand scorecard of a quadruped, the same for any controller LowState -> LowCmd."""

from surefoot.assess.condition import Condition
from surefoot.assess.controller_under_test import ControllerUnderTest
from surefoot.assess.run import run_assess
from surefoot.assess.scorecard import Scorecard, read_scorecard, standard_scorecard
from surefoot.assess.scorecard_text import assess_text
from surefoot.assess.settings import AssessSettings

__all__ = [
    "AssessSettings",
    "Condition",
    "ControllerUnderTest",
    "Scorecard",
    "assess_text",
    "read_scorecard",
    "run_assess",
    "standard_scorecard",
]

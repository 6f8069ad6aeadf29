"""The scorecard of a standing quadruped: the same table for any callable LowState -> LowCmd."""

from surefoot.assess.card import Card, read_card, standard_card
from surefoot.assess.condition import Condition
from surefoot.assess.contestant import Contestant
from surefoot.assess.run import run_assess
from surefoot.assess.settings import AssessSettings
from surefoot.assess.text import assess_text

__all__ = [
    "AssessSettings",
    "Card",
    "Condition",
    "Contestant",
    "assess_text",
    "read_card",
    "run_assess",
    "standard_card",
]

"""Result of one check of surefoot doctor."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum


class Verdict(Enum):
    """Judgement of a check."""

    GOOD = "good"
    LIMITED = "limited"  # Surefoot works, but some feature or its timing does not
    BAD = "bad"  # Surefoot does not work as installed
    INFO = "info"  # not judged


@dataclass(frozen=True)
class Finding:
    """Result of one check.

    Attributes:
        area: One of AREAS.
        subject: What was checked.
        value: What was found.
        verdict: Judgement.
        remedy: What to do, or what does not work; "" if there is nothing to do.
    """

    area: str
    subject: str
    value: str
    verdict: Verdict
    remedy: str = ""

"""Checks of an installation and its computer, as surefoot doctor runs them.

``diagnose()`` returns one Finding for each check: what was found, whether it is good enough, and
what to do if it is not. The checks change nothing on the computer. Real-time: no.
"""

from surefoot.doctor.diagnosis import AREAS, diagnose, findings_text
from surefoot.doctor.finding import Finding, Verdict

__all__ = ["AREAS", "Finding", "Verdict", "diagnose", "findings_text"]

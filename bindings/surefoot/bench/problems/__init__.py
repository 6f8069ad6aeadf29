"""Quadratic programs recorded tick after tick, in a plain format that others can read."""

from surefoot.bench.problems.export import export_qpbenchmark
from surefoot.bench.problems.record import check_scenario, record_problems
from surefoot.bench.problems.scenarios import SCENARIOS
from surefoot.bench.problems.sequence import Sequence, load_sequence

__all__ = [
    "SCENARIOS",
    "Sequence",
    "check_scenario",
    "export_qpbenchmark",
    "load_sequence",
    "record_problems",
]

"""Recording of the QPs of consecutive ticks, in a format that other tools can read."""

from surefoot.bench.problems.qp_sequence import QpSequence, load_sequence
from surefoot.bench.problems.qpbenchmark_export import export_qpbenchmark
from surefoot.bench.problems.record import check_scenario, record_problems
from surefoot.bench.problems.scenarios import SCENARIOS

__all__ = [
    "SCENARIOS",
    "QpSequence",
    "check_scenario",
    "export_qpbenchmark",
    "load_sequence",
    "record_problems",
]

"""Comparison of QP solvers on recorded QPs, with warm and cold starts and one common check."""

from surefoot.bench.solvers.run import run_solvers
from surefoot.bench.solvers.solver_build import SOLVERS
from surefoot.bench.solvers.solver_table import solvers_text

__all__ = ["SOLVERS", "run_solvers", "solvers_text"]

"""Comparison of QP solvers on recorded QPs, warm and cold, with one common check of residuals."""

from surefoot.bench.solvers.run import run_solvers
from surefoot.bench.solvers.solver_build import SOLVERS
from surefoot.bench.solvers.solver_table import solvers_text

__all__ = ["SOLVERS", "run_solvers", "solvers_text"]

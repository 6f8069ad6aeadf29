"""Solvers side by side on recorded programs, warm and cold, judged by one check of our own."""

from surefoot.bench.solvers.run import run_solvers
from surefoot.bench.solvers.solver_build import SOLVERS
from surefoot.bench.solvers.text import solvers_text

__all__ = ["SOLVERS", "run_solvers", "solvers_text"]

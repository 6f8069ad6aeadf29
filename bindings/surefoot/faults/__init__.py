"""Fault matrix: injects faults into a simulated, supervised robot and judges its reactions."""

from surefoot.faults.catalogue import choose_cells
from surefoot.faults.matrix.matrix_settings import FaultSettings
from surefoot.faults.matrix.matrix_text import faults_text, list_text
from surefoot.faults.matrix.run_matrix import run_faults

__all__ = ["FaultSettings", "choose_cells", "faults_text", "list_text", "run_faults"]

"""Faults, injected into a supervised robot on its plant, and what it does about them."""

from surefoot.faults.catalogue import choose_cells
from surefoot.faults.run import run_faults
from surefoot.faults.settings import FaultSettings
from surefoot.faults.text import faults_text, list_text

__all__ = ["FaultSettings", "choose_cells", "faults_text", "list_text", "run_faults"]

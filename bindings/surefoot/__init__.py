"""Whole-body torque control for Unitree quadrupeds: LowState in, LowCmd out."""

from surefoot._core import *  # noqa: F403
from surefoot.robots import available_robots, load_gains, load_robot

__all__ = [name for name in dir() if not name.startswith("_") and name not in ("robots",)]  # noqa: PLE0605

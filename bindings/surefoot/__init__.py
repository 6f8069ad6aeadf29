"""Whole-body torque control for Unitree quadrupeds: LowState in, LowCmd out."""

from surefoot._core import *  # noqa: F403

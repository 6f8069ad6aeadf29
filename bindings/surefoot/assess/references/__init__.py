"""Reference controllers for comparison: a joint PD controller, and a QP on contact forces."""

from collections.abc import Callable
from typing import Any

from surefoot._core import Robot
from surefoot.assess.references.force_qp import ForceQp
from surefoot.assess.references.joint_pd import JointPd

FACTORIES: dict[str, Callable[[Robot], Any]] = {"pd": JointPd, "force_qp": ForceQp}

__all__ = ["FACTORIES", "ForceQp", "JointPd"]

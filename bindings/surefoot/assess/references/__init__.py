"""Reference controllers for comparison: joint PD, a QP on contact forces, and a trot with it."""

from collections.abc import Callable
from typing import Any

from surefoot._core import Robot
from surefoot.assess.references.force_qp import ForceQp
from surefoot.assess.references.joint_pd import JointPd
from surefoot.assess.references.raibert import Raibert

FACTORIES: dict[str, Callable[[Robot], Any]] = {
    "pd": JointPd,
    "force_qp": ForceQp,
    "raibert": Raibert,
}

__all__ = ["FACTORIES", "ForceQp", "JointPd", "Raibert"]

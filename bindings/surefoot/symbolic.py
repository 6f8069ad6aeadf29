"""CasADi functions of a robot, for planners, identification and tuning.

Every function here makes one ``casadi.Function`` from Pinocchio's own algorithms, with the robot's
armature in it. q and v are Pinocchio's (see ``Robot``): the base's twist in base axes, joints in
Pinocchio's order. Forces and positions are in world axes unless said otherwise, feet run
FR FL RR RL and are meant by their centres. Derivatives by q are by its tangent, which has the
shape and axes of v; casadi's own derivatives of any function are by q's numbers. A quaternion is
taken to be of unit length.

Making one takes up to a second; they may be evaluated on numbers, or on SX and MX to build on.
Needs CasADi: ``pip install surefoot[tune]``. Real-time: no.
"""

from __future__ import annotations

from importlib.metadata import version
from typing import TYPE_CHECKING

from surefoot._core import Error, Robot

if TYPE_CHECKING:
    import casadi

__all__ = [
    "bias",
    "center_of_mass",
    "centroidal_matrix",
    "centroidal_momentum",
    "foot_drifts",
    "foot_jacobian",
    "foot_positions",
    "forward_dynamics",
    "forward_dynamics_derivatives",
    "inverse_dynamics",
    "inverse_dynamics_derivatives",
    "mass_matrix",
]


def mass_matrix(robot: Robot) -> casadi.Function:
    """Make M(q), shape (nv, nv), armature included; raises Error without CasADi."""
    return _function(robot, "mass_matrix")


def bias(robot: Robot) -> casadi.Function:
    """Make h(q, v), shape (nv,) [N, N.m]: Coriolis, centrifugal and gravity; raises Error."""
    return _function(robot, "bias")


def inverse_dynamics(robot: Robot) -> casadi.Function:
    """Make tau(q, v, a) = M a + h, shape (nv,) [N, N.m]; raises Error without CasADi."""
    return _function(robot, "inverse_dynamics")


def forward_dynamics(robot: Robot) -> casadi.Function:
    """Make a(q, v, tau) = M^-1 (tau - h), shape (nv,); raises Error without CasADi.

    With forces of the ground on the feet, tau is joint torques plus foot_jacobian^T times forces.
    """
    return _function(robot, "forward_dynamics")


def inverse_dynamics_derivatives(robot: Robot) -> casadi.Function:
    """Make the derivatives of inverse_dynamics by q (tangent), v and a; raises Error.

    Returns:
        A function of (q, v, a) with three outputs of shape (nv, nv); the last is M.
    """
    return _function(robot, "inverse_dynamics_derivatives")


def forward_dynamics_derivatives(robot: Robot) -> casadi.Function:
    """Make the derivatives of forward_dynamics by q (tangent), v and tau; raises Error.

    Returns:
        A function of (q, v, tau) with three outputs of shape (nv, nv); the last is M^-1.
    """
    return _function(robot, "forward_dynamics_derivatives")


def foot_positions(robot: Robot) -> casadi.Function:
    """Make p(q), shape (3, 4) [m]: the feet's centres, one a column; raises Error."""
    return _function(robot, "foot_positions")


def foot_jacobian(robot: Robot) -> casadi.Function:
    """Make J(q), shape (12, nv): the feet's centres move at J v [m/s], three rows each."""
    return _function(robot, "foot_jacobian")


def foot_drifts(robot: Robot) -> casadi.Function:
    """Make dJ/dt v of (q, v), shape (3, 4) [m/s^2], one foot a column; raises Error.

    The centres accelerate at J a + drift, with a the derivative of v.
    """
    return _function(robot, "foot_drifts")


def center_of_mass(robot: Robot) -> casadi.Function:
    """Make p_com(q), shape (3,) [m]; raises Error without CasADi."""
    return _function(robot, "center_of_mass")


def centroidal_matrix(robot: Robot) -> casadi.Function:
    """Make A(q), shape (6, nv): centroidal_momentum is A v; raises Error without CasADi."""
    return _function(robot, "centroidal_matrix")


def centroidal_momentum(robot: Robot) -> casadi.Function:
    """Make the momentum about the centre of mass of (q, v), shape (6,).

    Linear [kg.m/s], then angular [kg.m^2/s] (Orin, Goswami and Lee 2013, eq. 1); raises Error.
    """
    return _function(robot, "centroidal_momentum")


def _function(robot: Robot, name: str) -> casadi.Function:
    try:
        import casadi
    except ImportError:
        raise Error(
            "surefoot.symbolic needs CasADi, which is missing: pip install surefoot[tune]"
        ) from None
    try:
        from surefoot import _symbolic
    except ImportError as problem:
        raise Error(
            f"surefoot.symbolic cannot be loaded with CasADi {version('casadi')}: {problem}; "
            "expected the version of: pip install surefoot[tune]"
        ) from None
    text = _symbolic.robot_function(robot.serialized_model(), robot.foot_frame_ids, name)
    return casadi.Function.deserialize(text.decode("latin-1"))

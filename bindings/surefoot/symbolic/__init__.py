"""CasADi functions of a robot, for planners, identification and tuning.

Each function here returns one ``casadi.Function``; armature is included. q and v are as in
Pinocchio (see ``Robot``): base twist in base axes, joints in Pinocchio's order. Forces and
positions are in world axes unless stated otherwise. Feet are ordered FR FL RR RL; their positions
are those of the foot centres. Derivatives with respect to q are tangent derivatives, with the shape
and axes of v; CasADi's own derivatives are with respect to the numbers in q. The quaternion must
have unit length.

Building a function takes up to a second. It can be evaluated with numbers, SX or MX. Needs CasADi:
``pip install surefoot[tune]``. Real-time: no.
"""

from __future__ import annotations

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
    """Return the mass matrix M(q), shape (nv, nv), with armature.

    Raises:
        Error: CasADi is missing.
    """
    return _function(robot, "mass_matrix")


def bias(robot: Robot) -> casadi.Function:
    """Return h(q, v), shape (nv,) [N, N.m]: Coriolis, centrifugal and gravity terms.

    Raises:
        Error: CasADi is missing.
    """
    return _function(robot, "bias")


def inverse_dynamics(robot: Robot) -> casadi.Function:
    """Return tau(q, v, a) = M a + h, shape (nv,) [N, N.m].

    Raises:
        Error: CasADi is missing.
    """
    return _function(robot, "inverse_dynamics")


def forward_dynamics(robot: Robot) -> casadi.Function:
    """Return a(q, v, tau) = M^-1 (tau - h), shape (nv,) [m/s^2, rad/s^2].

    With contact forces f on the feet, pass tau = (0, joint torques) + foot_jacobian^T f.

    Raises:
        Error: CasADi is missing.
    """
    return _function(robot, "forward_dynamics")


def inverse_dynamics_derivatives(robot: Robot) -> casadi.Function:
    """Return the derivatives of inverse_dynamics with respect to q (tangent), v and a.

    Returns:
        A function of (q, v, a) with three outputs of shape (nv, nv); the last is M.

    Raises:
        Error: CasADi is missing.
    """
    return _function(robot, "inverse_dynamics_derivatives")


def forward_dynamics_derivatives(robot: Robot) -> casadi.Function:
    """Return the derivatives of forward_dynamics with respect to q (tangent), v and tau.

    Returns:
        A function of (q, v, tau) with three outputs of shape (nv, nv); the last is M^-1.

    Raises:
        Error: CasADi is missing.
    """
    return _function(robot, "forward_dynamics_derivatives")


def foot_positions(robot: Robot) -> casadi.Function:
    """Return the foot centres p(q), shape (3, 4) [m], one foot per column.

    Raises:
        Error: CasADi is missing.
    """
    return _function(robot, "foot_positions")


def foot_jacobian(robot: Robot) -> casadi.Function:
    """Return J(q), shape (12, nv): foot centres have velocity J v [m/s], three rows per foot.

    Raises:
        Error: CasADi is missing.
    """
    return _function(robot, "foot_jacobian")


def foot_drifts(robot: Robot) -> casadi.Function:
    """Return the drift dJ/dt v of (q, v), shape (3, 4) [m/s^2], one foot per column.

    The acceleration of the foot centres is J a + drift, with a = dv/dt.

    Raises:
        Error: CasADi is missing.
    """
    return _function(robot, "foot_drifts")


def center_of_mass(robot: Robot) -> casadi.Function:
    """Return the centre of mass p_com(q), shape (3,) [m].

    Raises:
        Error: CasADi is missing.
    """
    return _function(robot, "center_of_mass")


def centroidal_matrix(robot: Robot) -> casadi.Function:
    """Return A(q), shape (6, nv), with centroidal_momentum = A v.

    Raises:
        Error: CasADi is missing.
    """
    return _function(robot, "centroidal_matrix")


def centroidal_momentum(robot: Robot) -> casadi.Function:
    """Return the momentum about the centre of mass as a function of (q, v), shape (6,).

    The first three components are the linear momentum [kg.m/s], the last three the angular momentum
    [kg.m^2/s]. Source: Orin, Goswami and Lee 2013, eq. 1.

    Raises:
        Error: CasADi is missing.
    """
    return _function(robot, "centroidal_momentum")


def _function(robot: Robot, name: str) -> casadi.Function:
    try:
        import casadi  # noqa: F401
    except ImportError:
        raise Error(
            "surefoot.symbolic needs CasADi, which is missing: pip install surefoot[tune]"
        ) from None
    from surefoot.symbolic.functions import robot_function

    return robot_function(robot, name)

"""The functions of surefoot.symbolic, by name."""

from __future__ import annotations

from collections.abc import Callable

import casadi as ca

from surefoot._core import Robot
from surefoot.symbolic.joint_tree import joint_tree
from surefoot.symbolic.tree_dynamics import Expression, TreeDynamics


def robot_function(robot: Robot, name: str) -> ca.Function:
    """Build a function of a robot.

    Args:
        robot: The robot.
        name: Name of a function of surefoot.symbolic.
    """
    return _BUILDERS[name](TreeDynamics(joint_tree(robot)), name)


def _mass_matrix(dynamics: TreeDynamics) -> Expression:
    """Return M (nv, nv): the derivative of the inverse dynamics with respect to a."""
    at_rest = ca.SX(dynamics.tree.nv, 1)
    forces = dynamics.inverse_dynamics(at_rest, dynamics.a, gravity=False)
    # Both triangles are equal but for rounding.
    return ca.triu2symm(ca.triu(ca.jacobian(forces, dynamics.a)))


def _bias(dynamics: TreeDynamics) -> Expression:
    """Return h (nv,)."""
    return dynamics.inverse_dynamics(dynamics.v, ca.SX(dynamics.tree.nv, 1))


def _of_q(expression: Callable[[TreeDynamics], Expression]) -> Callable[..., ca.Function]:
    def build(dynamics: TreeDynamics, name: str) -> ca.Function:
        return ca.Function(name, [dynamics.q], [ca.densify(expression(dynamics))], ["q"], [name])

    return build


def _of_q_v(expression: Callable[[TreeDynamics], Expression]) -> Callable[..., ca.Function]:
    def build(dynamics: TreeDynamics, name: str) -> ca.Function:
        out = ca.densify(expression(dynamics))
        return ca.Function(name, [dynamics.q, dynamics.v], [out], ["q", "v"], [name])

    return build


def _inverse_dynamics(dynamics: TreeDynamics, name: str) -> ca.Function:
    tau = dynamics.inverse_dynamics(dynamics.v, dynamics.a)
    return ca.Function(name, [dynamics.q, dynamics.v, dynamics.a], [tau], ["q", "v", "a"], [name])


def _forward_dynamics(dynamics: TreeDynamics, name: str) -> ca.Function:
    tau = ca.SX.sym("tau", dynamics.tree.nv)
    a = ca.ldl_solve(tau - _bias(dynamics), *ca.ldl(_mass_matrix(dynamics)))
    return ca.Function(name, [dynamics.q, dynamics.v, tau], [a], ["q", "v", "tau"], [name])


def _inverse_dynamics_derivatives(dynamics: TreeDynamics, name: str) -> ca.Function:
    tau = dynamics.inverse_dynamics(dynamics.v, dynamics.a)
    parts = [
        ca.jacobian(tau, dynamics.q) @ dynamics.tangent_map(),
        ca.jacobian(tau, dynamics.v),
        _mass_matrix(dynamics),
    ]
    names = ["by_q", "by_v", "by_a"]
    return ca.Function(
        name,
        [dynamics.q, dynamics.v, dynamics.a],
        [ca.densify(part) for part in parts],
        ["q", "v", "a"],
        names,
    )


def _forward_dynamics_derivatives(dynamics: TreeDynamics, name: str) -> ca.Function:
    # With tau = ID(q, v, a), da/dx = -M^-1 dID/dx for x = q or v, and da/dtau = M^-1.
    tau = ca.SX.sym("tau", dynamics.tree.nv)
    a = _forward_dynamics(dynamics, name)(dynamics.q, dynamics.v, tau)
    by_q, by_v, mass = _inverse_dynamics_derivatives(dynamics, name)(dynamics.q, dynamics.v, a)
    factors = ca.ldl(ca.sparsify(mass))
    parts = [
        -ca.ldl_solve(by_q, *factors),
        -ca.ldl_solve(by_v, *factors),
        ca.ldl_solve(ca.SX.eye(dynamics.tree.nv), *factors),
    ]
    names = ["by_q", "by_v", "by_tau"]
    return ca.Function(
        name,
        [dynamics.q, dynamics.v, tau],
        [ca.densify(part) for part in parts],
        ["q", "v", "tau"],
        names,
    )


_BUILDERS: dict[str, Callable[[TreeDynamics, str], ca.Function]] = {
    "mass_matrix": _of_q(_mass_matrix),
    "bias": _of_q_v(_bias),
    "foot_positions": _of_q(TreeDynamics.foot_positions),
    "foot_jacobian": _of_q(lambda dynamics: ca.jacobian(dynamics.foot_velocities(), dynamics.v)),
    "foot_drifts": _of_q_v(TreeDynamics.foot_drifts),
    "center_of_mass": _of_q(TreeDynamics.center_of_mass),
    "centroidal_matrix": _of_q(
        lambda dynamics: ca.jacobian(dynamics.centroidal_momentum(), dynamics.v)
    ),
    "centroidal_momentum": _of_q_v(TreeDynamics.centroidal_momentum),
    "inverse_dynamics": _inverse_dynamics,
    "forward_dynamics": _forward_dynamics,
    "inverse_dynamics_derivatives": _inverse_dynamics_derivatives,
    "forward_dynamics_derivatives": _forward_dynamics_derivatives,
}

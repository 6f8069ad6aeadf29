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


def mass_matrix_of(tree: TreeDynamics) -> Expression:
    """Return M (nv, nv): the derivative of the inverse dynamics with respect to a."""
    at_rest = ca.SX(tree.tree.nv, 1)
    forces = tree.inverse_dynamics(at_rest, tree.a, gravity=False)
    # Both triangles are equal but for rounding.
    return ca.triu2symm(ca.triu(ca.jacobian(forces, tree.a)))


def bias_of(tree: TreeDynamics) -> Expression:
    """Return h (nv,)."""
    return tree.inverse_dynamics(tree.v, ca.SX(tree.tree.nv, 1))


def _of_q(expression: Callable[[TreeDynamics], Expression]) -> Callable[..., ca.Function]:
    def build(tree: TreeDynamics, name: str) -> ca.Function:
        return ca.Function(name, [tree.q], [ca.densify(expression(tree))], ["q"], [name])

    return build


def _of_q_v(expression: Callable[[TreeDynamics], Expression]) -> Callable[..., ca.Function]:
    def build(tree: TreeDynamics, name: str) -> ca.Function:
        out = ca.densify(expression(tree))
        return ca.Function(name, [tree.q, tree.v], [out], ["q", "v"], [name])

    return build


def _inverse_dynamics(tree: TreeDynamics, name: str) -> ca.Function:
    tau = tree.inverse_dynamics(tree.v, tree.a)
    return ca.Function(name, [tree.q, tree.v, tree.a], [tau], ["q", "v", "a"], [name])


def _forward_dynamics(tree: TreeDynamics, name: str) -> ca.Function:
    tau = ca.SX.sym("tau", tree.tree.nv)
    a = ca.ldl_solve(tau - bias_of(tree), *ca.ldl(mass_matrix_of(tree)))
    return ca.Function(name, [tree.q, tree.v, tau], [a], ["q", "v", "tau"], [name])


def _inverse_dynamics_derivatives(tree: TreeDynamics, name: str) -> ca.Function:
    tau = tree.inverse_dynamics(tree.v, tree.a)
    parts = [
        ca.jacobian(tau, tree.q) @ tree.tangent_map(),
        ca.jacobian(tau, tree.v),
        mass_matrix_of(tree),
    ]
    names = ["by_q", "by_v", "by_a"]
    return ca.Function(
        name, [tree.q, tree.v, tree.a], [ca.densify(part) for part in parts], ["q", "v", "a"], names
    )


def _forward_dynamics_derivatives(tree: TreeDynamics, name: str) -> ca.Function:
    # With tau = ID(q, v, a), da/dx = -M^-1 dID/dx for x = q or v, and da/dtau = M^-1.
    tau = ca.SX.sym("tau", tree.tree.nv)
    a = _forward_dynamics(tree, name)(tree.q, tree.v, tau)
    by_q, by_v, mass = _inverse_dynamics_derivatives(tree, name)(tree.q, tree.v, a)
    factors = ca.ldl(ca.sparsify(mass))
    parts = [
        -ca.ldl_solve(by_q, *factors),
        -ca.ldl_solve(by_v, *factors),
        ca.ldl_solve(ca.SX.eye(tree.tree.nv), *factors),
    ]
    names = ["by_q", "by_v", "by_tau"]
    return ca.Function(
        name, [tree.q, tree.v, tau], [ca.densify(part) for part in parts], ["q", "v", "tau"], names
    )


_BUILDERS: dict[str, Callable[[TreeDynamics, str], ca.Function]] = {
    "mass_matrix": _of_q(mass_matrix_of),
    "bias": _of_q_v(bias_of),
    "foot_positions": _of_q(TreeDynamics.foot_positions),
    "foot_jacobian": _of_q(lambda tree: ca.jacobian(tree.foot_velocities(), tree.v)),
    "foot_drifts": _of_q_v(TreeDynamics.foot_drifts),
    "center_of_mass": _of_q(TreeDynamics.center_of_mass),
    "centroidal_matrix": _of_q(lambda tree: ca.jacobian(tree.centroidal_momentum(), tree.v)),
    "centroidal_momentum": _of_q_v(TreeDynamics.centroidal_momentum),
    "inverse_dynamics": _inverse_dynamics,
    "forward_dynamics": _forward_dynamics,
    "inverse_dynamics_derivatives": _inverse_dynamics_derivatives,
    "forward_dynamics_derivatives": _forward_dynamics_derivatives,
}

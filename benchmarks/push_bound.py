# SPDX-License-Identifier: BSD-3-Clause
"""Largest push that a robot survives with all feet in place, by optimal control of its dynamics.

    python benchmarks/push_bound.py --robot go2 --heading 22.5 157.5 --tilt 5

A push lasts 0.1 s and acts through the centre of mass, as in surefoot assess. The motion is
discretised at knots, which are 10 ms apart. The motors keep the standing torques until the second
knot: 10 ms is the delay of sensors, link (two periods) and motors. Then the torques bring the body
to rest within 0.8 s. All feet stay in place, torques stay within their limits, forces within the
friction cone, and the trunk within --tilt of level.

Unlike a real controller, the optimal control knows when the push ends, and has no motor lag and no
joint limits. A real robot may survive more, because its feet may slide or step, it may tilt more,
and joint friction adds to the motor torques. IPOPT, the solver, finds a local optimum. If IPOPT
fails, the figure is nan, and the status of IPOPT states the reason. The optimisation of one push
takes about a minute. The benchmark needs CasADi.
"""

from __future__ import annotations

import argparse
import math
import sys
from dataclasses import dataclass
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import casadi as ca
import numpy as np
from seed_runs import ROBOTS
from surefoot import Robot, load_robot, symbolic
from surefoot.assess.push_limits import push_limit
from surefoot.assess.stance_model import stance_model

KNOT_TIME = 0.01  # [s] time between two knots
PUSH_TIME = 0.1  # [s] duration of a push
KNOTS = 80  # number of knots after which the robot must be at rest
FORCE_UNIT, TORQUE_UNIT = 10.0, 5.0  # [N], [N.m] units of the optimisation variables
IMPULSE_WEIGHT = 0.1  # [1/(N.s)] weight of the impulse in the cost
# Weights of squared velocities and of squared scaled torques; they make the optimum unique.
REGULARISATION = (1e-5, 1e-6)
IPOPT = {
    "max_iter": 600,
    "print_level": 0,
    "sb": "yes",
    "mu_strategy": "monotone",
    "tol": 1e-5,
    "constr_viol_tol": 1e-6,
    "acceptable_tol": 1e-3,
    "acceptable_constr_viol_tol": 1e-6,
}


@dataclass(frozen=True)
class Case:
    """Direction and conditions of one push."""

    heading: float  # [deg] from forward towards left
    tilt: float  # [deg] largest allowed tilt of the trunk
    friction: float  # friction coefficient of the floor


def rotation(quaternion: ca.SX) -> ca.SX:
    """Return the rotation matrix of a quaternion x y z w."""
    x, y, z, w = ca.vertsplit(quaternion)
    return ca.vertcat(
        ca.horzcat(1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)),
        ca.horzcat(2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)),
        ca.horzcat(2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)),
    )


def integrator(robot: Robot) -> ca.Function:
    """Return a function from (q, v) to q one knot later; it normalises the quaternion."""
    q, v = ca.SX.sym("q", robot.nq), ca.SX.sym("v", robot.nv)
    p = q[:3] + KNOT_TIME * rotation(q[3:7]) @ v[:3]
    half = 0.5 * KNOT_TIME * v[3:6]
    xyz = q[3:6] + q[6] * half + ca.cross(q[3:6], half)
    turned = ca.vertcat(xyz, q[6] - ca.dot(q[3:6], half))
    after = ca.vertcat(p, turned / ca.norm_2(turned), q[7:] + KNOT_TIME * v[6:])
    return ca.Function("integration", [q, v], [after])


def contact_jacobian(robot: Robot) -> ca.Function:
    """Return a function J(q), (12, nv), for contact points of rolling feet: J_c + r [z]x J_w.

    J_c is the Jacobian of the foot centres, J_w that of the angular velocities of the feet, and r
    is the foot radius.
    """
    q = ca.SX.sym("q", robot.nq)
    R = rotation(q[3:7])
    radius_cross = robot.config.foot_radius * ca.DM([[0, -1, 0], [1, 0, 0], [0, 0, 0]])
    rows = []
    for leg in range(4):
        columns = [int(robot.motor_to_v[3 * leg + k]) for k in range(3)]
        hip = q[columns[0] + 1]
        pitch = ca.vertcat(0, ca.cos(hip), ca.sin(hip))
        angular_jacobian = ca.SX.zeros(3, robot.nv)
        angular_jacobian[:, 3:6] = R
        for column, axis in zip(columns, (ca.DM([1, 0, 0]), pitch, pitch), strict=True):
            angular_jacobian[:, column] = R @ axis
        rows.append(radius_cross @ angular_jacobian)
    return ca.Function("contact", [q], [symbolic.foot_jacobian(robot)(q) + ca.vertcat(*rows)])


def dynamics_residual(robot: Robot, contact: ca.Function, heading: float) -> ca.Function:
    """Return the residual of the equations of motion as a function.

    Its arguments are q, v, v one knot later, tau, contact forces and push.
    """
    q, v, after = (ca.SX.sym(n, k) for n, k in (("q", robot.nq), ("v", robot.nv), ("w", robot.nv)))
    tau, f, push = ca.SX.sym("tau", 12), ca.SX.sym("f", 12), ca.SX.sym("push")
    select = np.zeros((robot.nv, 12))
    select[np.array(robot.motor_to_v), range(12)] = 1.0
    along = ca.DM([math.cos(math.radians(heading)), math.sin(math.radians(heading)), 0.0])
    com = symbolic.centroidal_matrix(robot)(q)[:3, :] / robot.mass
    required_force = symbolic.inverse_dynamics(robot)(q, after, (after - v) / KNOT_TIME)
    applied_force = ca.DM(select) @ tau + contact(q).T @ f + com.T @ (along * push)
    return ca.Function(
        "dynamics", [q, v, after, tau, f, push], [(required_force - applied_force) / FORCE_UNIT]
    )


def standing_forces(robot: Robot, contact: ca.Function) -> tuple[np.ndarray, np.ndarray]:
    """Return least-squares forces (12,) [N] and torques (12,) [N.m] that hold the standing pose."""
    q = np.array(robot.q_standing())
    J = contact(q).full()
    h = symbolic.bias(robot)(q, np.zeros(robot.nv)).full().ravel()
    f = np.linalg.lstsq(J[:, :6].T, h[:6], rcond=None)[0]
    return f, (h - J.T @ f)[np.array(robot.motor_to_v)]


class PushOcp:
    """Optimal control problem of one push.

    Args:
        case: Push and conditions.
        robot: Robot that is pushed.
    """

    def __init__(self, case: Case, robot: Robot) -> None:
        self.case = case
        self.opti = ca.Opti()
        self.impulse = self.opti.variable()
        self.q = self.opti.variable(robot.nq, KNOTS + 1)
        self.v = self.opti.variable(robot.nv, KNOTS + 1)
        self.tau = self.opti.variable(12, KNOTS)
        self.f = self.opti.variable(12, KNOTS)
        self.contact = contact_jacobian(robot)
        self.dynamics = dynamics_residual(robot, self.contact, case.heading)
        self.step = integrator(robot)
        self.tau_limit = np.array(robot.config.tau_max) / TORQUE_UNIT
        self.q_rest = np.array(robot.q_standing())
        self.f_rest, self.tau_rest = standing_forces(robot, self.contact)

    def largest_impulse(self, guess: float) -> tuple[float, str]:
        """Return the largest impulse [N.s] (NaN if IPOPT fails), and the status of IPOPT.

        Args:
            guess: Initial guess of the impulse [N.s].
        """
        opti = self.opti
        opti.subject_to(self.q[:, 0] == self.q_rest)
        opti.subject_to(self.v[:, 0] == 0)
        opti.subject_to(ca.vec(self.v[:, KNOTS - 1 :]) == 0)
        opti.subject_to(self.tau[:, 0] == self.tau_rest / TORQUE_UNIT)
        for k in range(KNOTS):
            self._add_dynamics(k)
            self._add_force_limits(k)
        small = REGULARISATION[0] * ca.sumsqr(self.v) + REGULARISATION[1] * ca.sumsqr(self.tau)
        opti.minimize(small - IMPULSE_WEIGHT * self.impulse)
        opti.set_initial(self.q, np.tile(self.q_rest[:, None], KNOTS + 1))
        opti.set_initial(self.f, np.tile(self.f_rest[:, None] / FORCE_UNIT, KNOTS))
        opti.set_initial(self.tau, np.tile(self.tau_rest[:, None] / TORQUE_UNIT, KNOTS))
        opti.set_initial(self.impulse, guess)
        opti.solver("ipopt", {"expand": True, "print_time": False}, IPOPT)
        try:
            found = float(opti.solve().value(self.impulse))
        except RuntimeError:  # the last iterate of a failed solve may violate all constraints
            found = math.nan
        return found, str(opti.return_status())

    def _add_dynamics(self, k: int) -> None:
        q, v, after = self.q[:, k], self.v[:, k], self.v[:, k + 1]
        push = self.impulse / PUSH_TIME if k < round(PUSH_TIME / KNOT_TIME) else 0.0
        tau, f = TORQUE_UNIT * self.tau[:, k], FORCE_UNIT * self.f[:, k]
        self.opti.subject_to(self.dynamics(q, v, after, tau, f, push) == 0)
        self.opti.subject_to(self.q[:, k + 1] == self.step(q, after))
        self.opti.subject_to(self.contact(q) @ after == 0)

    def _add_force_limits(self, k: int) -> None:
        if k > 0:
            self.opti.subject_to(self.opti.bounded(-self.tau_limit, self.tau[:, k], self.tau_limit))
        for leg in range(4):
            x, y, z = (self.f[3 * leg + i, k] for i in range(3))
            self.opti.subject_to(z >= 0)
            self.opti.subject_to((self.case.friction * z) ** 2 >= x * x + y * y)
        max_sin_half_tilt = math.sin(0.5 * math.radians(self.case.tilt))
        self.opti.subject_to(ca.sumsqr(self.q[3:5, k + 1]) <= max_sin_half_tilt**2)


def main() -> int:
    """Print one row per push."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--robot", nargs="+", choices=ROBOTS, default=list(ROBOTS))
    parser.add_argument("--heading", nargs="+", type=float, default=[0.0, 22.5, 157.5, 180.0])
    parser.add_argument("--tilt", type=float, default=5.0, help="largest tilt of the trunk [deg]")
    parser.add_argument(
        "--friction", type=float, default=0.8, help="friction coefficient of the floor"
    )
    options = parser.parse_args()
    print("robot     deg push limit     bound")
    for name in options.robot:
        robot = load_robot(name)
        for heading in options.heading:
            case = Case(heading, options.tilt, options.friction)
            own = push_limit(stance_model(robot), heading, PUSH_TIME, 0.0, options.friction).limit
            max_impulse, ipopt_status = PushOcp(case, robot).largest_impulse(0.7 * own)
            print(
                f"{name:6} {heading:6.1f} {own:6.2f} N.s {max_impulse:6.2f} N.s "
                f"{100 * max_impulse / own:5.1f} %  {ipopt_status}",
                flush=True,
            )
    return 0


if __name__ == "__main__":
    sys.exit(main())

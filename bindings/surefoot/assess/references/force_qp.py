"""Balance control by contact forces, after the published equations of unitree_guide.

Source: unitreerobotics/unitree_guide, BalanceCtrl and State_BalanceTest. The model of the robot is
one rigid body. A PD law on its pose gives the desired accelerations::

    a = 150 (p_d - p) - 25 v,    dw = 200 log(R_d R') - 30 w.

The contact forces f (12,) of four stance feet minimise::

    |A f - b|_S^2 + 0.001 |f|_W^2 + 0.1 |f - f_last|_U^2,    b = (m (a - g), R I R' dw)

within the friction pyramids ``|f_x|, |f_y| <= mu f_z``. The torques are tau = -J' f. The motor
commands also have Kp = 0.8 and Kd = 0.8 around the measured angles. The QP has no gyroscopic term
and no limits of force or torque; the torques are clipped afterwards.

Here g is the vector of gravity, which points down. Differences from the source: mass, inertia and
centre of mass are those of the whole robot, legs included, although the legs of the QP's model are
massless. mu comes from the robot's TOML, because with the value 0.4 of the source the robot
survives only smaller pushes. The state comes from surefoot.StateEstimator. The solver is NNLS
(non-negative least squares).
"""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.optimize import nnls

from surefoot._core import LowCmd, LowState, Robot, StateEstimator
from surefoot.geometry.rotations import Array
from surefoot.messages.low_cmd_layout import LOW_CMD
from surefoot.messages.low_state_layout import LOW_STATE, MOTOR_COUNT
from surefoot.sim.lip_push_limit import GRAVITY

# Values of unitree_guide: gains of State_BalanceTest, weights of BalanceCtrl. The docstring of this
# module has the formulas in which these symbols occur.
KP_POSITION, KD_POSITION = 150.0, 25.0  # [1/s^2], [1/s]
KP_ROTATION, KD_ROTATION = 200.0, 30.0  # [1/s^2], [1/s]
S = np.array([20.0, 20.0, 50.0, 450.0, 450.0, 450.0])
W = np.tile([10.0, 10.0, 4.0], 4)
U = np.full(12, 3.0)
ALPHA, BETA = 0.001, 0.1
KP_JOINT, KD_JOINT = 0.8, 0.8  # [N.m/rad], [N.m.s/rad]
SERVO = 0x0A  # motor mode in comm.h of the SDK
_SQRT_S, _SQRT_BETA_U = np.sqrt(S), np.sqrt(BETA * U)
_PYRAMID_SIGNS = np.array([[1.0, 1.0, -1.0, -1.0], [1.0, -1.0, 1.0, -1.0]])


class ForceQp:
    """Controller that uses contact forces to keep the body pose of the first sample.

    Args:
        robot: Model of the robot.
    """

    def __init__(self, robot: Robot) -> None:
        import pinocchio

        self._pin: Any = pinocchio
        self._model: Any = pinocchio.Model()
        self._model.loadFromString(robot.serialized_model())
        self._data: Any = self._model.createData()
        self._robot, self._mass = robot, robot.mass
        self._tau_max = np.array(robot.config.tau_max)
        self._motors = np.array(robot.motor_to_v)
        self._feet = [int(frame) for frame in robot.foot_frame_ids]
        self._radius = robot.config.foot_radius * np.array([0.0, 0.0, 1.0])
        pinocchio.ccrba(self._model, self._data, robot.q_standing(), np.zeros(robot.nv))
        self._inertia = np.array(self._data.Ig.inertia)
        self._estimator = StateEstimator(robot)
        self._rays = _pyramid_edges(robot.config.friction)
        self._A = np.vstack([np.tile(np.eye(3), 4), np.zeros((3, 12))])
        regularisation = (
            np.vstack([np.diag(np.sqrt(ALPHA * W)), np.diag(_SQRT_BETA_U)]) @ self._rays
        )
        self._ls_matrix = np.vstack([np.zeros((6, 16)), regularisation])
        self._forces = np.zeros(12)
        self._tick: int | None = None
        self._position_desired, self._rotation_desired = np.zeros(3), np.eye(3)

    def update(self, state: LowState) -> LowCmd:
        """Compute the command of one tick."""
        step = 0 if self._tick is None else (state.tick - self._tick) % 2**32
        first, self._tick = self._tick is None, state.tick
        if first or step > 0:
            self._estimator.update(state, max(step, 1) / 1000.0)
        estimate = self._estimator.state
        pin, model, data = self._pin, self._model, self._data
        pin.computeJointJacobians(model, data, estimate.q)
        for frame in self._feet:
            pin.updateFramePlacement(model, data, frame)
        R, position = data.oMi[1].rotation, estimate.q[:3]
        com = pin.centerOfMass(model, data, estimate.q, False)
        if first:
            self._position_desired, self._rotation_desired = np.array(position), np.array(R)
        desired = self._desired_wrench(position, R, R @ estimate.v[:3], R @ estimate.v[3:6])
        feet = np.array([data.oMf[frame].translation for frame in self._feet]) - self._radius
        self._forces = self._solve(feet - com, desired)
        torque = np.zeros(MOTOR_COUNT)
        for leg, frame in enumerate(self._feet):
            torque -= self._force_to_torque(frame, self._forces[3 * leg : 3 * leg + 3])
        return self._command(state, np.clip(torque, -self._tau_max, self._tau_max))

    def _desired_wrench(self, position: Array, R: Array, v: Array, w: Array) -> Array:
        a = KP_POSITION * (self._position_desired - position) - KD_POSITION * v
        error = self._pin.log3(self._rotation_desired @ R.T)
        dw = KP_ROTATION * error - KD_ROTATION * w
        up = np.array([0.0, 0.0, GRAVITY])
        return np.concatenate([self._mass * (a + up), R @ self._inertia @ R.T @ dw])

    def _force_to_torque(self, frame: int, force: Array) -> Array:
        """Return J' f (12,) [N.m] of a force at the contact point below a foot frame."""
        J = self._pin.getFrameJacobian(
            self._model, self._data, frame, self._pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
        )
        moment = -self._pin.skew(self._radius) @ force  # moment about the origin of the foot frame
        return np.asarray((np.concatenate([force, moment]) @ J)[self._motors])

    def _solve(self, lever_arms: Array, desired: Array) -> Array:
        """Return the contact forces (12,) [N], which are non-negative sums of pyramid edges."""
        A = self._A
        for leg, lever_arm in enumerate(lever_arms):
            A[3:, 3 * leg : 3 * leg + 3] = self._pin.skew(lever_arm)
        # Only the six rows of the wrench change from tick to tick.
        self._ls_matrix[:6] = _SQRT_S[:, None] * (A @ self._rays)
        ls_target = np.concatenate([_SQRT_S * desired, np.zeros(12), _SQRT_BETA_U * self._forces])
        weights, _ = nnls(self._ls_matrix, ls_target)
        return np.asarray(self._rays @ weights)

    def _command(self, state: LowState, torque: Array) -> LowCmd:
        command = LowCmd()
        motors = command.raw.view(LOW_CMD)[0]["motorCmd"][:MOTOR_COUNT]
        motors["mode"], motors["dq"], motors["tau"] = SERVO, 0.0, torque
        motors["q"] = state.raw.view(LOW_STATE)[0]["motorState"]["q"][:MOTOR_COUNT]
        motors["Kp"], motors["Kd"] = KP_JOINT, KD_JOINT
        return command


def _pyramid_edges(friction: float) -> Array:
    """Return a block matrix (12, 16) with the four friction pyramid edges of each foot."""
    edges = np.vstack([friction * _PYRAMID_SIGNS, np.ones(4)])
    rays = np.zeros((12, 16))
    for leg in range(4):
        rays[3 * leg : 3 * leg + 3, 4 * leg : 4 * leg + 4] = edges
    return rays

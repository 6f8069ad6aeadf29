"""Trot with Raibert's footholds and contact forces, after the published equations of unitree_guide.

Source: unitreerobotics/unitree_guide: State_Trotting, FeetEndCal, GaitGenerator, WaveGenerator.
Diagonal pairs of feet step in turn, with a fixed period and half of it in stance. A swing foot
lands where its hip will be at mid-stance, and moves there on a cycloid::

    foothold = p + v (T_left + T_stance / 2) + k (v - v_d) + R(yaw + w (T_left + T_stance / 2)) r.

The stance forces are those of ForceQp for the desired accelerations

    a = 70 (p_d - p) + 10 (v_d - v),    dw = 780 log(R_d R') + 70 (w_d - w).

A swing foot is pulled to its trajectory by a force. All joints also have Kp and Kd of the motor
commands, larger ones in swing, about the angles of the trajectory. The robot stands on four feet at
velocity 0 once it is slow.

Differences from the source: mass, height and inertia are those of the robot; lengths and times
that the source gives for small robots scale with h and sqrt(h/g), and stiffness with the mass. The
ground is at the mean height of the stance feet. Joint angles of the trajectory come from one Newton
step. The state comes from surefoot.StateEstimator, which knows that feet step.
"""

from __future__ import annotations

import math

import numpy as np

from surefoot._core import LowCmd, LowState, Robot, WalkVelocity
from surefoot.assess.references.force_qp import KD_JOINT, KP_JOINT, SERVO, ForceQp
from surefoot.geometry.rotations import Array
from surefoot.messages.low_cmd_layout import LOW_CMD
from surefoot.messages.low_state_layout import LOW_STATE, MOTOR_COUNT
from surefoot.sim.lip_push_limit import GRAVITY

# Values of State_Trotting for the Go1, which has 12 kg and h = 0.3 m: sqrt(h/g) = 0.175 s.
_SMALL_MASS, _SMALL_HEIGHT = 12.0, 0.3  # [kg], [m]
KP_POSITION, KD_POSITION = 70.0, 10.0  # [1/s^2], [1/s]
KP_ROTATION, KD_ROTATION = 780.0, 70.0  # [1/s^2], [1/s]
MAX_A, MAX_DW = np.array([3.0, 3.0, 5.0]), np.array([40.0, 40.0, 10.0])  # [m/s^2], [rad/s^2]
KP_SWING, KD_SWING = 400.0, 10.0  # [N/m], [N.s/m] of a swing foot
KP_SWING_JOINT, KD_SWING_JOINT = 3.0, 2.0  # [N.m/rad], [N.m.s/rad]
PERIOD, STANCE_SHARE = 0.45, 0.5  # [s], [1]
SWING_HEIGHT = 0.08  # [m]
FOOTHOLD_FEEDBACK = 0.005  # [s] the source's k
POSITION_SLACK, SPEED_SLACK = 0.05, 0.2  # [m], [m/s] of the desired from the present motion
# Above these the robot steps at velocity 0, as checkStepOrNot() of the source.
STEP_SPEED, STEP_COMMAND, STEP_TURN = 0.05, 0.03, 0.2  # [m/s], [m/s], [rad/s]
_OFFSETS = np.array([0.0, 0.5, 0.5, 0.0])  # phase of each foot in periods, FR FL RR RL


class Raibert(ForceQp):
    """Controller that trots with Raibert's footholds.

    Args:
        robot: Model of the robot.
    """

    def __init__(self, robot: Robot) -> None:
        super().__init__(robot)
        pin = self._pin
        q = np.asarray(robot.q_standing())
        com = pin.centerOfMass(self._model, self._data, q)
        pin.framesForwardKinematics(self._model, self._data, q)
        feet = np.array([self._data.oMf[f].translation for f in self._feet]) - self._radius
        self._nominal = (feet - q[:3])[:, :2]  # of each foot, from the base
        self._height = float(q[2] - feet[:, 2].mean())
        scale = (com[2] - feet[:, 2].mean()) / _SMALL_HEIGHT
        self._length, self._time, self._stiffness = (
            scale,
            math.sqrt(scale),
            robot.mass / _SMALL_MASS,
        )
        self._velocity = np.zeros(3)
        self._phase, self._stepping = 0.0, False
        self._stance = np.ones(4, dtype=bool)
        self._lift_off = feet.copy()
        self._yaw_desired = 0.0

    def set_velocity(self, velocity: WalkVelocity) -> None:
        """Command a velocity in the heading frame."""
        self._velocity = np.array([velocity.vx, velocity.vy, velocity.yaw_rate])

    def update(self, state: LowState) -> LowCmd:
        """Compute the command of one tick."""
        first = self._tick is None
        dt = self._estimate(state)
        q, v = np.array(self._estimator.state.q), np.array(self._estimator.state.v)
        pin, model, data = self._pin, self._model, self._data
        pin.computeJointJacobians(model, data, q)
        pin.updateFramePlacements(model, data)
        R, p = np.array(data.oMi[1].rotation), q[:3]
        yaw = math.atan2(R[1, 0], R[0, 0])
        com = pin.centerOfMass(model, data, q, False)
        feet = np.array([data.oMf[f].translation for f in self._feet]) - self._radius
        if first:
            self._position_desired, self._yaw_desired = np.array(p), yaw
            self._lift_off = feet.copy()
        velocity = self._plan_body(p, R @ v[:3], yaw, dt)
        self._advance_gait(dt, feet, R @ v[:3])
        self._position_desired[2] = feet[self._stance, 2].mean() + self._height
        wrench = self._body_wrench(p, R, R @ v[:3], R @ v[3:6], velocity)
        self._forces = self._stance_forces(feet - com, wrench)
        goals, speeds = self._swing_goals(p, R @ v[:3], yaw, float((R @ v[3:6])[2]), velocity, feet)
        return self._trot_command(state, feet, v, goals, speeds)

    def _estimate(self, state: LowState) -> float:
        """Update the estimator; return the time since the last tick [s]."""
        step = 1 if self._tick is None else max((state.tick - self._tick) % 2**32, 1)
        self._tick = state.tick
        self._estimator.set_stepping(self._stepping)
        self._estimator.update(state, step / 1000.0)
        return step / 1000.0

    def _plan_body(self, p: Array, v: Array, yaw: float, dt: float) -> Array:
        """Move the desired position and heading; return the desired velocity, world axes."""
        c, s = math.cos(yaw), math.sin(yaw)
        vx, vy, turn = self._velocity
        wanted = np.array([c * vx - s * vy, s * vx + c * vy])
        velocity = np.clip(wanted, v[:2] - SPEED_SLACK, v[:2] + SPEED_SLACK)
        slack = POSITION_SLACK * self._length
        moved = self._position_desired[:2] + velocity * dt
        self._position_desired[:2] = np.clip(moved, p[:2] - slack, p[:2] + slack)
        self._yaw_desired += turn * dt
        self._rotation_desired = self._pin.rpy.rpyToMatrix(0.0, 0.0, self._yaw_desired)
        return np.array([*velocity, 0.0])

    def _advance_gait(self, dt: float, feet: Array, v: Array) -> None:
        """Advance the phase, and note where feet lift off."""
        moves = np.linalg.norm(self._velocity[:2]) > STEP_COMMAND
        moves = moves or abs(self._velocity[2]) > STEP_TURN
        if moves or np.linalg.norm(v[:2]) > STEP_SPEED:
            self._stepping = True
        elif self._phase % 0.5 < 0.02:  # ends a step
            self._stepping = False
        if self._stepping:
            self._phase = (self._phase + dt / (PERIOD * self._time)) % 1.0
        phases = (self._phase + _OFFSETS) % 1.0
        stance = (phases < STANCE_SHARE) | (not self._stepping)
        lifts = self._stance & ~stance
        self._lift_off[lifts] = feet[lifts]
        self._stance = stance

    def _body_wrench(self, p: Array, R: Array, v: Array, w: Array, velocity: Array) -> Array:
        a = KP_POSITION * (self._position_desired - p) + KD_POSITION * (velocity - v)
        error = self._pin.log3(self._rotation_desired @ R.T)
        turn = np.array([0.0, 0.0, self._velocity[2]])
        dw = KP_ROTATION * error + KD_ROTATION * (turn - w)
        a, dw = np.clip(a, -MAX_A, MAX_A), np.clip(dw, -MAX_DW, MAX_DW)
        up = np.array([0.0, 0.0, GRAVITY])
        return np.concatenate([self._mass * (a + up), R @ self._inertia @ R.T @ dw])

    def _stance_forces(self, lever_arms: Array, wrench: Array) -> Array:
        """Return the contact forces (12,) [N]; those of swing feet are 0."""
        all_rays = self._rays
        self._rays = all_rays * np.repeat(self._stance, 3)[:, None]
        try:
            return self._solve(lever_arms, wrench)
        finally:
            self._rays = all_rays

    def _swing_goals(
        self, p: Array, v: Array, yaw: float, turn: float, velocity: Array, feet: Array
    ) -> tuple[Array, Array]:
        """Return position and velocity of each swing foot's trajectory, (4, 3) each."""
        goals, speeds = feet.copy(), np.zeros((4, 3))
        swing_time = (1.0 - STANCE_SHARE) * PERIOD * self._time
        stance_time = STANCE_SHARE * PERIOD * self._time
        ground = feet[self._stance, 2].mean()
        for leg in np.flatnonzero(~self._stance):
            phase = (self._phase + _OFFSETS[leg]) % 1.0
            share = (phase - STANCE_SHARE) / (1.0 - STANCE_SHARE)
            ahead = (1.0 - share) * swing_time + 0.5 * stance_time
            angle = yaw + turn * ahead
            c, s = math.cos(angle), math.sin(angle)
            x, y = self._nominal[leg]
            end = p[:2] + v[:2] * ahead + FOOTHOLD_FEEDBACK * (v - velocity)[:2]
            end += np.array([c * x - s * y, s * x + c * y])
            start, angle = self._lift_off[leg], 2.0 * math.pi * share
            along = (angle - math.sin(angle)) / (2.0 * math.pi)
            rate = (1.0 - math.cos(angle)) / swing_time
            height = SWING_HEIGHT * self._length
            goals[leg, :2] = start[:2] + along * (end - start[:2])
            goals[leg, 2] = start[2] + along * (ground - start[2])
            goals[leg, 2] += 0.5 * height * (1.0 - math.cos(angle))
            speeds[leg, :2] = rate * (end - start[:2])
            speeds[leg, 2] = math.pi * height * math.sin(angle) / swing_time
        return goals, speeds

    def _trot_command(
        self, state: LowState, feet: Array, v: Array, goals: Array, speeds: Array
    ) -> LowCmd:
        torque, dq, dv = np.zeros(MOTOR_COUNT), np.zeros(MOTOR_COUNT), np.zeros(MOTOR_COUNT)
        for leg, frame in enumerate(self._feet):
            if self._stance[leg]:
                torque -= self._force_to_torque(frame, self._forces[3 * leg : 3 * leg + 3])
                continue
            jacobian = self._pin.getFrameJacobian(
                self._model, self._data, frame, self._pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
            )[:3]
            error, slow = goals[leg] - feet[leg], speeds[leg] - jacobian @ v
            force = self._stiffness * (KP_SWING * error + KD_SWING * slow)
            torque += (force @ jacobian)[self._motors]
            leg_jacobian = jacobian[:, self._motors[3 * leg : 3 * leg + 3]]
            joints = slice(3 * leg, 3 * leg + 3)
            dq[joints] = np.linalg.lstsq(leg_jacobian, error, rcond=0.05)[0]
            dv[joints] = np.linalg.lstsq(leg_jacobian, slow, rcond=0.05)[0]
        command = LowCmd()
        motors = command.raw.view(LOW_CMD)[0]["motorCmd"][:MOTOR_COUNT]
        measured = state.raw.view(LOW_STATE)[0]["motorState"][:MOTOR_COUNT]
        swings = np.repeat(~self._stance, 3)
        motors["mode"], motors["tau"] = SERVO, np.clip(torque, -self._tau_max, self._tau_max)
        motors["q"], motors["dq"] = measured["q"] + dq, np.where(swings, measured["dq"] + dv, 0.0)
        motors["Kp"] = self._stiffness * np.where(swings, KP_SWING_JOINT, KP_JOINT)
        motors["Kd"] = self._stiffness * np.where(swings, KD_SWING_JOINT, KD_JOINT)
        return command

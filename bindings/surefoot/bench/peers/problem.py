"""The control problem that all implementations solve."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from surefoot._core import (
    Gains,
    Reference,
    Robot,
    RobotState,
    WholeBodyController,
)
from surefoot.bench.problems import SCENARIOS
from surefoot.bench.problems.scenarios import PUSH_TIMES
from surefoot.bench.recording import Recording

# Stiffness kp [1/s^2] and damping kd [1/s] of each task. All axes of a task have the same values,
# because PlaCo has one pair of values per task. Chosen: kp = w^2 and kd = 2 zeta w, where w is the
# natural frequency [rad/s] and zeta the damping ratio. (w, zeta): com (10, 1), base (20, 1), foot
# (50, 0.5).
TASK_GAINS = {"com": (100.0, 20.0), "base": (400.0, 40.0), "foot": (2500.0, 50.0)}
POSTURE_GAINS = (100.0, 20.0)
# Weight of the posture task in the units of our QP. Chosen: with a smaller weight the posture is
# undetermined in the peers, and with a larger weight the posture task disturbs the other tasks.
POSTURE_WEIGHT = 1e-4
# [m] Radius of the feet, which are points for the peers. Chosen: far below the 1e-3 m that changes
# a force; a robot needs a radius above 0.
POINT_RADIUS = 1e-6


@dataclass(frozen=True)
class Problem:
    """Robot, states and targets.

    Attributes:
        robot: Robot model for StandController. It has the robot's own gains, except that the
            posture task has POSTURE_WEIGHT.
        point_robot: Robot model for WholeBodyController. It has contact points at the foot frames,
            as the peers have, and the gains from peer_equivalent_gains().
        q: (n, nq) estimated configurations of the run, in Pinocchio's order.
        v: (n, nv) estimated velocities, in Pinocchio's order.
        targets: (n, 7) desired centre of mass [m] and base orientation (quaternion x y z w).
        hold: Reference that holds the first state.
        urdf: URDF of the robot.
    """

    robot: Robot
    point_robot: Robot
    q: NDArray[np.float64]
    v: NDArray[np.float64]
    targets: NDArray[np.float64]
    hold: Reference
    urdf: Path

    def __len__(self) -> int:
        return len(self.q)

    def states(self) -> list[RobotState]:
        """Return the states for our controller, with four feet in contact and no external force.

        The peers receive no external force either.
        """
        return [_robot_state(self.robot, q, v) for q, v in zip(self.q, self.v, strict=True)]

    def references(self) -> list[Reference]:
        """Return the reference of our controller for each tick."""
        controller, first = WholeBodyController(self.point_robot), self.states()[0]
        references = [controller.hold(first) for _ in self.targets]
        for reference, target in zip(references, self.targets, strict=True):
            reference.p_com, reference.quat_world_base = target[:3], target[3:]
        return references


def make_problem(recording: Recording, urdf: Path) -> Problem:
    """Replay a recording to get the estimated states and the references of each tick."""
    robot, scenario = recording.robot, SCENARIOS[recording.scenario]
    controller = scenario.make_controller(robot)
    q, v, targets = [], [], []
    for tick, low_state in enumerate(recording.low_states):
        scenario.apply_requests(controller, tick * recording.period)
        controller.update(low_state)
        state, reference = controller.state, controller.reference
        q.append(state.q)
        v.append(state.v)
        targets.append([*reference.p_com, *reference.quat_world_base])
    point_robot = _with_config(
        robot, peer_equivalent_gains(robot.config.gains), foot_radius=POINT_RADIUS
    )
    gains = robot.config.gains
    gains.weight_posture = POSTURE_WEIGHT
    return Problem(
        robot=_with_config(robot, gains),
        point_robot=point_robot,
        q=np.array(q),
        v=np.array(v),
        targets=np.array(targets),
        hold=WholeBodyController(point_robot).hold(_robot_state(robot, q[0], v[0])),
        urdf=urdf,
    )


def ticks_before_push(recording: Recording) -> int:
    """Return the number of ticks before the first push; all ticks if there is none."""
    pushed = SCENARIOS[recording.scenario].push > 0.0
    return round(PUSH_TIMES[0] / recording.period) if pushed else len(recording.low_states)


def peer_equivalent_gains(gains: Gains) -> Gains:
    """Return gains with the peers' stiffness and posture task, without features that peers lack."""
    gains.com_kp_horizontal = gains.com_kp_vertical = TASK_GAINS["com"][0]
    gains.com_kd_horizontal = gains.com_kd_vertical = TASK_GAINS["com"][1]
    gains.base_kp_tilt = gains.base_kp_yaw = TASK_GAINS["base"][0]
    gains.base_kd_tilt = gains.base_kd_yaw = TASK_GAINS["base"][1]
    gains.foot_kp, gains.foot_kd = TASK_GAINS["foot"]
    gains.posture_kp, gains.posture_kd = POSTURE_GAINS
    gains.weight_com_vertical = gains.weight_com_horizontal
    gains.weight_base_yaw = gains.weight_base_tilt
    gains.weight_posture = POSTURE_WEIGHT
    gains.edge_tilt = gains.edge_height = 1.0
    gains.edge_load = 0.0
    gains.edge_rise = 100.0
    gains.hold_down = 0.0
    return gains


def _with_config(robot: Robot, gains: Gains, **fields: Any) -> Robot:
    """Return a copy of the robot with other gains and other configuration fields."""
    config = robot.config
    config.gains = gains
    for name, value in fields.items():
        setattr(config, name, value)
    return Robot.from_serialized_model(robot.serialized_model(), config)


def _robot_state(robot: Robot, q: Any, v: Any) -> RobotState:
    state = RobotState(robot.nq, robot.nv)
    state.q, state.v = q, v
    return state

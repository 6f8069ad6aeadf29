"""The one problem that every side solves."""

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
    StandController,
    WholeBodyController,
)
from surefoot.bench.problems import SCENARIOS
from surefoot.bench.problems.scenarios import PUSH_TIMES
from surefoot.bench.recording import Recording

# One stiffness and damping for all axes of a task: PlaCo's tasks know no others. [1/s^2], [1/s]
TASK_GAINS = {"com": (100.0, 20.0), "base": (400.0, 40.0), "foot": (2500.0, 50.0)}
POSTURE_GAINS = (100.0, 20.0)
POSTURE_WEIGHT = 1e-4  # little, in our program's units: the body's tasks decide


@dataclass(frozen=True)
class Problem:
    """Robot, states, and what is asked for.

    Attributes:
        robot: For our whole tick: with its own gains, but for a posture task as the others have.
        point_robot: For state to torque: contact points at the foot frames, where the peers have
            theirs, and their stiffness; see peer_equivalent_gains().
        q: Estimated states of the run, Pinocchio's order, shape (n, nq).
        v: Shape (n, nv).
        targets: Centre of mass [m] and base orientation (quaternion x y z w) that are asked for,
            shape (n, 7).
        hold: Stay where the first state is.
        urdf: The robot's.
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
        """Return the states for our controller: four feet down, nobody pushes as far as it knows.

        The peers are told no force from outside, so ours is not either.
        """
        return [_robot_state(self.robot, q, v) for q, v in zip(self.q, self.v, strict=True)]

    def references(self) -> list[Reference]:
        """Return what our controller is asked for, tick by tick."""
        controller, first = WholeBodyController(self.point_robot), self.states()[0]
        references = [controller.hold(first) for _ in self.targets]
        for reference, target in zip(references, self.targets, strict=True):
            reference.p_com, reference.quat_world_base = target[:3], target[3:]
        return references


def make_problem(recording: Recording, urdf: Path) -> Problem:
    """Replay a recording for what was estimated and what the body was asked to do."""
    robot, apply_reference = recording.robot, SCENARIOS[recording.scenario].apply_reference
    controller = StandController(robot)
    q, v, targets = [], [], []
    for tick, report in enumerate(recording.reports):
        apply_reference(controller, tick * recording.period)
        controller.update(report)
        state, reference = controller.state, controller.reference
        q.append(state.q)
        v.append(state.v)
        targets.append([*reference.p_com, *reference.quat_world_base])
    point_robot = _with_config(robot, peer_equivalent_gains(robot.config.gains), foot_radius=0.0)
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
    """Return how many ticks there are before the first push; all, if there is none."""
    pushed = SCENARIOS[recording.scenario].push > 0.0
    return round(PUSH_TIMES[0] / recording.period) if pushed else len(recording.reports)


def peer_equivalent_gains(gains: Gains) -> Gains:
    """Return ours with the peers' stiffness, a posture task, and nothing that peers do not do."""
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
    """Return the same robot with other gains and other fields of its configuration."""
    config = robot.config
    config.gains = gains
    for name, value in fields.items():
        setattr(config, name, value)
    return Robot.from_serialized_model(robot.serialized_model(), config)


def _robot_state(robot: Robot, q: Any, v: Any) -> RobotState:
    state = RobotState(robot.nq, robot.nv)
    state.q, state.v = q, v
    return state

"""Tick time over problem size: one to four stance feet, an additional arm, a humanoid.

The benchmark calls WholeBodyController.update() from Python, which adds about 1 us per call. The
states drift around the standing pose. The result is a Markdown table.
"""

from __future__ import annotations

import argparse
import gc
from dataclasses import dataclass
from pathlib import Path
from time import perf_counter_ns

import numpy as np
import pinocchio as pin
import surefoot
from surefoot import QpForm, RobotConfig
from surefoot.robot.loading import describe_robot

FORMS = {"condensed": QpForm.CONDENSED, "general": QpForm.GENERAL}
G1_LEGS = {
    "right": ("right_hip_pitch_joint", "right_knee_joint", "right_ankle_roll_joint"),
    "left": ("left_hip_pitch_joint", "left_knee_joint", "left_ankle_roll_joint"),
}
G1_ARMS = {
    "right": ("right_shoulder_pitch_joint", "right_elbow_joint", "right_wrist_yaw_joint"),
    "left": ("left_shoulder_pitch_joint", "left_elbow_joint", "left_wrist_yaw_joint"),
}
G1_STANDING_ANGLES = {"hip_pitch": -0.3, "knee": 0.6, "ankle_pitch": -0.3, "elbow": 0.5}  # [rad]


@dataclass(frozen=True)
class Case:
    """One row of the table: robot, standing configuration q, number of stance feet, QP form."""

    name: str
    robot: surefoot.Robot
    q: np.ndarray
    feet: int
    form: str


def cases() -> list[Case]:
    """Return all rows: go1 on one to four feet, b1 without and with an arm, g1 on two feet."""
    go1, b1 = surefoot.load_robot("go1"), surefoot.load_robot("b1")
    rows = [
        Case("go1", go1, go1.q_standing(), feet, form) for form in FORMS for feet in (4, 3, 2, 1)
    ]
    rows.append(Case("b1", b1, b1.q_standing(), 4, "general"))
    for robot, q in (b1_with_arm(b1), g1()):
        feet = 2 if robot.name == "g1" else 4
        rows.append(Case(robot.name, robot, q, feet, "general"))
    return rows


def b1_with_arm(b1: surefoot.Robot) -> tuple[surefoot.Robot, np.ndarray]:
    """Return a b1 with a z1 arm, and its standing configuration."""
    model = _model("b1_description/urdf/b1-z1.urdf")
    config = b1.config
    config.name = "b1-z1"
    robot = surefoot.Robot.from_serialized_model(model.saveToString(), config)
    return robot, robot.q_standing()


def g1() -> tuple[surefoot.Robot, np.ndarray]:
    """Return a humanoid and its standing configuration.

    The soles are two of the four feet. The hands are the remaining two feet and have no contact.
    """
    model = _model("g1_description/urdf/g1_29dof_rev_1_0.urdf")
    limb_joints = [G1_LEGS["right"], G1_LEGS["left"], G1_ARMS["right"], G1_ARMS["left"]]
    config = RobotConfig()
    config.name = "g1"
    config.joint_names = [name for chain in limb_joints for name in chain]
    config.foot_frames = [chain[-1].replace("_joint", "_link") for chain in limb_joints]
    config.foot_radius = 0.03
    index = [model.joints[model.getJointId(name)] for name in config.joint_names]
    config.q_lower = np.array([model.lowerPositionLimit[j.idx_q] for j in index])
    config.q_upper = np.array([model.upperPositionLimit[j.idx_q] for j in index])
    config.dq_max = np.array([model.velocityLimit[j.idx_v] for j in index])
    config.tau_max = np.array([model.effortLimit[j.idx_v] for j in index])
    config.corner_speed, config.no_load_speed = 0.5 * config.dq_max, config.dq_max
    config.armature = np.full(12, 0.01)
    q = pin.neutral(model)
    for name in model.names[2:]:
        q[model.joints[model.getJointId(name)].idx_q] = next(
            (angle for part, angle in G1_STANDING_ANGLES.items() if part in name), 0.0
        )
    config.q_standing = np.array([q[j.idx_q] for j in index])
    return surefoot.Robot.from_serialized_model(model.saveToString(), config), q


def _model(urdf: str) -> pin.Model:
    root = Path(describe_robot("b1").mesh_root)
    urdf_path = next(p for p in (root / urdf, root / "robots" / urdf) if p.exists())
    return pin.buildModelFromUrdf(str(urdf_path), pin.JointModelFreeFlyer())


def time_case(case: Case, ticks: int) -> tuple[np.ndarray, tuple[int, int, int], float, int]:
    """Return the durations [us], the size of the QP, the mean number of iterations and failures."""
    options = surefoot.WholeBodyOptions(form=FORMS[case.form])
    controller = surefoot.WholeBodyController(case.robot, options=options)
    state = surefoot.RobotState(case.robot.nq, case.robot.nv)
    state.q = case.q
    reference = controller.hold(state)
    state.contact = (np.arange(4) < case.feet).astype(float)
    for leg in range(case.feet, 4):
        reference.foot(leg).stance = False
        reference.foot(leg).load = 0.0
    rng, durations, iterations, failures = np.random.default_rng(1), [], 0, 0
    joint_offset = np.zeros(case.robot.nv - 6)
    gc.disable()
    for _ in range(ticks):
        joint_offset = 0.995 * joint_offset + 1e-3 * rng.standard_normal(len(joint_offset))
        q = case.q.copy()
        q[7:] += joint_offset
        state.q = q
        start = perf_counter_ns()
        solution = controller.update(state, reference)
        durations.append((perf_counter_ns() - start) / 1000.0)
        iterations += solution.iterations
        failures += not surefoot.is_usable(solution.status)
    gc.enable()
    qp = controller.qp
    size = (len(qp.g), len(qp.b), len(qp.l))
    return np.array(durations), size, iterations / ticks, failures


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--ticks", type=int, default=5000)
    ticks = parser.parse_args().ticks
    print(
        "| robot | nv | feet | form | variables / equalities / inequalities "
        "| p50 | p99 | iterations |"
    )
    print("|---|---|---|---|---|---|---|---|")
    for case in cases():
        us, size, iterations, failures = time_case(case, ticks)
        sizes = " / ".join(map(str, size))
        failed = f", {failures} failed" if failures else ""
        print(
            f"| {case.name} | {case.robot.nv} | {case.feet} | {case.form} | {sizes} | "
            f"{np.median(us):.1f} us | {np.percentile(us, 99):.1f} us | {iterations:.2f}{failed} |",
            flush=True,
        )


if __name__ == "__main__":
    main()

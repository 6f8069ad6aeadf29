"""Files that pass the problem to a worker."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from surefoot._core import LowState
from surefoot.bench.peers.problem import POSTURE_GAINS, TASK_GAINS, Problem
from surefoot.bench.peers.weights import GRAVITY, peer_weights


def write_problem(problem: Problem, low_states: Sequence[LowState], folder: Path) -> Path:
    """Write the problem for workers; return the path of problem.txt.

    Args:
        problem: Problem to write. problem.txt has a name and its values per line. states.bin has
            a float64 row q, v, target per tick. robot.urdf is for the peers. whole.robot and
            point.robot, which include gains, are for our workers.
        low_states: LowStates, written to reports.bin as packed structs.
        folder: Folder of the files.
    """
    robot = problem.robot
    np.hstack([problem.q, problem.v, problem.targets]).astype("<f8").tofile(folder / "states.bin")
    _write_urdf_without_shapes(problem.urdf, folder / "robot.urdf")
    robot.save(str(folder / "whole.robot"))
    problem.point_robot.save(str(folder / "point.robot"))
    (folder / "reports.bin").write_bytes(b"".join(low_state.to_bytes() for low_state in low_states))
    config, order = robot.config, np.argsort(robot.motor_to_v)
    weight = robot.mass * GRAVITY
    weights = peer_weights(problem.point_robot, problem.point_robot.config.gains)
    lines: dict[str, Iterable[Any]] = {
        "size": (len(problem), robot.nq, robot.nv),
        "joints": [config.joint_names[i] for i in order],
        "feet": config.foot_frames,
        "tau_max": config.tau_max[order],
        "armature": config.armature[order],
        "friction": (config.friction,),
        "force_max": (config.gains.force_max_contact * weight,),
        "force": (weight / 4,),
        "anchors": np.ravel([problem.hold.foot(leg).p_world for leg in range(4)]),
        "posture": robot.q_standing()[7:],
        **{f"{name}_gains": gains for name, gains in TASK_GAINS.items()},
        "posture_gains": POSTURE_GAINS,
        **{f"{name}_weight": (weight,) for name, weight in weights.items()},
    }
    file = folder / "problem.txt"
    text = [" ".join([name, *map(_format_value, values)]) for name, values in lines.items()]
    file.write_text("\n".join(text) + "\n", encoding="utf-8")
    return file


def _format_value(value: Any) -> str:
    return repr(float(value)) if isinstance(value, float) else str(value)


def _write_urdf_without_shapes(urdf: Path, out: Path) -> None:
    """Write the URDF without shapes: no peer needs the meshes, but some would load them."""
    tree = ET.parse(urdf)
    for link in tree.iter("link"):
        for shape in [*link.findall("visual"), *link.findall("collision")]:
            link.remove(shape)
    tree.write(out, encoding="utf-8", xml_declaration=True)

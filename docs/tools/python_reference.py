# SPDX-License-Identifier: BSD-3-Clause
"""Write the pages of the Python reference: one for each public module, filled in by autodoc."""

from __future__ import annotations

import importlib
import inspect
from pathlib import Path

CORE_GROUPS = {
    "Controllers": (
        "Controller StandController ControllerOptions WalkController WalkOptions WalkVelocity "
        "WalkLimit Gait WholeBodyController WholeBodyOptions Supervisor SupervisorOptions Runner "
        "RunOptions RunSnapshot RunLog"
    ),
    "Robots": "load_robot available_robots Robot RobotConfig motor_torque_limit motion_range",
    "Gains": "Gains GainInfo gain_table get_gain set_gain load_gains save_gains",
    "Low-level interface": (
        "LowState LowCmd IMU MotorState MotorStateArray MotorCmd MotorCmdArray BmsState BmsCmd "
        "damping_low_cmd FrameExtras Button WirelessRemote"
    ),
    "State, reference, solution": (
        "RobotState Reference FootReference BodyReference BodyPoint Solution QpProblem QpForm Task "
        "TaskRows Planner PlannerInput"
    ),
    "Estimation": "StateEstimator EstimatorReport ContactSource SensorVerdict identify_delay",
    "Statuses": (
        "Status is_usable names_wrong_sensor FallbackLevel Mode Start RequestStatus RiseStage "
        "ReachStatus ReachLimit"
    ),
    "Safety and faults": (
        "Safety ArmingCheck ArmingReport FaultId FaultInfo FaultReaction FaultReport fault_table"
    ),
    "Link": (
        "RobotLink UdpLink LinkCounts DdsNetwork DdsLink DdsCounts DdsRobotPort RobotPortCounts "
        "DdsServiceClient DdsServiceServer ServiceRequest"
    ),
    "Errors": "Error",
}
MODULES = {
    "surefoot.sim": "Simulated robot: MuJoCo, sensors with errors, motors, pushes.",
    "surefoot.motion_switcher": "Motion switcher of Go2 and B2, over DDS.",
    "surefoot.protocol": "Frames of the SDK's UDP protocol.",
    "surefoot.replay": "Record a controller's calls; replay them.",
    "surefoot.symbolic": "CasADi functions of a robot's dynamics (extra ``tune``).",
    "surefoot.stand": "Simulated stands with pushes and references, and their figures.",
    "surefoot.walk": "Simulated walks at commanded velocities, and their figures.",
    "surefoot.estimate": "The state estimator on sensor logs.",
    "surefoot.assess": "Scorecards of controllers that stand or walk.",
    "surefoot.faults": "Fault injection.",
    "surefoot.virtual_robot": "A simulated robot that SDK programs control over UDP or DDS.",
    "surefoot.bench": "Timing of the tick and of QP solvers.",
}


def public_modules() -> list[str]:
    """Return the names of all public modules."""
    return ["surefoot", *MODULES]


def _directive(module: str, name: str) -> str:
    thing = getattr(importlib.import_module(module), name)
    if inspect.isclass(thing):
        kind = "autoexception" if issubclass(thing, BaseException) else "autoclass"
    else:
        kind = "autofunction" if callable(thing) else "autodata"
    return f".. {kind}:: {module}.{name}\n" + (
        "   :no-index:\n" if is_repeated(module, name) else ""
    )


def is_repeated(module: str, name: str) -> bool:
    """Whether a module earlier in MODULES has the same object."""
    thing = getattr(importlib.import_module(module), name)
    earlier = list(MODULES)[: list(MODULES).index(module)] if module in MODULES else []
    modules = [importlib.import_module(other) for other in earlier]
    return any(thing is getattr(other, name, None) and name in other.__all__ for other in modules)


def _page(title: str, intro: str, module: str, names: list[str]) -> str:
    body = "\n".join(_directive(module, name) for name in names)
    return f"{title}\n{'=' * len(title)}\n\n{intro}\n\n{body}"


def _constants() -> list[str]:
    core = importlib.import_module("surefoot")
    return [name for name in core.__all__ if isinstance(getattr(core, name), int | float)]


def _constants_page() -> str:
    core = importlib.import_module("surefoot")
    values = "\n".join(
        f".. py:data:: surefoot.{name}\n   :value: {getattr(core, name)!r}\n"
        for name in _constants()
    )
    intro = (
        "Constants of the SDK. ``FR_0`` .. ``RL_2`` are motor numbers: leg, then 0 hip, 1 thigh, "
        "2 calf. ``PosStopF`` in ``MotorCmd.q`` and ``VelStopF`` in ``MotorCmd.dq`` switch the "
        "position and the velocity loop off. ``LOWLEVEL`` is the levelFlag of low-level frames."
    )
    return f"Constants\n=========\n\n{intro}\n\n{values}"


def write_python_pages(folder: Path) -> None:
    """Write python-api.md and a page for each group of names.

    Raises:
        RuntimeError: A name of `surefoot.__all__` is in no group.
    """
    core = importlib.import_module("surefoot")
    pages = {"constants": _constants_page()}
    grouped = set(_constants())
    for text in CORE_GROUPS.values():
        grouped |= set(text.split())
    if grouped != set(core.__all__):
        raise RuntimeError(
            f"python_reference.py: no group has, or no name is: {grouped ^ set(core.__all__)}"
        )
    for title, text in CORE_GROUPS.items():
        pages[title] = _page(title, "Names of the package ``surefoot``.", "surefoot", text.split())
    for module, intro in MODULES.items():
        names = list(importlib.import_module(module).__all__)
        pages[module] = _page(module, intro, module, names)
    index = ["# Python API", "", "```{toctree}", ":maxdepth: 1", ""]
    for title, page in pages.items():
        stem = "py-" + title.lower().replace("surefoot.", "").replace(",", "").replace(" ", "-")
        (folder / f"{stem}.rst").write_text(page, encoding="utf-8")
        index.append(stem)
    index += ["```", ""]
    (folder / "python-api.md").write_text("\n".join(index), encoding="utf-8")

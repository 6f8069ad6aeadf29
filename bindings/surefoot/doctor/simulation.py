"""Checks of MuJoCo and its graphics."""

from __future__ import annotations

import os

from surefoot.doctor.finding import Finding, Verdict
from surefoot.doctor.probe import run_probe

AREA = "simulation"
# A graphics driver may crash, and MuJoCo needs AVX: both run in a process of their own.
_STEP = "from surefoot.sim import Plant; Plant('go1').reset()"
_DRAW = "import mujoco; context = mujoco.GLContext(16, 16); context.make_current()"


def check_simulation() -> list[Finding]:
    """Check whether a plant can be made, and whether MuJoCo can draw."""
    backend = os.environ.get("MUJOCO_GL", "")
    return [
        _run("plant", _STEP, "a go1 stands", "pip install 'surefoot[sim]'"),
        _run(
            "graphics",
            _DRAW,
            f"MUJOCO_GL={backend or 'not set'}: a context opens",
            "reports have no film; try: export MUJOCO_GL=egl, or osmesa, or install libegl1",
        ),
    ]


def _run(subject: str, program: str, value: str, remedy: str) -> Finding:
    result = run_probe(program)
    if result.works:
        return Finding(AREA, subject, value, Verdict.GOOD)
    return Finding(AREA, subject, result.text, Verdict.LIMITED, remedy)

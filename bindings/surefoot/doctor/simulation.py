"""Checks of MuJoCo and its graphics."""

from __future__ import annotations

import os
import subprocess
import sys

from surefoot.doctor.finding import Finding, Verdict

AREA = "simulation"
_MAX_TIME = 120.0  # [s]
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
    try:
        result = subprocess.run(
            [sys.executable, "-c", program], capture_output=True, text=True, timeout=_MAX_TIME
        )
    except subprocess.TimeoutExpired:
        problem = f"no answer within {_MAX_TIME:g} s"
        return Finding(AREA, subject, problem, Verdict.LIMITED, remedy)
    if result.returncode == 0:
        return Finding(AREA, subject, value, Verdict.GOOD)
    lines = result.stderr.strip().splitlines() or [f"exit status {result.returncode}"]
    return Finding(AREA, subject, lines[-1], Verdict.LIMITED, remedy)

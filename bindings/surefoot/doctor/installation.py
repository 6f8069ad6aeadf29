"""Checks of versions and libraries."""

from __future__ import annotations

import os
import platform
import re
import sys
from pathlib import Path

from surefoot.doctor.finding import Finding, Verdict
from surefoot.doctor.probe import run_probe
from surefoot.system.library_check import PINOCCHIO_LIBRARY, loaded_libraries
from surefoot.system.machine import package_version

AREA = "installation"
# Packages of extras, and what needs them.
_OPTIONAL = {
    "mujoco": ("sim", "simulation"),
    "example-robot-data": ("sim", "robots by name"),
    "matplotlib": ("sim", "reports"),
    "casadi": ("tune", "surefoot.symbolic"),
    "optuna": ("tune", "surefoot tune search"),
    "viser": ("tune", "surefoot tune live"),
    "cyclonedds": ("dds", "the links of Go2 and B2, unless the system has libddsc"),
}


def check_installation() -> list[Finding]:
    """Check Python, the packages and the libraries that were loaded."""
    return [
        _finding("surefoot", f"{package_version('surefoot')} in {Path(__file__).parents[1]}"),
        _finding("Python", f"{platform.python_version()}, {sys.executable}"),
        _finding("system", f"{platform.platform()}, {' '.join(platform.libc_ver())}"),
        *(_check_package(name) for name in _OPTIONAL),
        _check_pinocchio(),
        _check_ddsc(),
        _check_ros(),
    ]


def _check_package(name: str) -> Finding:
    extra, use = _OPTIONAL[name]
    version = package_version(name)
    if version is None:
        remedy = f"{use} needs it: pip install 'surefoot[{extra}]'"
        return Finding(AREA, name, "not installed", Verdict.LIMITED, remedy)
    return _finding(name, version)


def _check_pinocchio() -> Finding:
    files = loaded_libraries(PINOCCHIO_LIBRARY)
    subject = "libpinocchio"
    version = package_version("libpinocchio")
    if len(files) > 1:
        remedy = "two copies in one process may crash; run: unset LD_LIBRARY_PATH"
        return Finding(AREA, subject, " and ".join(map(str, files)), Verdict.BAD, remedy)
    return _finding(subject, f"{version}, {files[0] if files else 'linked into surefoot'}")


def _check_ddsc() -> Finding:
    """Load libddsc in a process of its own, as a link to a Go2 would."""
    program = (
        "import surefoot\n"
        "print(*surefoot.DdsNetwork('lo', 229, untested_library=True).notices, sep='; ')"
    )
    result = run_probe(program)
    if result.works:
        return _finding("libddsc", result.text)
    problem = re.sub(r"^[\w.]*Error: ", "", result.text)
    remedy = "only the links of Go2 and B2 need it: pip install 'surefoot[dds]'"
    return Finding(AREA, "libddsc", problem, Verdict.LIMITED, remedy)


def _check_ros() -> Finding:
    path = os.environ.get("PYTHONPATH", "")
    if "/opt/ros" in path:
        remedy = "the packages of ROS may shadow those of this environment; run: unset PYTHONPATH"
        return Finding(AREA, "PYTHONPATH", path, Verdict.LIMITED, remedy)
    return _finding("PYTHONPATH", path or "not set")


def _finding(subject: str, value: str) -> Finding:
    return Finding(AREA, subject, value, Verdict.GOOD)

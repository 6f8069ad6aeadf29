"""Checks of versions and libraries."""

from __future__ import annotations

import importlib.metadata
import os
import platform
import re
import subprocess
import sys
from pathlib import Path

from surefoot.doctor.finding import Finding, Verdict

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
_MAX_IMPORT_TIME = 60.0  # [s] after which a library does not answer


def check_installation() -> list[Finding]:
    """Check Python, the packages and the libraries that were loaded."""
    return [
        _finding("surefoot", f"{_version('surefoot')} in {Path(__file__).parents[1]}"),
        _finding("Python", f"{platform.python_version()}, {sys.executable}"),
        _finding("system", f"{platform.platform()}, {' '.join(platform.libc_ver())}"),
        *(_check_package(name) for name in _OPTIONAL),
        _check_pinocchio(),
        _check_ddsc(),
        _check_ros(),
    ]


def loaded_libraries(name: str) -> list[str]:
    """Return the files of a library that this process has loaded, without duplicates.

    Args:
        name: Begin of the file's name, such as "libpinocchio_default".
    """
    try:
        maps = Path("/proc/self/maps").read_bytes()
    except OSError:  # not Linux
        return []
    paths = [os.fsdecode(line.split(maxsplit=5)[-1]) for line in maps.splitlines()]
    return sorted({path for path in paths if Path(path).name.startswith(name)})


def _check_package(name: str) -> Finding:
    extra, use = _OPTIONAL[name]
    version = _version(name)
    if version is None:
        remedy = f"{use} needs it: pip install 'surefoot[{extra}]'"
        return Finding(AREA, name, "not installed", Verdict.LIMITED, remedy)
    return _finding(name, version)


def _check_pinocchio() -> Finding:
    files = loaded_libraries("libpinocchio_default")
    subject = "libpinocchio"
    version = _version("libpinocchio")
    if len(files) > 1:
        remedy = "two copies in one process may crash; run: unset LD_LIBRARY_PATH"
        return Finding(AREA, subject, " and ".join(files), Verdict.BAD, remedy)
    return _finding(subject, f"{version}, {files[0] if files else 'linked into surefoot'}")


def _check_ddsc() -> Finding:
    """Load libddsc in a process of its own, as a link to a Go2 would."""
    program = (
        "import surefoot\n"
        "print(*surefoot.DdsNetwork('lo', 229, untested_library=True).notices, sep='; ')"
    )
    result = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, timeout=_MAX_IMPORT_TIME
    )
    if result.returncode == 0:
        return _finding("libddsc", result.stdout.strip())
    lines = result.stderr.strip().splitlines() or [f"exit status {result.returncode}"]
    problem = re.sub(r"^[\w.]*Error: ", "", lines[-1])
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


def _version(package: str) -> str | None:
    try:
        return importlib.metadata.version(package)
    except importlib.metadata.PackageNotFoundError:
        return None

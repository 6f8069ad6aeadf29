"""Executables of the solver comparison, one per solver, compiled on first use."""

from __future__ import annotations

import hashlib
import os
import shutil
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

from surefoot._core import Error
from surefoot.bench.solvers.solver_paths import PEERS_VARIABLE, cmake_definitions, solver_sources

CASADI, EIQUADPROG = "CASADI_DIR", "EIQUADPROG_PREFIX"
# CMake variables that each solver needs; _WHEELS has the package that provides each variable. The
# casadi wheel contains the libraries and headers of DAQP, OSQP, HPIPM and PIQP, and the adapters
# call these solvers directly. It contains qpOASES without headers, so the adapter of qpOASES calls
# casadi::conic.
SOLVERS: dict[str, tuple[str, ...]] = {
    "surefoot": ("EIGEN_INCLUDE",),
    "proxqp": ("EIGEN_INCLUDE", "PROXSUITE_INCLUDE"),
    "daqp": (CASADI,),
    "eiquadprog": ("EIGEN_INCLUDE", EIQUADPROG),
    "qpoases": (CASADI,),
    "osqp": (CASADI,),
    "hpipm": (CASADI,),
    "piqp": ("EIGEN_INCLUDE", CASADI),
}
BASELINE = "null"  # adapter that solves nothing; its time is the overhead in all other times
_WHEELS = {
    CASADI: "casadi==3.8.2",
    EIQUADPROG: "eiquadprog==1.3.0",
    "EIGEN_INCLUDE": "cmeel-eigen==3.4.1",
    "PROXSUITE_INCLUDE": "proxsuite[build]==0.8.0",
}


class SolverBuilder:
    """Builder that configures CMake once, then builds one executable per solver.

    Args:
        folder: Build folder. None: a folder in the user's cache, named by a hash of the settings.
        extra: Files of further adapters; each executable is named after its file.

    Raises:
        Error: CMake or the sources are missing, or the configuration failed.
    """

    def __init__(self, folder: Path | None = None, extra: Sequence[Path] = ()) -> None:
        self._defined = cmake_definitions()
        values = {**self._defined, "EXTRA_ADAPTERS": ";".join(str(path) for path in extra)}
        self._cmake = _find_cmake()
        self._folder = folder or _cache_folder(values)
        cmake_options = [f"-D{name}={value}" for name, value in values.items()]
        problem = _run_command(
            [self._cmake, "-S", str(solver_sources()), "-B", str(self._folder), *cmake_options]
        )
        if problem is not None:
            raise Error(f"solvers: CMake failed: {problem}")

    def build(self, solver: str) -> Path | str:
        """Build the executable of a solver; return its path, or the reason of the failure."""
        missing = [name for name in SOLVERS.get(solver, ()) if name not in self._defined]
        if missing:
            wheels = " ".join(_WHEELS[name] for name in missing)
            return (
                f"not installed: pip install {wheels}, here or in an environment named by "
                f"{PEERS_VARIABLE}"
            )
        target = f"bench_{solver}"
        command = [self._cmake, "--build", str(self._folder), "--target", target]
        problem = _run_command([*command, "--parallel", "1"])  # a compiler may take 2 GB
        return self._folder / target if problem is None else f"does not compile: {problem}"


def _find_cmake() -> str:
    cmake_beside_python = Path(sys.executable).parent / "cmake"
    found = str(cmake_beside_python) if cmake_beside_python.is_file() else shutil.which("cmake")
    if found is None:
        raise Error(
            "solvers: got no cmake, expected one: pip install cmake; a C++ compiler is needed too"
        )
    return found


def _cache_folder(values: dict[str, str]) -> Path:
    root = os.environ.get("XDG_CACHE_HOME") or str(Path.home() / ".cache")
    text = repr((str(solver_sources()), sorted(values.items())))
    return Path(root) / "surefoot" / f"solvers-{hashlib.sha256(text.encode()).hexdigest()[:12]}"


def _run_command(command: list[str]) -> str | None:
    """Run a command; return None, or the first line of its output with an error."""
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode == 0:
        return None
    lines = [line for line in (done.stdout + done.stderr).splitlines() if "rror" in line]
    return (lines or ["no error text"])[0].strip()

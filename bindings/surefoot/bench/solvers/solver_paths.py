"""Paths of the sources of the executables, and of the packages that contain the solvers."""

from __future__ import annotations

import importlib.metadata
import os
import sys
from collections.abc import Iterator
from pathlib import Path

import surefoot
from surefoot._core import Error

# Name of the environment variable that names one folder: a site-packages folder, a virtual
# environment, or a folder with several virtual environments.
PEERS_VARIABLE = "SUREFOOT_PEERS"
_REPOSITORY = Path(__file__).resolve().parents[4]


def solver_sources() -> Path:
    """Return the folder with the executables' CMakeLists.txt; raise Error if there is none."""
    for folder in (_REPOSITORY / "benchmarks", package_folder() / "benchmarks"):
        if (folder / "solvers" / "CMakeLists.txt").is_file():
            return folder / "solvers"
    raise Error("solvers: got no benchmarks/solvers, expected it in the package or the repository")


def package_folder() -> Path:
    """Return the folder of the package surefoot, with lib/ and include/."""
    return Path(surefoot.__path__[0])


def cmake_definitions() -> dict[str, str]:
    """Return the CMake definitions of all packages that are installed."""
    found: dict[str, str] = {"SUREFOOT_PREFIX": str(package_folder())}
    repository_headers = _REPOSITORY / "controller" / "src"
    private_headers = (
        repository_headers if repository_headers.is_dir() else solver_sources() / "include"
    )
    found["SUREFOOT_PRIVATE"] = str(private_headers)
    found["SUREFOOT_VERSION"] = importlib.metadata.version("surefoot")
    for site in package_folders():
        prefix, casadi = site / "cmeel.prefix", site / "casadi"
        _add_if_installed(found, "EIGEN_INCLUDE", prefix / "include/eigen3", "Eigen/Core")
        if _add_if_installed(
            found, "PROXSUITE_INCLUDE", prefix / "include", "proxsuite/proxqp/dense/dense.hpp"
        ):
            found["PROXSUITE_VERSION"] = _version("proxsuite", site)
        if _add_if_installed(
            found, "EIQUADPROG_PREFIX", prefix, "include/eiquadprog/eiquadprog-fast.hpp"
        ):
            found["EIQUADPROG_VERSION"] = _version("eiquadprog", site)
        if _add_if_installed(found, "CASADI_DIR", casadi, "include/daqp/api.h"):
            found["CASADI_VERSION"] = _version("casadi", site)
    return found


def package_folders() -> Iterator[Path]:
    """Yield site-packages folders: first those of this interpreter, then those of the peers."""
    yield package_folder().parent
    for entry in sys.path:
        if entry and Path(entry).name in ("site-packages", "dist-packages"):
            yield Path(entry)
    given = os.environ.get(PEERS_VARIABLE)
    # `surefoot bench --peers` installs the peers in .venv-peers. Use an absolute path, because
    # CMake resolves a relative path from the build folder.
    root = Path(given or ".venv-peers").absolute()
    yield root
    yield from sorted(root.glob("lib/python3*/site-packages"))
    yield from sorted(root.glob("*/lib/python3*/site-packages"))


def _add_if_installed(found: dict[str, str], name: str, folder: Path, probe_file: str) -> bool:
    if name in found or not (folder / probe_file).is_file():
        return False
    found[name] = str(folder)
    return True


def _version(name: str, site: Path) -> str:
    # The package may be a symbolic link without its .dist-info, so search sys.path too.
    for distribution in importlib.metadata.distributions(name=name, path=[str(site), *sys.path]):
        return distribution.version
    return "unknown"

"""Environments of the DDS tests: Python with Cyclone DDS of a version and the vendor's SDK.

They are made in .venv-peers when a test needs them. A test is skipped, with the reason, where the
interpreter or the package is missing.
"""

from __future__ import annotations

import itertools
import os
import shutil
import subprocess
from functools import cache
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
SYSTEM_LIBRARY = "libddsc.so.0debian"  # Debian 12, package libddsc0debian: version 0.10.2
# The wheel 0.10.2 exists for Python 3.8 .. 3.10 only, the wheel 11.0.1 for 3.10 .. 3.13.
_PYTHONS = {"0.10.2": ("3.10", "3.9", "3.8"), "11.0.1": ("3.11", "3.12", "3.13", "3.10")}
_WORKER = int(os.environ.get("PYTEST_XDIST_WORKER", "gw0").removeprefix("gw"))
_domains = itertools.cycle(range(20 + 50 * _WORKER, 70 + 50 * _WORKER))


def new_domain() -> int:
    """Return a domain for one test, so that tests can run in parallel and after a failure."""
    return next(_domains)


def _interpreter(version: str) -> str | None:
    for name in _PYTHONS[version]:
        found = shutil.which(f"python{name}")
        installed = sorted(Path.home().glob(f".pyenv/versions/{name}.*/bin/python"))
        for candidate in [*installed, *([Path(found)] if found else [])]:
            done = subprocess.run([candidate, "--version"], capture_output=True, text=True)
            if done.returncode == 0 and done.stdout.startswith(f"Python {name}."):
                return str(candidate)
    return None


@cache
def peer_python(version: str) -> str:
    """Return the interpreter of the environment with a version of cyclonedds, or skip the test."""
    interpreter = _interpreter(version)
    if interpreter is None:
        pytest.skip(f"no Python {' or '.join(_PYTHONS[version])} for cyclonedds {version}")
    python = ROOT / ".venv-peers" / f"dds-{version}" / "bin" / "python"
    ready = python.parents[1] / f"ready-{_WORKER}"
    if not ready.exists():
        commands = (
            [interpreter, "-m", "venv", str(python.parents[1])],
            [str(python), "-m", "pip", "install", "-q", f"cyclonedds=={version}", "numpy"],
            # The vendor's package asks for cyclonedds 0.10.2, but works with both versions.
            [str(python), "-m", "pip", "install", "-q", "--no-deps", "unitree-sdk2py-dimos==1.0.3"],
        )
        for command in commands:
            done = subprocess.run(command, capture_output=True, text=True)
            if done.returncode != 0:
                pytest.skip(f"cyclonedds {version} could not be installed: {done.stderr[-300:]}")
        ready.touch()
    return str(python)


def c_peer(folder: Path) -> Path:
    """Return the compiled peer with Cyclone DDS 0.10.2 and type information, or skip the test."""
    headers = Path("/usr/include/dds/dds.h")
    if shutil.which("idlc") is None or shutil.which("gcc") is None or not headers.exists():
        pytest.skip("no C peer of Cyclone DDS 0.10.2: apt install cyclonedds-dev cyclonedds-tools")
    types = ROOT / "controller" / "src" / "dds" / "idl" / "unitree_go.idl"
    program = folder / "dds_c_peer"
    source = Path(__file__).with_name("dds_c_peer.c")
    # idlc without -t: with type information.
    subprocess.run(["idlc", str(types)], cwd=folder, check=True)
    subprocess.run(
        ["gcc", f"-I{folder}", str(source), "unitree_go.c", "-lddsc", "-o", str(program)],
        cwd=folder,
        check=True,
    )
    return program


def library_path(version: str) -> str:
    """Return the libddsc of Surefoot in a version, or skip the test: 0.10.2 is that of Debian."""
    if version == "11.0.1":
        return ""
    if not any(Path(folder, SYSTEM_LIBRARY).exists() for folder in _library_folders()):
        pytest.skip("no libddsc 0.10.2: apt install libddsc0debian")
    return SYSTEM_LIBRARY


def _library_folders() -> list[str]:
    return [str(folder) for folder in (*Path("/usr/lib").glob("*-linux-gnu"), Path("/usr/lib"))]

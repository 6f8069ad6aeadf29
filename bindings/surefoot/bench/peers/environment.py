"""Python environment of a peer, set up on first use."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from surefoot.bench.peers.options import PeerError, PeerOptions

# Chosen: a slow network takes minutes.
INSTALL_TIMEOUT = 900.0  # [s] longest time of one pip call
PIP_OPTIONS = ["-q", "--disable-pip-version-check", "--retries", "1", "--only-binary", ":all:"]
LIBTSID_PYTHON = "3.13"
SITE_PLACEHOLDER = "SITE"  # stands for the environment's site-packages in a step
_COMPLETE_FILE = ".complete"


@dataclass(frozen=True)
class Environment:
    """Packages that are installed for a peer.

    Attributes:
        name: Name of the folder.
        steps: Arguments of each call of pip install, in order.
    """

    name: str
    steps: tuple[tuple[str, ...], ...]

    def folder(self, options: PeerOptions) -> Path:
        """Return the folder of the environment, which need not exist yet."""
        return options.folder.absolute() / self.name

    def python(self, options: PeerOptions) -> Path:
        """Return the path of the environment's interpreter."""
        scripts = "Scripts" if sys.platform == "win32" else "bin"
        return self.folder(options) / scripts / "python"

    def site_packages(self, options: PeerOptions) -> Path:
        """Return the path of the environment's site-packages."""
        folder = self.folder(options)
        if sys.platform == "win32":
            return folder / "Lib" / "site-packages"
        version = f"python{sys.version_info.major}.{sys.version_info.minor}"
        return folder / "lib" / version / "site-packages"

    def versions(self, names: Sequence[str]) -> dict[str, str]:
        """Return the pinned version of each package in `names` that has one."""
        words = [word for step in self.steps for word in step if "==" in word]
        pins = dict(word.split("==", 1) for word in words)
        return {name: pins[name] for name in names if name in pins}

    def prepare(self, options: PeerOptions) -> Path:
        """Install the environment if needed; return the path of its interpreter.

        Raises:
            PeerError: The installation failed or took too long.
        """
        python, mark = self.python(options), self.folder(options) / _COMPLETE_FILE
        expected_mark = f"{sys.version}\n{self.steps}\n"
        if _text(mark) == expected_mark and python.exists():
            return python
        options.report_progress(
            f"peers: installing {self.name} in {self.folder(options)} (about a minute)"
        )
        _run([sys.executable, "-m", "venv", "--clear", str(self.folder(options))])
        site = str(self.site_packages(options))
        for step in self.steps:
            words = [site if word == SITE_PLACEHOLDER else word for word in step]
            _run([str(python), "-m", "pip", "install", *PIP_OPTIONS, *words])
        mark.write_text(expected_mark, encoding="utf-8")
        return python


# TSID's newest wheel, 1.10.0, aborts with the Pinocchio that pip chooses for it; this set works.
# libtsid needs a separate first step. Its wheels contain no Python code but are tagged with one
# Python version, and pip accepts another Python version only with --target.
TSID = Environment(
    "tsid",
    (
        (
            *("--no-deps", "--python-version", LIBTSID_PYTHON, "--target", SITE_PLACEHOLDER),
            "libtsid==1.9.0",
        ),
        (
            "--no-deps",
            *("tsid==1.9.0", "pin==3.9.0", "libpinocchio==3.9.0", "eigenpy==3.12.0"),
            *("coal==3.0.2", "libcoal==3.0.2", "eiquadprog==1.3.0", "proxsuite==0.7.2"),
            *(
                "cmeel==0.59.0",
                "cmeel-assimp==6.0.2",
                "cmeel-boost==1.89.0",
                "cmeel-eigen==3.4.0.2",
            ),
            *("cmeel-console-bridge==1.0.2.3", "cmeel-octomap==1.10.0", "cmeel-qhull==8.0.2.1"),
            *("cmeel-tinyxml2==10.0.0", "cmeel-urdfdom==4.0.1", "cmeel-zlib==1.3.1"),
            *("numpy==2.3.5", "scipy==1.17.1"),
        ),
    ),
)
# PlaCo's requirements install Pinocchio 3.8.
PLACO = Environment("placo", (("placo==0.10.2",),))


def clean_environment() -> dict[str, str]:
    """Return the environment variables except PYTHON..., because PYTHONPATH adds our packages."""
    return {k: v for k, v in os.environ.items() if not k.startswith("PYTHON")}


def _run(words: list[str]) -> None:
    """Run a command without output; if it fails, raise PeerError with its last line of output."""
    try:
        process = subprocess.run(
            words,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            errors="replace",
            timeout=INSTALL_TIMEOUT,
            env=clean_environment(),
            check=False,
        )
    except (OSError, subprocess.TimeoutExpired) as problem:
        raise PeerError(f"its environment could not be made: {problem}") from None
    if process.returncode != 0:
        output_lines = (process.stderr or process.stdout).strip().splitlines() or ["no output"]
        raise PeerError(f"its environment could not be made: {output_lines[-1].strip()}")


def _text(file: Path) -> str | None:
    try:
        return file.read_text(encoding="utf-8")
    except OSError:
        return None

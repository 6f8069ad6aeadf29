# SPDX-License-Identifier: BSD-3-Clause
"""Every command of surefoot, from its parser, with arguments that let it do something briefly."""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
from pathlib import Path

from surefoot.cli.arguments import build_parser

# {folder} has run.npz, a log of surefoot stand. A command that takes minutes or waits for a person
# gets a wrong argument: it then reports an error.
ARGUMENTS = {
    "assess": "--scenario missing.toml",
    "bench": "--scenario quiet --ticks 10",
    "doctor": "--json {folder}/doctor.json",
    "estimate": "{folder}/run.npz",
    "export": "go1 {folder}/go1.robot",
    "faults": "--list",
    "gains": "--robot go1",
    "replay": "{folder}/run.npz",
    "robot": "--duration 0.1 --port 0",
    "robots": "",
    "run": "--port 9 --local-port 99999",
    "stand": "--duration 0.1 --json {folder}/out.json",
    "tune design": "--bandwidth 3",
    "tune live": "--port 0 --power-level 3",
    "tune search": "--trials 0",
    "walk": "--duration 0.1 --json {folder}/out.json",
}


def command_names(parser: argparse.ArgumentParser | None = None, prefix: str = "") -> list[str]:
    """Return the names of all commands, such as "stand" and "tune search"."""
    actions = (parser or build_parser())._actions
    names = []
    for action in actions:
        if isinstance(action, argparse._SubParsersAction):
            for name, command in action.choices.items():
                names += command_names(command, f"{prefix}{name} ")
    return names or [prefix.strip()]


def command_line(name: str, folder: Path | str) -> list[str]:
    """Return the words of a process that runs a command with its arguments of ARGUMENTS."""
    words = f"{name} {ARGUMENTS[name]}".split()
    return [sys.executable, "-m", "surefoot", *(word.format(folder=folder) for word in words)]


def call(name: str, folder: Path, **environment: str) -> subprocess.CompletedProcess[str]:
    """Run a command in its own process, in `folder`, with further environment variables."""
    return subprocess.run(
        command_line(name, folder),
        capture_output=True,
        text=True,
        timeout=120,
        cwd=folder,
        env=os.environ | environment,
    )

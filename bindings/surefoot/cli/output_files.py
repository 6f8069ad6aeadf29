"""Files that a command writes: checks before the run, and writing afterwards."""

from __future__ import annotations

import importlib
import json
import os
import sys
from pathlib import Path
from typing import Any

from surefoot._core import Error
from surefoot.cli.missing_module import missing_module
from surefoot.files.atomic_write import write_text_atomically
from surefoot.files.tables import check_table_name


def check_json_path(destination: str | None) -> None:
    """Raise Error if the file of --json cannot be written; call this before the run.

    Otherwise the result of the run would be lost.
    """
    if destination != "-":
        check_output_path("--json", destination)


def check_table_path(option: str, destination: str | None) -> None:
    """Raise Error unless `destination` is None or a .csv or .npz file that can be written."""
    if destination is not None:
        check_table_name(destination, option)
        check_output_path(option, destination)


def check_output_path(option: str, destination: str | None) -> None:
    """Raise Error unless `destination` is None or a file in a folder that can be written."""
    if destination is None:
        return
    path = Path(destination)
    if path.is_dir() or not path.parent.is_dir() or not os.access(path.parent, os.W_OK):
        raise Error(f"{option}: got '{path}', expected a file in a folder that can be written")


def write_json(destination: str | None, result: dict[str, Any], indent: int | None = 2) -> None:
    """Write a result as one JSON object to a file or, for "-", to stdout.

    Args:
        destination: Path, "-" for stdout, or None to write nothing.
        result: The object.
        indent: Spaces of indentation; None writes one line, for long logs.
    """
    if destination is None:
        return
    text = json.dumps(result, indent=indent, allow_nan=False) + "\n"
    if destination == "-":
        sys.stdout.write(text)
        return
    write_text_atomically(Path(destination), text)  # atomic: a second Ctrl-C may interrupt


def check_report_folder(folder: str | None, command: str, module: str) -> None:
    """Make the report's folder and import the report's writer; call this before the run.

    Args:
        folder: Folder of the report, or None for no report.
        command: Subcommand that writes the report, for the message.
        module: Module that writes the report; it is imported here.

    Raises:
        Error: The folder cannot be made, or a module is missing.
    """
    if folder is None:
        return
    try:
        Path(folder).mkdir(parents=True, exist_ok=True)
        importlib.import_module(module)
    except OSError as problem:
        raise Error(f"--report: cannot make the folder: {problem}") from None
    except ModuleNotFoundError as problem:
        raise missing_module(command, problem) from None

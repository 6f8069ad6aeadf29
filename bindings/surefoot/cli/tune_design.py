"""surefoot tune design: computes gains and stability margins."""

from __future__ import annotations

import argparse
import shlex
from pathlib import Path

from surefoot.cli.output_files import (
    check_json_path,
    check_output_path,
    check_report_folder,
    write_json,
)
from surefoot.cli.tune_design_options import add_options, read_settings

__all__ = ["add_options", "run"]


def run(arguments: argparse.Namespace) -> int | None:
    """Design gains, print them and write the requested files.

    Raises:
        Error: A wrong argument, a goal that cannot be stable, or CasADi is missing.
    """
    # These imports work without CasADi, so that load_casadi() can report it missing in one line.
    from surefoot.tune.design.closed_loop import load_casadi
    from surefoot.tune.design.gain_design import design_gains
    from surefoot.tune.design.text import design_summary, design_text

    load_casadi()
    check_json_path(arguments.json)
    check_output_path("--toml", arguments.toml)
    check_report_folder(arguments.report, "tune design", "surefoot.tune.design.report")
    design = design_gains(read_settings(arguments))
    summary = design_summary(design)
    if arguments.toml is not None:
        from surefoot.robot.gain_files import save_gains

        command = shlex.join(["surefoot", *arguments.argv])
        save_gains(arguments.toml, design.gains, design.body.robot.name, command)
    write_json(arguments.json, summary)
    page = None
    if arguments.report is not None:
        from surefoot.tune.design.report import write_report

        page = write_report(design, summary, Path(arguments.report), arguments.argv)
    if arguments.json != "-":
        print(design_text(design))
        for name, place in (("gains", arguments.toml), ("report", page)):
            if place is not None:
                print(f"{name:9} {place}")
    return None

# SPDX-License-Identifier: BSD-3-Clause
"""Write the reference pages that are tables of the package: commands, gains, faults, statuses."""

from __future__ import annotations

import argparse
import enum
from collections.abc import Iterator, Sequence
from pathlib import Path

import surefoot
from error_message_table import all_messages
from error_message_table import table as message_table
from surefoot.cli.arguments import build_parser

ENUMS = (
    "Status FallbackLevel Mode Start RequestStatus RiseStage ReachLimit WalkLimit Gait "
    "SensorVerdict ContactSource FaultReaction"
).split()


def _cell(text: object) -> str:
    return " ".join(str(text).split()).replace("|", "\\|").replace("<", "&lt;").replace("*", "\\*")


def _table(header: Sequence[str], rows: Sequence[Sequence[object]]) -> list[str]:
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    return [*lines, *("| " + " | ".join(map(str, row)) + " |" for row in rows), ""]


def _gains() -> list[str]:
    intro = (
        "All gains: `surefoot.gain_table()`, printed by `surefoot gains`. "
        "`surefoot gains --robot go1` prints the robot's own values."
    )
    lines = ["# Gains", "", intro, ""]
    groups: dict[str, list[surefoot.GainInfo]] = {}
    for info in surefoot.gain_table():
        groups.setdefault(info.group, []).append(info)
    for group, infos in groups.items():
        rows = [
            (
                f"`{info.name}`",
                _cell(info.unit),
                f"{info.minimum:g} .. {info.maximum:g}",
                f"{info.default:g}",
                _cell(info.meaning),
            )
            for info in infos
        ]
        lines += [f"## {group}", "", *_table(("gain", "unit", "range", "default", "meaning"), rows)]
    return lines


def _faults() -> list[str]:
    rows = [
        (
            f"`{info.name}`",
            _cell(info.meaning),
            info.reaction.name.lower(),
            f"{info.detection_time:g}",
            _cell(info.cleared_by),
            _cell(_while_stepping(info)),
        )
        for info in surefoot.fault_table()
    ]
    header = (
        "fault",
        "meaning",
        "reaction",
        "detected within [s]",
        "cleared by",
        "while the feet step",
    )
    intro = (
        "All faults that the supervisor reports: `surefoot.fault_table()`, or "
        "`surefoot faults --names`."
    )
    return ["# Faults", "", intro, "", *_table(header, rows)]


def _while_stepping(info: surefoot.FaultInfo) -> str:
    text: str = info.while_stepping
    if info.stepping_detection_time != info.detection_time:
        text += f" (within {info.stepping_detection_time:g} s)"
    return text


def _statuses() -> list[str]:
    lines = ["# Statuses", "", "Values of the enumerations that a controller reports.", ""]
    for name in ENUMS:
        kind: type[enum.Enum] = getattr(surefoot, name)
        rows = [(f"`{value.name}`", _cell(value.__doc__ or "")) for value in kind]
        lines += [
            f"## {name}",
            "",
            _cell(kind.__doc__ or ""),
            "",
            *_table(("value", "meaning"), rows),
        ]
    return lines


def _subcommands(parser: argparse.ArgumentParser) -> Iterator[argparse.ArgumentParser]:
    for action in parser._actions:
        if isinstance(action, argparse._SubParsersAction):
            for command in action.choices.values():
                below = list(_subcommands(command))
                yield from below or [command]


def _command(parser: argparse.ArgumentParser) -> list[str]:
    rows = []
    for action in parser._actions:
        name = ", ".join(action.option_strings) or str(action.metavar or action.dest)
        if action.option_strings and action.nargs != 0:
            name += f" {action.metavar or action.dest.upper()}"
        meaning = (action.help or "") % {**vars(action), "prog": parser.prog} if action.help else ""
        rows.append((f"`{name}`".replace("|", "\\|"), _cell(meaning)))
    usage = " ".join(parser.format_usage().removeprefix("usage: ").split())
    lines = [
        f"## {parser.prog}",
        "",
        _cell(parser.description or ""),
        "",
        "```text",
        usage,
        "```",
        "",
    ]
    epilog = ["```text", parser.epilog.strip(), "```", ""] if parser.epilog else []
    return [*lines, *_table(("option", "meaning"), rows), *epilog]


def _commands() -> list[str]:
    intro = (
        "Generated from the parsers. Exit status: 0 done, 1 a file could not be written, 2 a wrong "
        "argument, 3 the robot fell, 130 interrupted. `surefoot COMMAND --help` prints the same."
    )
    lines = ["# Command line", "", intro, ""]
    for command in _subcommands(build_parser()):
        lines += _command(command)
    return lines


def write_generated_pages(folder: Path) -> None:
    """Write cli.md, gains.md, faults.md, statuses.md and messages.md into an existing folder."""
    pages = {"cli": _commands(), "gains": _gains(), "faults": _faults(), "statuses": _statuses()}
    for name, lines in pages.items():
        (folder / f"{name}.md").write_text("\n".join(lines) + "\n", encoding="utf-8")
    (folder / "messages.md").write_text(message_table(all_messages()), encoding="utf-8")

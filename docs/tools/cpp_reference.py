# SPDX-License-Identifier: BSD-3-Clause
"""Write the pages of the C++ reference: one for each public header, filled in by Breathe."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from pathlib import Path

ROOT = Path(__file__).parents[2]
HEADERS = ROOT / "controller" / "include" / "surefoot"
XML = ROOT / "out" / "doxygen" / "xml"
GROUPS = {
    "Controllers": (
        "controller",
        "stand_controller",
        "walk_controller",
        "whole_body_controller",
        "supervisor",
        "runner",
    ),
    "Data": (
        "low_level",
        "types",
        "body_reference",
        "walk_velocity",
        "gains",
        "task",
        "planner",
        "qp_problem",
        "math",
    ),
    "Robots": ("robot", "robot_config"),
    "Estimation": ("state_estimator", "estimator_report"),
    "Safety and faults": ("safety", "arming", "fault", "fallback_level", "supervisor_enums"),
    "Link": (
        "frames",
        "robot_link",
        "udp_link",
        "wireless_remote",
        "dds_network",
        "dds_robot",
        "dds_link",
        "dds_robot_port",
        "dds_service",
    ),
    "Errors, logs, timing": ("error", "run_log", "stage_clock"),
}
UMBRELLA = "surefoot"  # includes all the others but dds_*.hpp
DIRECTIVES = {"typedef": "typedef", "enum": "enum", "variable": "variable", "function": "function"}


def write_cpp_pages(folder: Path, with_doxygen: bool) -> None:
    """Write cpp-api.md and a page for each header.

    Args:
        folder: Existing folder.
        with_doxygen: True if Doxygen has written its XML. False writes one page that says that
            this part is missing.

    Raises:
        RuntimeError: A header is in no group.
    """
    grouped = {name for names in GROUPS.values() for name in names}
    headers = {path.stem for path in HEADERS.glob("*.hpp")} - {UMBRELLA}
    if grouped != headers:
        raise RuntimeError(f"cpp_reference.py: no group has, or no header is: {grouped ^ headers}")
    include = f"`#include <surefoot/{UMBRELLA}.hpp>` includes all headers but dds_*.hpp."
    index = ["# C++ API", "", include, ""]
    if not with_doxygen:
        index += ["Doxygen was not installed where this site was built. Read the headers in"]
        index += ["{source}`controller/include/surefoot`.", ""]
    for title, names in GROUPS.items() if with_doxygen else ():
        index += [f"## {title}", "", "```{toctree}", ":maxdepth: 1", ""]
        index += [f"cpp-{name.replace('_', '-')}" for name in names] + ["```", ""]
        for name in names:
            page = folder / f"cpp-{name.replace('_', '-')}.rst"
            page.write_text(_header_page(name), encoding="utf-8")
    (folder / "cpp-api.md").write_text("\n".join(index), encoding="utf-8")


def _header_page(name: str) -> str:
    """Return the page of a header: a directive for each class and for each other name in it."""
    file = XML / f"{name.replace('_', '__')}_8hpp.xml"
    compound = ET.parse(file).getroot().find("compounddef")
    assert compound is not None
    classes = [inner.text or "" for inner in compound.findall("innerclass")]
    nested = {name for name in classes for outer in classes if name.startswith(f"{outer}::")}
    parts = [
        f".. doxygen{_kind(inner)}:: {inner.text}\n   :members:\n"
        for inner in compound.findall("innerclass")
        if inner.text not in nested
    ]
    # Doxygen keeps functions, constants and enumerations with their namespace, not with the file.
    for member in ET.parse(XML / "namespacesurefoot.xml").getroot().iter("memberdef"):
        kind, location = member.get("kind", ""), member.find("location")
        assert location is not None
        if kind in DIRECTIVES and location.get("file", "").endswith(f"/{name}.hpp"):
            parts.append(f".. doxygen{DIRECTIVES[kind]}:: {_qualified_name(member)}\n")
    title = f"{name}.hpp"
    intro = f"``#include <surefoot/{title}>``"
    return f"{title}\n{'=' * len(title)}\n\n{intro}\n\n" + "\n".join(parts)


def _kind(inner: ET.Element) -> str:
    return "class" if inner.get("refid", "").startswith("class") else "struct"


def _qualified_name(member: ET.Element) -> str:
    """Return the name of a member, with parameters if it is a function: it may be overloaded."""
    name = member.findtext("qualifiedname") or f"surefoot::{member.findtext('name')}"
    if member.get("kind") != "function":
        return name
    return name + (member.findtext("argsstring") or "").split(" noexcept")[0]

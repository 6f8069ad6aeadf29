# SPDX-License-Identifier: BSD-3-Clause
"""Mutations of a robot's URDF, SRDF and TOML: dropped, doubled, negated, scaled, renamed values."""

from __future__ import annotations

import copy
import random
import xml.etree.ElementTree as ET
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from surefoot.robot.description import RobotDescription

SCALES = (0.0, 1e-6, 1e-3, 0.1, 0.5, 0.9, 1.1, 2.0, 10.0, 57.3, 1e3, 1e6, 1e15)
GARBAGE = ("nan", "inf", "-inf", "0,5", "", "abc", "1e400", "0x10", "1 2", "1e-320", "None")
TAGS = ("link", "joint", "inertial", "origin", "mass", "inertia", "axis", "limit", "parent")
TAGS += ("child", "collision", "geometry", "box", "cylinder", "sphere", "mesh", "dynamics")
MESHES = "package://example-robot-data/"


@dataclass
class MutantFiles:
    """Paths of a mutated pair, what was changed, and the names that a message may name."""

    urdf: Path
    config: Path
    changes: list[str]
    names: set[str]


def write_mutant(description: RobotDescription, rng: random.Random, folder: Path) -> MutantFiles:
    """Write a mutated copy of a robot's files: one to three changes."""
    text = description.urdf.read_text(encoding="utf-8")
    urdf = ET.fromstring(text.replace(MESHES, f"{description.mesh_root}/"))
    assert description.srdf is not None
    srdf = ET.parse(description.srdf).getroot()
    table = copy.deepcopy(description.table)
    table["robot"].pop("urdf")
    table["robot"]["srdf"] = "mutant.srdf"
    names = set(_names(urdf)) | {key for rows in table.values() for key in rows} | set(table)
    changes, lines = [], []
    for _ in range(rng.choice((1, 1, 1, 2, 3))):
        kind = rng.choices(("urdf", "toml", "srdf"), (12, 7, 1))[0]
        if kind == "toml":
            changes.append(_mutate_table(table, rng, lines))
        else:
            changes.append(f"{kind}: {_mutate_tree(urdf if kind == 'urdf' else srdf, rng)}")
    paths = [folder / f"mutant.{end}" for end in ("urdf", "srdf", "toml")]
    ET.ElementTree(urdf).write(paths[0], encoding="utf-8", xml_declaration=True)
    ET.ElementTree(srdf).write(paths[1], encoding="utf-8")
    paths[2].write_text(_toml(table, lines), encoding="utf-8")
    names |= set(_names(urdf)) | set(_names(srdf))
    return MutantFiles(paths[0], paths[2], changes, {name for name in names if name})


def _names(tree: ET.Element) -> list[str]:
    # Numbers are no names, but "0" is a part of many messages.
    values = [v for e in tree.iter() for v in e.attrib.values()] + [e.tag for e in tree.iter()]
    return [value for value in values if len(value) > 2 and value[0].isalpha()]


def _mutate_tree(tree: ET.Element, rng: random.Random) -> str:
    parents = {child: parent for parent in tree.iter() for child in parent}
    relevant = [e for e in parents if e.tag in TAGS or e.tag == "disable_collisions"]
    element = rng.choice(relevant)
    parent = parents[element]
    what = f"<{element.tag} {' '.join(f'{k}={v!r}' for k, v in element.attrib.items())}>"
    what += f" in <{parent.tag} {parent.get('name', '')}>"
    numbers = [k for k, v in element.attrib.items() if _is_numbers(v)]
    texts = [k for k in element.attrib if k not in numbers]
    action = rng.choice(("drop", "double", "rename tag", "reorder", "swap", *["value"] * 7))
    if action == "drop":
        parent.remove(element)
    elif action == "double":
        parent.insert(list(parent).index(element), copy.deepcopy(element))
    elif action == "rename tag":
        element.tag = rng.choice((element.tag + "s", element.tag[:-1], "foo", "joint", "origin"))
    elif action == "reorder":
        rng.shuffle(target := list(parent))
        parent[:] = target
    elif action == "swap":
        other = rng.choice([e for e in relevant if e.tag == element.tag])
        other.attrib, element.attrib = dict(element.attrib), dict(other.attrib)
        return f"swap {what} with {other.attrib}"
    elif numbers and (not texts or rng.random() < 0.8):
        name = rng.choice(numbers)
        element.set(name, _mutate_numbers(element.attrib[name], rng))
        return f"{name} of {what} = {element.get(name)!r}"
    elif texts:
        return f"{what}: {_mutate_text(element, rng.choice(texts), tree, rng)}"
    return f"{action} {what}"


def _is_numbers(text: str) -> bool:
    try:
        return [float(word) for word in text.split()] != []
    except ValueError:
        return False


def _mutate_numbers(text: str, rng: random.Random) -> str:
    words = text.split()
    k = rng.randrange(len(words))
    action = rng.choice(("negate", "scale", "scale", "scale", "garbage", "drop", "reorder", "add"))
    if action == "negate":
        words[k] = repr(-float(words[k]))
    elif action == "scale":
        words[k] = repr(float(words[k]) * rng.choice(SCALES))
    elif action == "add":
        words[k] = repr(float(words[k]) + rng.choice((-3.14, -1.0, -0.1, 0.01, 0.3, 1.57, 5.0)))
    elif action == "garbage":
        words[k] = rng.choice(GARBAGE)
    elif action == "drop":
        del words[k]
    else:
        rng.shuffle(words)
    return " ".join(words)


def _mutate_text(element: ET.Element, name: str, tree: ET.Element, rng: random.Random) -> str:
    old = element.attrib[name]
    others = [e.get(name, "") for e in tree.iter(element.tag)]
    new = rng.choice((old + " x", old[:-1], "", "world", "ümlaut", rng.choice(others), "fixed"))
    if rng.random() < 0.2:
        element.attrib.pop(name)
        return f"drop {name}"
    if rng.random() < 0.2:
        element.set(name + "s", element.attrib.pop(name))
        return f"rename {name} to {name}s"
    element.set(name, new)
    return f"{name} = {new!r}"


def _mutate_table(table: dict[str, Any], rng: random.Random, lines: list[str]) -> str:
    section = rng.choice(list(table))
    rows = table[section]
    if rng.random() < 0.05 or not rows:
        del table[section]
        return f"toml: drop [{section}]"
    key = rng.choice(list(rows))
    action = rng.choice(("drop", "double", "rename", *["value"] * 7))
    if action == "drop":
        del rows[key]
    elif action == "rename":
        rows[rng.choice((key + "s", key[:-1], "foo"))] = rows.pop(key)
    elif action == "double":
        lines.append(f"[{section}]")
    else:
        rows[key] = _mutate_value(rows[key], rng)
        return f"toml: {section}.{key} = {rows[key]!r}"
    return f"toml: {action} {section}.{key}"


def _mutate_value(value: Any, rng: random.Random) -> Any:
    if isinstance(value, list) and value:
        k = rng.randrange(len(value))
        action = rng.choice(("value", "value", "value", "drop", "double", "reorder", "all"))
        if action == "value":
            return [*value[:k], _mutate_value(value[k], rng), *value[k + 1 :]]
        if action == "all" and not isinstance(value[0], str):
            return [number * rng.choice(SCALES) for number in value]
        if action == "reorder":
            return rng.sample(value, len(value))
        return value[:k] + value[k + (action == "drop") :] + value[k : k + (action == "double")]
    if isinstance(value, str):
        return rng.choice((value + " x", value[:-1], "", "world", value.lower(), "FL_foot", 3))
    if isinstance(value, bool):
        return rng.choice((not value, "yes", 1))
    number = float(value) if abs(value) < 1e300 else 1.0  # a second change of the same value
    return rng.choice(
        (
            *(-number, number * rng.choice(SCALES), number + rng.choice((-1.0, 0.1, 1.0))),
            *(float("nan"), float("inf"), str(value), 10**400, number * 57.3),
        )
    )


def _toml(table: dict[str, Any], lines: list[str]) -> str:
    for section, rows in table.items():
        lines = [*lines, f"[{section}]", *(f"{k} = {_toml_value(v)}" for k, v in rows.items())]
    return "\n".join(lines) + "\n"


def _toml_value(value: Any) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return '"' + value.replace("\\", "\\\\").replace('"', '\\"') + '"'
    if isinstance(value, list):
        return "[" + ", ".join(map(_toml_value, value)) + "]"
    return repr(value)

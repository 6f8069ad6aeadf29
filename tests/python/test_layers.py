# SPDX-License-Identifier: BSD-3-Clause
"""Imports point down the layers of docs/layers.toml, and modules do not import in a circle."""

from __future__ import annotations

import ast
import re
import tomllib
from collections.abc import Iterator
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
SOURCES, PACKAGE = ROOT / "controller" / "src", ROOT / "bindings" / "surefoot"
LAYERS = tomllib.loads((ROOT / "docs" / "layers.toml").read_text())
INCLUDE = re.compile(r'^#include "([^"]+)"', re.MULTILINE)

Import = tuple[str, str]  # what imports, what is imported: paths or dotted names


def levels(language: str) -> dict[str, int]:
    """Return the level of every listed folder."""
    layers = LAYERS[language]["layers"]
    return {folder: level for level, folders in enumerate(layers) for folder in folders}


def layer_of(name: str, known: dict[str, int], separator: str) -> str | None:
    """Return the listed folder that a file or module is in, the innermost one."""
    parts = name.split(separator)
    prefixes = (separator.join(parts[:k]) for k in range(len(parts), 0, -1))
    return next((prefix for prefix in prefixes if prefix in known), None)


def upward(imports: list[Import], known: dict[str, int], separator: str) -> list[str]:
    """Return a line for every import that points up or sideways, or comes from no layer."""
    found = []
    for source, target in imports:
        above, below = (layer_of(name, known, separator) for name in (source, target))
        if above is None or below is None:
            found.append(f"{source} imports {target}: not in docs/layers.toml")
        elif above != below and known[above] <= known[below]:
            found.append(f"{source} ({above}) imports {target} ({below}), which is not below it")
    return found


def cpp_imports() -> list[Import]:
    """Return every include between files of controller/src, public headers as their layers."""
    headers, found = LAYERS["cpp"]["headers"], []
    for path in sorted(SOURCES.rglob("*.?pp")):
        for name in INCLUDE.findall(path.read_text()):
            target = headers.get(name.removeprefix("surefoot/")) if "surefoot/" in name else name
            if target is not None:
                found.append((str(path.relative_to(SOURCES)), target))
    return found


def module_name(path: Path) -> str:
    """Return a module's dotted name below surefoot; "surefoot" for the package itself."""
    parts = path.relative_to(PACKAGE).with_suffix("").parts
    parts = parts[:-1] if parts[-1] == "__init__" else parts
    return ".".join(parts) or "surefoot"


def python_imports(text: str, modules: set[str]) -> Iterator[str]:
    """Yield the modules of surefoot that a file imports, anywhere in it."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.ImportFrom) and (node.module or "").split(".")[0] == "surefoot":
            package = (node.module or "").removeprefix("surefoot").removeprefix(".")
            for alias in node.names:
                inner = f"{package}.{alias.name}".removeprefix(".")
                yield inner if inner in modules else package or "surefoot"
        elif isinstance(node, ast.Import):
            for alias in node.names:
                if alias.name.split(".")[0] == "surefoot":
                    yield alias.name.removeprefix("surefoot").removeprefix(".") or "surefoot"


def package_imports() -> list[Import]:
    """Return every import between modules of bindings/surefoot."""
    paths = {module_name(path): path for path in sorted(PACKAGE.rglob("*.py"))}
    modules = {*paths, *LAYERS["python"]["layers"][0]}
    return [
        (name, target)
        for name, path in paths.items()
        for target in python_imports(path.read_text(), modules)
        if target != name
    ]


def test_cpp_includes_point_down() -> None:
    imports = cpp_imports()
    assert len(imports) > 300  # the sources were found
    assert upward(imports, levels("cpp"), "/") == []


def test_python_imports_point_down() -> None:
    imports = package_imports()
    assert len(imports) > 700
    assert upward(imports, levels("python"), ".") == []


def test_python_modules_do_not_import_in_a_circle() -> None:
    graph: dict[str, set[str]] = {}
    for source, target in package_imports():
        graph.setdefault(source, set()).add(target)
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as circle:
        pytest.fail(f"import circle: {' -> '.join(circle.args[1])}")


@pytest.mark.parametrize(
    ("language", "separator", "import_"),
    [
        ("cpp", "/", ("tasks/com_task.cpp", "wbc/qp_terms.hpp")),
        (
            "cpp",
            "/",
            ("safety/torque_command.hpp", LAYERS["cpp"]["headers"]["stand_controller.hpp"]),
        ),
        ("cpp", "/", ("wbc/limits.cpp", "safety/power_limiter.hpp")),
        ("cpp", "/", ("new_folder/file.cpp", "common/text.hpp")),
        ("python", ".", ("tune.live.control_process", "cli.run_text")),
        ("python", ".", ("robot.loading", "sim.plant")),
    ],
)
def test_an_upward_import_is_found(language: str, separator: str, import_: Import) -> None:
    assert len(upward([import_], levels(language), separator)) == 1

# SPDX-License-Identifier: BSD-3-Clause
"""Build the documentation site into out/docs, and check that nothing is missing from it.

    python docs/tools/build_site.py [--output FOLDER]

Prints one line for each problem; the status is then 1. Problems: what Sphinx or Doxygen warns of
(a broken link, a public name without documentation), and a name of a public module's `__all__`
that no page documents.
"""

from __future__ import annotations

import argparse
import importlib
import re
import shutil
import subprocess
import sys
from pathlib import Path

from python_reference import is_repeated, public_modules
from sphinx.util.inventory import InventoryFile

ROOT = Path(__file__).parents[2]
LOCATION = re.compile(r"^(?P<where>.*?): (?:WARNING|ERROR|CRITICAL): (?P<what>.*)$")
FATAL = re.compile(r"^(?:\w+Error|Exception|Configuration error)\b.*")


def run_sphinx(builder: str, output: Path) -> list[str]:
    """Run one of Sphinx's builders.

    Returns:
        Problems, one line each; empty: none.
    """
    # Sphinx walks all of Python below a module that is no package, and warns about what it finds;
    # the list of the coverage builder is right all the same.
    strict = ["-W"] if builder != "coverage" else []
    options = [*strict, "-n", "--keep-going", "-q", "--no-color"]
    options += ["-d", str(output.parent / "docs-cache")]
    command = [sys.executable, "-m", "sphinx", "-b", builder, *options, "docs", str(output)]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    if builder == "coverage" and not done.returncode:
        return undocumented(output)
    lines = [" ".join(line.split()) for line in done.stderr.splitlines()]
    found = []
    for line in lines:
        if match := LOCATION.match(line):
            found.append(f"{match['where'].removeprefix(f'{ROOT}/')}: {match['what']}")
        elif FATAL.match(line) or line.startswith(f"{ROOT}/controller/include"):
            found.append(line.removeprefix(f"{ROOT}/"))
    if done.returncode and not found:
        found = [f"sphinx: {' '.join(lines)[-300:]}"]
    return list(dict.fromkeys(found))


def undocumented(coverage: Path) -> list[str]:
    """Return the entries of sphinx.ext.coverage's list, one line each."""
    text = (coverage / "python.txt").read_text(encoding="utf-8")
    parts = text.split("Undocumented Python objects", 1)
    module, found = "", []
    for line in parts[-1].splitlines() if len(parts) > 1 else []:
        if re.fullmatch(r"[\w.]+", line) and not set(line) <= {"=", "-"}:
            module = line
        elif match := re.match(r"\s*\* (\S+)|\s+- (\S+)", line):
            found.append(f"{module}: {match[1] or match[2]} has no documentation on any page")
    return found


def missing_names(site: Path) -> list[str]:
    """Return a line for each name of a public module's __all__ that the site does not have."""
    inventory = InventoryFile.loads((site / "objects.inv").read_bytes(), uri="")
    known = {name for kind in inventory.data for name in inventory.data[kind]}
    return [
        f"{module}.{name} is on no page"
        for module in public_modules()
        for name in importlib.import_module(module).__all__
        if f"{module}.{name}" not in known and not is_repeated(module, name)
    ]


def main() -> int:
    """Build, check, print; return the status."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--output", type=Path, default=ROOT / "out" / "docs")
    site = parser.parse_args().output.resolve()
    if not shutil.which("doxygen"):
        print("no doxygen: the C++ reference is left out (apt install doxygen)")
    site.parent.mkdir(parents=True, exist_ok=True)
    problems = run_sphinx("html", site)
    if not problems:
        coverage = site.parent / "docs-coverage"
        problems = [
            *run_sphinx("coverage", coverage),
            *undocumented(coverage),
            *missing_names(site),
        ]
    for problem in problems:
        print(problem)
    print(f"{site}/index.html: {len(problems)} problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())

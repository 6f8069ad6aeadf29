# SPDX-License-Identifier: BSD-3-Clause
"""Configuration of the documentation site; `make docs` builds it with Sphinx."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

from docutils import nodes
from sphinx.application import Sphinx

DOCS = Path(__file__).parent
ROOT = DOCS.parent
sys.path.insert(0, str(DOCS / "tools"))

import surefoot
from cpp_reference import write_cpp_pages
from generated_pages import write_generated_pages
from python_reference import public_modules, write_python_pages

project = "Surefoot"
author = "the Surefoot developers"
copyright = "2026, the Surefoot developers"
version = release = surefoot.__version__

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.coverage",
    "sphinx.ext.napoleon",
    "sphinx_copybutton",
]
exclude_patterns = ["tools/**"]
nitpicky = True
# Names of other projects, which this site does not link to, and type variables.
nitpick_ignore_regex = [
    ("py:.*", r"(os|numpy|np|npt|casadi|pinocchio|mujoco|pathlib|argparse|collections|typing)\..*"),
    ("py:.*", r"(ndarray|NDArray|ArrayLike|Path|Callable|Sequence|Iterator|Iterable|Mapping|Any)"),
    ("py:.*", r"(TextIO|BinaryIO|Literal|Protocol|enum\..*|threading\..*|subprocess\..*)"),
    ("py:.*", r"surefoot(\.\w+){3,}"),  # classes of modules that are not public
    ("cpp:.*", r"(std|Eigen|pinocchio)(::.*)?"),
    ("cpp:.*", r"u?int\d+_t|size_t"),
    ("cpp:.*", r"(Vector\d+|Matrix\d+|FeetMatrix|Quaternion)::(Zero|Identity|UnitZ|Ones)"),
    # The namespace, and classes that public headers declare and the library defines.
    ("cpp:.*", r"surefoot|Impl|Data|Dynamics|DdsParticipant"),
    ("py:.*", r"surefoot\._plant\..*"),
    ("py:.*", r"ControllerFailure|Options|RobotDescription|DatagramPort"),  # not public
]

html_theme = "furo"
html_title = f"Surefoot {version}"
html_static_path = ["static"]
html_css_files = ["site.css"]
html_theme_options = {"top_of_page_buttons": []}
html_copy_source = False
html_show_sphinx = False

myst_enable_extensions = ["colon_fence"]
myst_heading_anchors = 4

napoleon_use_ivar = True  # else a dataclass would have each field twice
autodoc_member_order = "bysource"
autoclass_content = "both"  # nanobind documents the constructor at __init__
autodoc_typehints = "description"
autodoc_default_options = {"members": True, "undoc-members": False}
coverage_modules = public_modules()
# Modules that are not public.
coverage_ignore_modules = [r"surefoot\.\w+\.\w+", r"surefoot\._\w+", r"surefoot\.cli"]
coverage_show_missing_items = True
coverage_statistics_to_stdout = False

if shutil.which("doxygen"):
    extensions.append("breathe")
    breathe_projects = {"surefoot": str(ROOT / "out" / "doxygen" / "xml")}
    breathe_default_project = "surefoot"
    breathe_default_members = ("members",)


def _source_role(name, rawtext, text, lineno, inliner, options=None, content=None):
    """Show the path of a source file; a path that does not exist is an error of the page."""
    if not (ROOT / text).exists():
        message = inliner.reporter.warning(f"source file {text} does not exist", line=lineno)
        return [inliner.problematic(rawtext, rawtext, message)], [message]
    return [nodes.literal(rawtext, text, classes=["source-path"])], []


def _keep_colons(app, what, name, obj, options, lines) -> None:
    """Keep napoleon from taking the text before a colon for the type of an attribute."""
    if what in ("attribute", "property", "data") and lines and ":" in lines[0]:
        lines[:0] = ["..", ""]


def _run_doxygen() -> None:
    """Run Doxygen on the public headers.

    Raises:
        RuntimeError: It warned, for example of a member without documentation.
    """
    (ROOT / "out" / "doxygen").mkdir(parents=True, exist_ok=True)
    done = subprocess.run(["doxygen", "docs/Doxyfile"], cwd=ROOT, capture_output=True, text=True)
    if done.returncode or done.stderr:
        raise RuntimeError(f"doxygen: {done.stderr.strip()}")


def setup(app: Sphinx) -> None:
    """Write the generated pages, before Sphinx looks for pages."""
    app.add_role("source", _source_role)
    app.connect("autodoc-process-docstring", _keep_colons, priority=400)  # napoleon has 500
    generated = DOCS / "reference" / "generated"
    shutil.rmtree(generated, ignore_errors=True)
    generated.mkdir(parents=True)
    write_generated_pages(generated)
    write_python_pages(generated)
    with_doxygen = "breathe" in extensions
    if with_doxygen:
        _run_doxygen()
    write_cpp_pages(generated, with_doxygen)

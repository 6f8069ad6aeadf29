# SPDX-License-Identifier: BSD-3-Clause
"""The C++ examples, built once against the installed package."""

from __future__ import annotations

import os
import subprocess
import sys
from functools import cache
from pathlib import Path

import surefoot

EXAMPLES = Path(__file__).parents[2] / "examples"
CMAKE = Path(sys.executable).with_name("cmake")


@cache
def build_examples() -> Path:
    """Build the C++ examples; return the folder with their executables and go1.robot."""
    build = EXAMPLES.parent / "build" / "examples"
    path = {"PATH": f"{CMAKE.parent}:{os.environ['PATH']}"}
    prefix = f"-DCMAKE_PREFIX_PATH={surefoot.__path__[0]}"
    for words in (["-S", str(EXAMPLES), "-B", str(build), prefix], ["--build", str(build)]):
        done = subprocess.run(
            [CMAKE, *words], env={**os.environ, **path}, capture_output=True, text=True
        )
        assert done.returncode == 0, done.stdout + done.stderr
    surefoot.load_robot("go1").save(str(build / "go1.robot"))
    return build

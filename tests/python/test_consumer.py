"""A C++ user's project against the installed package: what the README and examples/ promise."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest
import surefoot

ROOT = Path(__file__).parents[2]
CMAKE = Path(sys.executable).with_name("cmake")


def _readme_blocks(language: str) -> list[str]:
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    return re.findall(rf"```{language}\n(.*?)```", text, re.DOTALL)


def _readme_block(language: str) -> str:
    (block,) = _readme_blocks(language)
    return str(block)


def _build(folder: Path, source: str) -> Path:
    (folder / "stand.cpp").write_text(source, encoding="utf-8")
    (folder / "CMakeLists.txt").write_text(_readme_block("cmake"), encoding="utf-8")
    prefix = f"-DCMAKE_PREFIX_PATH={surefoot.__path__[0]}"
    for step in (["-S", ".", "-B", "build", prefix], ["--build", "build"]):
        subprocess.run([CMAKE, *step], cwd=folder, check=True, capture_output=True, timeout=600)
    surefoot.load_robot("go1").save(str(folder / "go1.robot"))
    return folder / "build" / "stand"


@pytest.mark.parametrize("source", ["readme", "example"])
def test_a_cpp_project_finds_builds_and_runs_the_installed_package(
    source: str, tmp_path: Path
) -> None:
    example = (ROOT / "examples" / "stand.cpp").read_text(encoding="utf-8")
    program = _build(tmp_path, _readme_block("cpp") if source == "readme" else example)
    subprocess.run([program], cwd=tmp_path, check=True, timeout=60)


@pytest.mark.parametrize("number", [0, 1])
def test_the_readmes_python_runs_as_pasted(number: int, tmp_path: Path) -> None:
    command = [sys.executable, "-c", _readme_blocks("python")[number]]
    done = subprocess.run(command, cwd=tmp_path, check=True, capture_output=True, text=True)
    assert "Status.OK" in done.stdout

"""The code of README.md and examples/, built and run against the installed package."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
import surefoot

pytestmark = pytest.mark.build

ROOT = Path(__file__).parents[2]
CMAKE = Path(sys.executable).with_name("cmake")
CUSTOM_TASK_OUTPUT = "camera at 0.080 m, desired 0.080 m\n"


def _readme_blocks(language: str) -> list[str]:
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    return re.findall(rf"```{language}\n(.*?)```", text, re.DOTALL)


def _readme_block(language: str) -> str:
    (block,) = _readme_blocks(language)
    return str(block)


def _example(name: str) -> str:
    return (ROOT / "examples" / name).read_text(encoding="utf-8")


def _cmake(folder: Path, *arguments: str) -> None:
    """Run cmake with this environment's Python first on the PATH, which finds Pinocchio."""
    environment = {"CMAKE_BUILD_PARALLEL_LEVEL": "2", **os.environ}
    environment["PATH"] = f"{CMAKE.parent}:{environment['PATH']}"
    done = subprocess.run(
        [CMAKE, *arguments],
        cwd=folder,
        env=environment,
        capture_output=True,
        text=True,
        timeout=900,
    )
    assert done.returncode == 0, done.stdout + done.stderr


def _cmake_install(folder: Path) -> str:
    """Install with CMake alone from the wheel's build folder: compiling again takes minutes."""
    built = str(next((ROOT / "build").glob("cp3*/CMakeCache.txt")).parent)
    prefix = str(folder / "prefix")
    try:
        _cmake(ROOT, "-S", ".", "-B", built, "-DSKBUILD=OFF")
        _cmake(ROOT, "--build", built, "--target", "surefoot")  # links again
        _cmake(ROOT, "--install", built, "--prefix", prefix)
    finally:
        _cmake(ROOT, "-S", ".", "-B", built, "-DSKBUILD=2")
        _cmake(ROOT, "--build", built, "--target", "surefoot")
    return prefix


def _build(folder: Path, source: str, prefix: str) -> Path:
    (folder / "stand.cpp").write_text(source, encoding="utf-8")
    (folder / "CMakeLists.txt").write_text(_readme_block("cmake"), encoding="utf-8")
    _cmake(folder, "-S", ".", "-B", "build", f"-DCMAKE_PREFIX_PATH={prefix}")
    _cmake(folder, "--build", "build")
    surefoot.load_robot("go1").save(str(folder / "go1.robot"))
    return folder / "build" / "stand"


def _run(command: list[str | Path], folder: Path) -> str:
    done = subprocess.run(
        command, cwd=folder, check=True, capture_output=True, text=True, timeout=120
    )
    return done.stdout


def test_a_cpp_project_finds_builds_and_runs_the_wheel(tmp_path: Path) -> None:
    _run([_build(tmp_path, _readme_block("cpp"), surefoot.__path__[0])], tmp_path)


def test_a_cpp_project_finds_builds_and_runs_a_plain_cmake_install(tmp_path: Path) -> None:
    program = _build(tmp_path, _readme_block("cpp"), _cmake_install(tmp_path))
    _run([program], tmp_path)
    linked = _run(["ldd", program], tmp_path)
    assert str(tmp_path / "prefix" / "lib" / "libsurefoot.so") in linked


def test_custom_task_example_runs_in_python(tmp_path: Path) -> None:
    assert (
        _run([sys.executable, ROOT / "examples" / "custom_task.py"], tmp_path) == CUSTOM_TASK_OUTPUT
    )


def test_custom_planner_example_moves_the_body_on_a_circle_of_4_cm(tmp_path: Path) -> None:
    said = _run([sys.executable, ROOT / "examples" / "custom_planner.py"], tmp_path)
    assert said.startswith("OK, fell: False, circle of ")
    widths = [float(number) for number in re.findall(r"([0-9.]+) cm", said)]
    assert widths == pytest.approx([4.0, 4.0], abs=0.6)


@pytest.mark.parametrize(
    ("example", "limit"),
    [
        ("custom_task.cpp", 40),
        ("custom_task.py", 40),
        ("custom_planner.cpp", 60),
        ("custom_planner.py", 60),
    ],
)
def test_example_is_short(example: str, limit: int) -> None:
    lines = [line.strip() for line in _example(example).splitlines()]
    assert len([line for line in lines if line and not line.startswith(("//", "#", '"""'))]) < limit

# SPDX-License-Identifier: BSD-3-Clause
"""First steps of the command's process, and the libraries that it finds."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
import surefoot
from surefoot.system.command_process import is_command

SITE = Path(surefoot.__file__).parents[1]


@pytest.mark.parametrize(
    ("argv", "orig_argv", "expected"),
    [
        (["/bin/surefoot", "gains"], ["python", "/bin/surefoot", "gains"], True),
        (["-m", "gains"], ["python", "-m", "surefoot", "gains"], True),
        (["-m"], ["python", "-X", "dev", "-m", "surefoot.cli"], True),
        (["-m", "tests"], ["python", "-m", "pytest", "tests"], False),
        (["my_robot.py"], ["python", "my_robot.py"], False),
        ([""], ["python"], False),
        ([], [], False),
        (["/bin/surefoot"], ["python", "-c", "spawn", "--multiprocessing-fork"], False),
    ],
)
def test_only_the_command_itself_prepares_its_process(argv, orig_argv, expected) -> None:
    assert is_command(argv, orig_argv) is expected


def call(code: str, *words: str, **environment: str) -> subprocess.CompletedProcess[str]:
    line = [sys.executable, *(["-c", code] if code else []), *words]
    return subprocess.run(
        line, capture_output=True, text=True, timeout=60, env=os.environ | environment
    )


def write_package(folder: Path, name: str, text: str) -> str:
    (folder / name).mkdir(parents=True)
    (folder / name / "__init__.py").write_text(text)
    return str(folder)


def test_importing_the_package_keeps_the_handlers_of_a_program() -> None:
    code = "import signal, surefoot; print(signal.getsignal(signal.SIGINT).__name__)"
    assert call(code).stdout == "default_int_handler\n"


OTHERS = {
    "old numpy": ("numpy", "__version__ = '1.20.0'", "numpy: got version 1.20.0 from"),
    "numpy of another Python": ("numpy", "raise ImportError('no C API')", "numpy: cannot import"),
    "other Pinocchio": ("pinocchio", "__version__ = '2.6.21'", "pinocchio: got"),
}


@pytest.mark.parametrize(("name", "text", "message"), OTHERS.values(), ids=OTHERS)
def test_other_package_on_pythonpath_is_named_with_its_place(name, text, message, tmp_path) -> None:
    folder = write_package(tmp_path, name, text)
    done = call("", "-m", "surefoot", "gains", PYTHONPATH=folder)
    assert (done.returncode, done.stdout, done.stderr.count("\n")) == (1, "", 1)
    assert done.stderr.startswith(f"surefoot: error: {message}")
    assert f"{tmp_path}/{name}" in done.stderr
    assert f"remove '{folder}' from PYTHONPATH" in done.stderr
    program = call("import surefoot", PYTHONPATH=folder)
    assert f"ImportError: {message}" in program.stderr.splitlines()[-1]


@pytest.mark.skipif(sys.platform != "linux", reason="LD_LIBRARY_PATH is that of Linux")
@pytest.mark.parametrize("kind", ["empty", "another build"])
def test_other_library_on_the_library_path_is_named_with_its_place(kind, tmp_path) -> None:
    library = SITE / "cmeel.prefix" / "lib" / "libpinocchio_default.so"
    other = tmp_path / library.name
    other.write_bytes(b"" if kind == "empty" else library.read_bytes() + b"another build")
    done = call("", "-m", "surefoot", "gains", LD_LIBRARY_PATH=str(tmp_path))
    assert (done.returncode, done.stdout, done.stderr.count("\n")) == (1, "", 1)
    assert f"LD_LIBRARY_PATH loads '{other}', expected '{library}'" in done.stderr
    assert "run: unset LD_LIBRARY_PATH" in done.stderr


@pytest.mark.skipif(sys.platform != "linux", reason="LD_LIBRARY_PATH is that of Linux")
def test_same_library_at_another_place_is_accepted(tmp_path) -> None:
    library = SITE / "cmeel.prefix" / "lib" / "libpinocchio_default.so"
    (tmp_path / library.name).write_bytes(library.read_bytes())
    done = call("import surefoot; print('ok')", LD_LIBRARY_PATH=str(tmp_path))
    assert (done.stdout, done.stderr) == ("ok\n", "")


@pytest.mark.parametrize("name", ["gains", "robot"])
def test_toml_with_a_byte_order_mark_is_read(name, tmp_path) -> None:
    if name == "gains":
        path = tmp_path / "gains.toml"
        path.write_bytes(b"\xef\xbb\xbf[gains]\nfoot_kp = 90.0\n")
        assert surefoot.load_gains(path).foot_kp == 90.0
    else:
        source = Path(surefoot.__file__).parent / "models" / "go1.toml"
        path = tmp_path / "robot.toml"
        path.write_bytes(b"\xef\xbb\xbf" + source.read_bytes())
        urdf = surefoot.robot.description.describe_robot("go1").urdf
        assert surefoot.load_robot(urdf=urdf, config=path).name == "go1"

# SPDX-License-Identifier: BSD-3-Clause
"""Run the blocks of one page in a folder of their own."""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import sys
import time
import tomllib
from pathlib import Path
from types import TracebackType

import surefoot
from fenced_blocks import ROOT, Block

# [s] For one block. Chosen. If smaller: a slow machine fails. If larger: a hang costs time.
TIMEOUT = 300.0
# As pinocchio::pinocchio_default defines them.
BOOST_LIMITS = (
    "-DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS",
    "-DBOOST_MPL_LIMIT_LIST_SIZE=30",
    "-DBOOST_MPL_LIMIT_VECTOR_SIZE=30",
    "-DBOOST_FUSION_INVOKE_MAX_ARITY=12",
)
INTERPRETER = Path(__file__).with_name("block_interpreter.py")


class BlockError(Exception):
    """A block failed. The text is one line: where, what, and the last line of the output."""


def environment() -> dict[str, str]:
    """Return the environment of all blocks: this Python first on PATH, MuJoCo on EGL."""
    binaries = str(Path(sys.executable).parent)
    return {"MUJOCO_GL": "egl", **os.environ, "PATH": f"{binaries}:{os.environ['PATH']}"}


def _last_line(text: str) -> str:
    lines = [line for line in text.splitlines() if line.strip()]
    return lines[-1].strip() if lines else "no output"


class PageRunner:
    """Runs blocks in the order of the page. A context: leaving it stops what is still running.

    Args:
        folder: Empty; gets links to the entries of the repository, and the files of the page.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._background: list[subprocess.Popen[str]] = []
        self._python: subprocess.Popen[str] | None = None
        for entry in ROOT.iterdir():
            if not entry.name.startswith(".") and entry.name not in ("build", "out"):
                (folder / entry.name).symlink_to(entry)

    def __enter__(self) -> PageRunner:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        for process in [*self._background, *([self._python] if self._python else [])]:
            with contextlib.suppress(ProcessLookupError):  # it has ended by itself
                os.killpg(process.pid, signal.SIGKILL)
            process.wait()

    def run(self, block: Block) -> None:
        """Run a block.

        Raises:
            BlockError: It failed.
        """
        if block.options and not block.background:
            raise BlockError(f"{block.where}: unknown option {block.options!r} of the fence")
        if block.file_name:
            self._write(block)
        elif block.language == "cmake":
            raise BlockError(f"{block.where}: cmake needs a first line `# CMakeLists.txt`")
        {
            "sh": self._run_shell,
            "python": self._run_python,
            "cpp": self._compile,
            "toml": self._parse,
            "cmake": lambda _: None,  # the page's sh blocks run it
        }[block.language](block)

    def _write(self, block: Block) -> None:
        path = self._folder / block.file_name
        path.unlink(missing_ok=True)  # else a link would lead into the repository
        path.write_text(block.text, encoding="utf-8")

    def _run_shell(self, block: Block) -> None:
        command = ["bash", "-euo", "pipefail", "-c", block.text]
        if block.background:
            self._start(block, command)
            return
        self._check(block, command)

    def _start(self, block: Block, command: list[str]) -> None:
        log = self._folder / f"background-{len(self._background)}.log"
        with log.open("w") as output:
            process = subprocess.Popen(
                command,
                cwd=self._folder,
                env=environment(),
                stdout=output,
                stderr=subprocess.STDOUT,
                start_new_session=True,
                text=True,
            )
        self._background.append(process)
        end = time.monotonic() + TIMEOUT
        while block.background not in log.read_text(encoding="utf-8"):
            if process.poll() is not None or time.monotonic() > end:
                last = _last_line(log.read_text(encoding="utf-8"))
                raise BlockError(f"{block.where}: sh did not print {block.background!r}: {last}")
            time.sleep(0.05)

    def _check(self, block: Block, command: list[str]) -> None:
        with subprocess.Popen(
            command,
            cwd=self._folder,
            env=environment(),
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            start_new_session=True,
            text=True,
        ) as process:
            try:
                output, _ = process.communicate(timeout=TIMEOUT)
            except subprocess.TimeoutExpired:
                os.killpg(process.pid, signal.SIGKILL)
                raise BlockError(f"{block.where}: {block.language} ran {TIMEOUT:g} s") from None
        if process.returncode:
            status = f"{block.language} ended with status {process.returncode}"
            raise BlockError(f"{block.where}: {status}: {_last_line(output)}")

    def _run_python(self, block: Block) -> None:
        if self._python is None:
            self._python = subprocess.Popen(
                [sys.executable, str(INTERPRETER)],
                cwd=self._folder,
                env=environment(),
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                start_new_session=True,
                text=True,
            )
        assert self._python.stdin and self._python.stdout
        self._python.stdin.write(f"{block.text.count(chr(10))}\n{block.text}")
        self._python.stdin.flush()
        answer = self._python.stdout.readline().strip()
        if answer != "ok":
            raise BlockError(f"{block.where}: python: {answer or 'the interpreter died'}")

    def _compile(self, block: Block) -> None:
        source = self._folder / (block.file_name or "block.cpp")
        source.write_text(block.text, encoding="utf-8")
        package = Path(surefoot.__file__).parent
        includes = [package / "include", *sorted(package.parent.glob("cmeel.prefix/include"))]
        eigen = [folder / "eigen3" for folder in includes]
        flags = [f"-I{folder}" for folder in [*includes, *eigen]]
        self._check(
            block, ["g++", "-std=c++17", "-fsyntax-only", *BOOST_LIMITS, *flags, source.name]
        )

    def _parse(self, block: Block) -> None:
        try:
            tomllib.loads(block.text)
        except tomllib.TOMLDecodeError as error:
            raise BlockError(f"{block.where}: toml: {error}") from None

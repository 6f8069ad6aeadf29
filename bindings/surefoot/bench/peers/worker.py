"""Implementation in a separate process: a peer's Python environment or a C++ executable."""

from __future__ import annotations

import contextlib
import json
import select
import signal
import subprocess
import tempfile
import time
from collections.abc import Callable
from typing import Any

import numpy as np

from surefoot.bench.peers.environment import clean_environment
from surefoot.bench.peers.options import PeerError
from surefoot.bench.peers.surefoot_implementations import Ticks


class Worker:
    """Client of a worker process, through pipes; workers/worker_loop.py defines the protocol.

    Attributes:
        versions: Versions of the packages that the worker uses.
    """

    def __init__(self, command_line: list[str], width: int, timeout: float) -> None:
        """Start the worker and wait until it is ready.

        Args:
            command_line: Command of the worker.
            width: Number of values per tick.
            timeout: Longest time to wait for an answer [s].

        Raises:
            PeerError: The worker could not start, ended early, or did not answer in time.
        """
        self._width, self._timeout = width, timeout
        self._errors = tempfile.TemporaryFile()
        try:
            self._process = subprocess.Popen(
                command_line,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=self._errors,
                bufsize=0,
                env={**clean_environment(), "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"},
            )
        except OSError as problem:
            self._errors.close()
            raise PeerError(f"could not be started: {problem}") from None
        self._buffer = b""
        try:
            self.versions = self._read_versions()
        except PeerError:
            self.close()
            raise

    def run_ticks(self, first: int, count: int) -> Ticks:
        """Let the worker compute ticks; return them, shape (count, width).

        Raises:
            PeerError: The worker ended, or did not answer in time.
        """
        assert self._process.stdin is not None
        try:
            self._process.stdin.write(f"play {first} {count}\n".encode())
        except OSError:
            raise PeerError(self._exit_description()) from None
        size = 8 * self._width * count
        deadline = time.monotonic() + self._timeout
        while len(self._buffer) < size:
            self._read(deadline)
        ticks = np.frombuffer(self._buffer[:size], dtype="<f8").reshape(count, self._width)
        self._buffer = self._buffer[size:]
        if not np.isfinite(ticks).all():
            raise PeerError(
                f"answered with a value that is not finite in a block from tick {first}"
            )
        return ticks

    def close(self) -> None:
        """End the worker process."""
        for pipe in (self._process.stdin, self._process.stdout):
            if pipe is not None:
                with contextlib.suppress(OSError):
                    pipe.close()
        try:
            self._process.wait(timeout=2.0)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        self._errors.close()

    def _read_versions(self) -> dict[str, Any]:
        deadline = time.monotonic() + self._timeout
        while b"\n" not in self._buffer:
            self._read(deadline)
        line, _, self._buffer = self._buffer.partition(b"\n")
        try:
            versions = json.loads(line)["versions"]
        except (ValueError, KeyError, TypeError):
            raise PeerError(
                f"first line: got {line[:80]!r}, expected its versions as JSON"
            ) from None
        return dict(versions)

    def _read(self, deadline: float) -> None:
        assert self._process.stdout is not None
        remaining = deadline - time.monotonic()
        if remaining <= 0.0 or not select.select([self._process.stdout], [], [], remaining)[0]:
            self._process.kill()
            raise PeerError(f"no answer within {self._timeout:g} s")
        chunk = self._process.stdout.read(1 << 16)
        if not chunk:
            raise PeerError(self._exit_description())
        self._buffer += chunk

    def _exit_description(self) -> str:
        """Return how the worker ended, and its last line of error output."""
        try:
            status = self._process.wait(timeout=2.0)
        except subprocess.TimeoutExpired:
            return "closed its output"
        how = f"signal {signal.Signals(-status).name}" if status < 0 else f"status {status}"
        self._errors.seek(0)
        error_lines = self._errors.read().decode(errors="replace").strip().splitlines()
        return f"ended with {how}" + (f": {error_lines[-1].strip()}" if error_lines else "")


def worker_factory(
    command: Callable[[], list[str]], width: int, timeout: float
) -> Callable[[], Worker]:
    """Return a factory of a worker.

    `command` returns the command line of the worker, and may compile the worker first, which takes
    minutes. So `command` is called at once and not by the factory. If `command` fails, the factory
    raises PeerError with the reason.
    """
    try:
        command_line = command()
    except (PeerError, OSError) as problem:
        reason = str(problem)

        def raise_error() -> Worker:
            raise PeerError(reason)

        return raise_error
    return lambda: Worker(command_line, width, timeout)

"""Worker processes: new interpreters that use one numerical thread and end with their parent."""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
from collections.abc import Iterator
from concurrent.futures.process import ProcessPoolExecutor
from contextlib import contextmanager
from multiprocessing.context import SpawnContext, SpawnProcess

_THREAD_COUNT_VARIABLES = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")


class _QuietProcess(SpawnProcess):
    """Process that ignores Ctrl-C from its first instruction on: its parent ends it."""

    def start(self) -> None:
        """Start the process; it inherits the signal mask."""
        mask = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
        try:
            super().start()
        finally:
            signal.pthread_sigmask(signal.SIG_SETMASK, mask)


class _QuietContext(SpawnContext):
    Process = _QuietProcess


def spawn_context() -> SpawnContext:
    """Return the multiprocessing context that spawns new interpreters, which ignore Ctrl-C.

    A fork would copy the locks of MuJoCo and Optuna but not their threads. The function also sets
    environment variables that limit each worker to one numerical thread, so that the workers do
    not compete for the cores. A worker's numpy reads these variables on import.
    """
    for name in _THREAD_COUNT_VARIABLES:
        os.environ.setdefault(name, "1")
    # After killed_on_error() Python's resource tracker would warn of semaphores that it cleans up.
    os.environ.setdefault("PYTHONWARNINGS", "ignore:resource_tracker")
    return _QuietContext()


def spawn_pool(jobs: int) -> ProcessPoolExecutor:
    """Return a pool of `jobs` spawned processes; submitted functions must be picklable."""
    return ProcessPoolExecutor(jobs, spawn_context(), die_with_parent)


@contextmanager
def killable_pool(jobs: int) -> Iterator[ProcessPoolExecutor]:
    """Yield a spawn_pool(); kill its processes on Ctrl-C or any other exception."""
    with killed_on_error():
        pool = spawn_pool(jobs)
        try:
            yield pool
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            raise
        pool.shutdown(cancel_futures=True)


@contextmanager
def killed_on_error() -> Iterator[None]:
    """On Ctrl-C or any other exception, kill the processes that were started in this context."""
    existing = set(multiprocessing.active_children())
    try:
        yield
    except BaseException:
        for process in set(multiprocessing.active_children()) - existing:
            process.kill()
        raise


def die_with_parent() -> None:
    """End this process when its parent ends, even if the parent is killed."""
    parent = multiprocessing.parent_process()
    assert parent is not None

    def exit_after_parent() -> None:
        parent.join()
        os._exit(1)

    threading.Thread(target=exit_after_parent, daemon=True).start()

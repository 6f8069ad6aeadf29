"""Worker processes: new interpreters that use one numerical thread and end with their parent."""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
from collections.abc import Iterator
from concurrent.futures.process import ProcessPoolExecutor
from contextlib import contextmanager
from multiprocessing.context import SpawnContext

_THREAD_COUNT_VARIABLES = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")


def spawn_context() -> SpawnContext:
    """Return the multiprocessing context that spawns new interpreters.

    A fork would copy the locks of MuJoCo and Optuna but not their threads. The function also sets
    environment variables that limit each worker to one numerical thread, so that the workers do
    not compete for the cores. A worker's numpy reads these variables on import.
    """
    for name in _THREAD_COUNT_VARIABLES:
        os.environ.setdefault(name, "1")
    return multiprocessing.get_context("spawn")


def spawn_pool(jobs: int) -> ProcessPoolExecutor:
    """Return a pool of `jobs` spawned processes; submitted functions must be picklable."""
    return ProcessPoolExecutor(jobs, spawn_context(), die_with_parent)


@contextmanager
def killable_pool(jobs: int) -> Iterator[ProcessPoolExecutor]:
    """Yield a spawn_pool(); kill its processes on Ctrl-C or any other exception."""
    existing = set(multiprocessing.active_children())
    pool = spawn_pool(jobs)
    try:
        yield pool
    except BaseException:
        for process in set(multiprocessing.active_children()) - existing:
            process.kill()
        raise
    finally:
        pool.shutdown(cancel_futures=True)


def die_with_parent() -> None:
    """End this process when its parent ends, even if the parent is killed; ignore Ctrl-C."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = multiprocessing.parent_process()
    assert parent is not None

    def exit_after_parent() -> None:
        parent.join()
        os._exit(1)

    threading.Thread(target=exit_after_parent, daemon=True).start()

"""Worker processes: new interpreters with one thread each, which end with their parent."""

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

    A fork would copy the locks, but not the threads, of MuJoCo and Optuna. Also limits the workers
    to one numerical thread each, by environment variables: workers with more threads would compete
    for the cores. The variables are set here because numpy reads them on import.
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

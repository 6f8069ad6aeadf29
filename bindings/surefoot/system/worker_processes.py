"""Processes that help: fresh interpreters of one thread each that end with the one they help."""

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
    """Return what starts fresh interpreters: a fork would copy MuJoCo's and Optuna's threads half.

    They compute with one thread each, for two that share a core do less than one; numpy reads that
    when it is loaded, which is before any code of ours in a fresh interpreter.
    """
    for name in _THREAD_COUNT_VARIABLES:
        os.environ.setdefault(name, "1")
    return multiprocessing.get_context("spawn")


def spawn_pool(jobs: int) -> ProcessPoolExecutor:
    """Return a pool of `jobs` such processes; jobs are whatever can be pickled."""
    return ProcessPoolExecutor(jobs, spawn_context(), die_with_parent)


@contextmanager
def killable_pool(jobs: int) -> Iterator[ProcessPoolExecutor]:
    """A pool that does not outlive what is done with it: on Ctrl-C or an error it ends at once."""
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
    """Have this process end where the one that started it is killed, and not by Ctrl-C before."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = multiprocessing.parent_process()
    assert parent is not None

    def exit_after_parent() -> None:
        parent.join()
        os._exit(1)

    threading.Thread(target=exit_after_parent, daemon=True).start()

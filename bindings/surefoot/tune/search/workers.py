"""Who runs the trials: processes of this machine, or a Dask cluster; both as futures.

A worker that dies takes nothing with it but the trial it was at, which is run again.
"""

from __future__ import annotations

import multiprocessing
import os
from collections.abc import Iterator
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Executor, Future, wait
from concurrent.futures.process import ProcessPoolExecutor
from contextlib import contextmanager
from typing import Any, Protocol

from surefoot._core import Error
from surefoot.tune.search.rollout import BROKEN, Job, Outcome, judged

ATTEMPTS = 3  # a trial that has killed as many workers is a failure
CLUSTER_TIMEOUT = 10.0  # [s]


class Workers(Protocol):
    """Runs jobs; submit() never blocks."""

    count: int

    def submit(self, job: Job) -> Future[Outcome]:
        """Hand a job to whoever is free."""

    def renew(self) -> None:
        """Replace what is broken; jobs under way are lost."""


class Processes:
    """Workers of this machine.

    Args:
        jobs: How many.
    """

    def __init__(self, jobs: int) -> None:
        self.count = jobs
        self._pool: Executor | None = None
        self.renew()

    def submit(self, job: Job) -> Future[Outcome]:
        """Hand a job to a process."""
        assert self._pool is not None
        return self._pool.submit(judged, job)

    def renew(self) -> None:
        """Start fresh processes in place of the broken pool's."""
        if self._pool is not None:
            self._pool.shutdown(wait=False, cancel_futures=True)
        # Fresh interpreters: a fork would copy MuJoCo's and Optuna's threads half.
        context = multiprocessing.get_context("spawn")
        self._pool = ProcessPoolExecutor(self.count, context, _alone)

    def close(self) -> None:
        """Let the processes go."""
        assert self._pool is not None
        self._pool.shutdown(wait=False, cancel_futures=True)


class Cluster:
    """Workers of a Dask cluster: surefoot and its extras must be installed on each.

    Args:
        address: Of the scheduler, tcp://HOST:PORT.

    Raises:
        Error: No distributed package, no scheduler there, or none of its workers.
    """

    def __init__(self, address: str) -> None:
        try:
            import distributed  # untyped
        except ImportError:
            raise Error("cluster: pip install 'surefoot[cluster]' first") from None
        try:
            connect: Any = distributed.Client
            self._client: Any = connect(address, timeout=CLUSTER_TIMEOUT)
        except (OSError, ValueError) as problem:
            raise Error(f"cluster '{address}': no scheduler there ({problem})") from None
        # A worker runs one trial at a time, whatever its threads: see rollout.judged().
        self.count = len(self._client.nthreads())
        if self.count == 0:
            self.close()
            raise Error(f"cluster '{address}': got a scheduler without workers, expected some")
        self._executor: Executor = self._client.get_executor(retries=ATTEMPTS, pure=False)

    def submit(self, job: Job) -> Future[Outcome]:
        """Hand a job to the scheduler, which runs it again where a worker dies."""
        return self._executor.submit(judged, job)

    def renew(self) -> None:
        """Nothing: the scheduler replaces workers itself."""

    def close(self) -> None:
        """Leave the cluster as it is."""
        self._client.close()


@contextmanager
def workers(jobs: int, cluster: str | None) -> Iterator[Processes | Cluster]:
    """Open the workers for a search; raises Error."""
    crew = Cluster(cluster) if cluster else Processes(jobs)
    try:
        yield crew
    finally:
        crew.close()


class Queue:
    """Jobs under way, and what came of them.

    Args:
        crew: Who runs them.
    """

    def __init__(self, crew: Workers) -> None:
        self._crew = crew
        self._pending: dict[Future[Outcome], tuple[int, Job, int]] = {}

    def __len__(self) -> int:
        """Jobs under way."""
        return len(self._pending)

    def put(self, number: int, job: Job, attempt: int = 1) -> None:
        """Hand a trial's job over."""
        self._pending[self._crew.submit(job)] = (number, job, attempt)

    def take(self) -> list[tuple[int, Outcome]]:
        """Wait until at least one trial is done, and return those that are."""
        done: list[tuple[int, Outcome]] = []
        while not done:
            wait(self._pending, return_when=FIRST_COMPLETED)
            finished = [future for future in self._pending if future.done()]
            lost = []
            for future in finished:
                number, job, attempt = self._pending.pop(future)
                try:
                    done.append((number, future.result()))
                except Exception as problem:  # of the worker, not of the gains: see judged()
                    lost.append((number, job, attempt, problem))
            if lost:
                done += self._again(lost)
        return done

    def _again(self, lost: list[Any]) -> list[tuple[int, Outcome]]:
        """Run trials again whose worker died; give up those that kill every worker."""
        if any(isinstance(problem, BrokenExecutor) for *_, problem in lost):
            # The pool is gone, and with it everything that was under way.
            lost += [(*what, BrokenExecutor()) for what in self._pending.values()]
            self._pending.clear()
            self._crew.renew()
        given_up = []
        for number, job, attempt, _ in lost:
            if attempt < ATTEMPTS:
                self.put(number, job, attempt + 1)
            else:
                given_up.append((number, Outcome(costs=(BROKEN,) * len(job.objectives))))
        return given_up


def _alone() -> None:
    # One thread each: two that share a core do less than one.
    for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
        os.environ.setdefault(name, "1")

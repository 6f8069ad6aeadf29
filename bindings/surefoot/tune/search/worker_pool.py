"""Who runs the trials: processes of this machine, or a Dask cluster; both as futures."""

from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import BrokenExecutor, Future
from contextlib import contextmanager
from typing import Any, Protocol

from surefoot._core import Error
from surefoot.system.worker_processes import spawn_pool
from surefoot.tune.search.rollout import Outcome, TrialJob, evaluate_exclusively

CLUSTER_TIMEOUT = 10.0  # [s]


class WorkerPool(Protocol):
    """Runs jobs; submit() never blocks.

    Attributes:
        count: Jobs that run at the same time.
        worker_death_errors: Exceptions by which a job's future says that its worker has died.
    """

    count: int
    worker_death_errors: tuple[type[BaseException], ...]

    def submit(self, job: TrialJob) -> Future[Outcome]:
        """Hand a job to whoever is free."""

    def restart_workers(self) -> None:
        """Replace workers that have died; jobs under way are lost."""

    def check(self) -> None:
        """Raise Error if nobody will ever answer, one of deaths if jobs under way are lost."""


class ProcessPool:
    """Workers of this machine.

    Args:
        jobs: How many.
    """

    worker_death_errors: tuple[type[BaseException], ...] = (BrokenExecutor,)

    def __init__(self, jobs: int) -> None:
        self.count = jobs
        self._pool = spawn_pool(jobs)

    def submit(self, job: TrialJob) -> Future[Outcome]:
        """Hand a job to a process."""
        return self._pool.submit(evaluate_exclusively, job)

    def restart_workers(self) -> None:
        """Start fresh processes in place of the broken pool's."""
        self._pool.shutdown(wait=False, cancel_futures=True)
        self._pool = spawn_pool(self.count)

    def check(self) -> None:
        """Raise BrokenExecutor if a worker has died.

        A job that is handed over just while a pool breaks may never be answered.
        """
        self._pool.submit(int)

    def close(self) -> None:
        """Let the processes go, each after the trial it is at."""
        self._pool.shutdown(wait=True, cancel_futures=True)


class DaskCluster:
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
        self._address = address
        try:
            connect: Any = distributed.Client
            self._client: Any = connect(address, timeout=CLUSTER_TIMEOUT)
        except (OSError, ValueError, TypeError) as problem:
            raise Error(f"cluster '{address}': no scheduler there ({problem})") from None
        # A worker runs one trial at a time, whatever its threads: see rollout.judged().
        self.count = len(self._client.nthreads())
        if self.count == 0:
            self.close()
            raise Error(f"cluster '{address}': got a scheduler without workers, expected some")
        # The scheduler itself runs a job elsewhere where a worker dies, a few times.
        self.worker_death_errors: tuple[type[BaseException], ...] = (distributed.KilledWorker,)
        self._executor: Any = self._client.get_executor(pure=False)

    def submit(self, job: TrialJob) -> Future[Outcome]:
        """Hand a job to the scheduler."""
        future: Future[Outcome] = self._executor.submit(evaluate_exclusively, job)
        return future

    def restart_workers(self) -> None:
        """Nothing: the scheduler replaces workers itself."""

    def check(self) -> None:
        """Raise Error if the scheduler is gone."""
        if self._client.status != "running":
            raise Error(
                f"cluster '{self._address}': the scheduler is gone; trials that are done are safe "
                "where there is a store"
            )

    def close(self) -> None:
        """Leave the cluster as it is."""
        self._client.close(timeout=CLUSTER_TIMEOUT)


@contextmanager
def open_worker_pool(jobs: int, cluster: str | None) -> Iterator[ProcessPool | DaskCluster]:
    """Open the workers for a search; raises Error."""
    worker_pool = ProcessPool(jobs) if cluster is None else DaskCluster(cluster)
    try:
        yield worker_pool
    finally:
        worker_pool.close()

"""Workers that run the trials: processes on this machine, or a Dask cluster."""

from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import BrokenExecutor, Future
from contextlib import contextmanager
from typing import Any, Protocol

from surefoot._core import Error
from surefoot.system.worker_processes import killed_on_error, spawn_pool
from surefoot.tune.search.rollout import Outcome, TrialJob, evaluate_exclusively

# [s] Longest time to connect to the scheduler, and to disconnect. Chosen: longer than a slow
# network needs. With a larger value, a wrong address blocks the command for longer.
CLUSTER_TIMEOUT = 10.0


class WorkerPool(Protocol):
    """Interface of a pool of workers.

    Attributes:
        count: Number of jobs that run at the same time.
        worker_death_errors: Exceptions that a job's future raises if its worker has died.
    """

    count: int
    worker_death_errors: tuple[type[BaseException], ...]

    def submit(self, job: TrialJob) -> Future[Outcome]:
        """Submit a job to a free worker, without blocking."""

    def restart_workers(self) -> None:
        """Replace dead workers; running jobs are lost."""

    def check(self) -> None:
        """Check the workers.

        Raises:
            Error: No worker is left.
            One of worker_death_errors: The running jobs are lost.
        """


class ProcessPool:
    """Pool of processes on this machine.

    Args:
        jobs: Number of processes.
    """

    worker_death_errors: tuple[type[BaseException], ...] = (BrokenExecutor,)

    def __init__(self, jobs: int) -> None:
        self.count = jobs
        self._pool = spawn_pool(jobs)

    def submit(self, job: TrialJob) -> Future[Outcome]:
        """Submit a job to a process."""
        return self._pool.submit(evaluate_exclusively, job)

    def restart_workers(self) -> None:
        """Replace the broken pool by a new one."""
        self._pool.shutdown(wait=False, cancel_futures=True)
        self._pool = spawn_pool(self.count)

    def check(self) -> None:
        """Raise BrokenExecutor if a worker has died.

        A job that is submitted while the pool breaks may never finish. So this method probes the
        pool with a job of its own.
        """
        self._pool.submit(int)

    def close(self, wait: bool = True) -> None:
        """End the processes: after their running trials, or without waiting for them."""
        self._pool.shutdown(wait, cancel_futures=True)


class DaskCluster:
    """Workers of a Dask cluster; surefoot and its extras must be installed on each.

    Args:
        address: Address of the scheduler, tcp://HOST:PORT.

    Raises:
        Error: The package distributed is missing, no scheduler answers, or it has no workers.
    """

    def __init__(self, address: str) -> None:
        try:
            import distributed  # untyped
        except ImportError:
            raise Error(
                "cluster: package 'distributed' not found; run: pip install 'surefoot[cluster]'"
            ) from None
        self._address = address
        try:
            connect: Any = distributed.Client
            self._client: Any = connect(address, timeout=CLUSTER_TIMEOUT)
        except (OSError, ValueError, TypeError) as problem:
            raise Error(f"cluster '{address}': no scheduler answers ({problem})") from None
        # A worker with several threads still runs one trial at a time: see evaluate_exclusively().
        self.count = len(self._client.nthreads())
        if self.count == 0:
            self.close()
            raise Error(f"cluster '{address}': got a scheduler without workers, expected some")
        # The scheduler raises this error only after several workers died with the same job.
        self.worker_death_errors: tuple[type[BaseException], ...] = (distributed.KilledWorker,)
        self._executor: Any = self._client.get_executor(pure=False)

    def submit(self, job: TrialJob) -> Future[Outcome]:
        """Submit a job to the scheduler."""
        future: Future[Outcome] = self._executor.submit(evaluate_exclusively, job)
        return future

    def restart_workers(self) -> None:
        """Do nothing: the scheduler replaces dead workers."""

    def check(self) -> None:
        """Raise Error if the connection to the scheduler is lost."""
        if self._client.status != "running":
            raise Error(
                f"cluster '{self._address}': connection to the scheduler lost; "
                "start the search again, with the same --store to keep the finished trials"
            )

    def close(self, wait: bool = True) -> None:
        """Disconnect from the cluster, at once or in time for it; its workers keep running."""
        self._client.close(timeout=CLUSTER_TIMEOUT if wait else 1.0)


@contextmanager
def open_worker_pool(jobs: int, cluster: str | None) -> Iterator[ProcessPool | DaskCluster]:
    """Yield a pool of `jobs` processes, or the DaskCluster at `cluster`; close it at the end.

    On Ctrl-C or any other exception, the processes are killed.

    Raises:
        Error: No scheduler answers, or the cluster has no workers.
    """
    with killed_on_error():
        worker_pool = ProcessPool(jobs) if cluster is None else DaskCluster(cluster)
        try:
            yield worker_pool
        except BaseException:
            worker_pool.close(wait=False)
            raise
        worker_pool.close()

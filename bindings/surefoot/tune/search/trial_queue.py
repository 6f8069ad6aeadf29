"""Queue of running trials, which runs the jobs of dead workers again."""

from __future__ import annotations

from concurrent.futures import FIRST_COMPLETED, CancelledError, Future, wait

from surefoot._core import Error
from surefoot.tune.search.rollout import Outcome, TrialJob, broken
from surefoot.tune.search.worker_pool import WorkerPool

# Number of times that a suspected job runs alone before its trial counts as broken. Chosen: gains
# that kill a worker do so every time, but a worker may also die for another reason.
MAX_ATTEMPTS = 3
# [s] Time between two checks whether workers exist. Chosen: shorter than the time to start a
# worker. More frequent checks would load an idle scheduler.
POLL_PERIOD = 2.0


class TrialQueue:
    """Queue of running jobs.

    When a worker dies, all running jobs of its pool are lost. The queue runs these jobs again one
    at a time, to find the job that kills its worker.

    Args:
        worker_pool: Workers that run the jobs.
    """

    def __init__(self, worker_pool: WorkerPool) -> None:
        self._worker_pool = worker_pool
        self._pending: dict[Future[Outcome], tuple[int, TrialJob]] = {}

    def __len__(self) -> int:
        """Return the number of running jobs."""
        return len(self._pending)

    def put(self, number: int, job: TrialJob) -> None:
        """Submit the job of a trial."""
        try:
            future = self._worker_pool.submit(job)
        except self._worker_pool.worker_death_errors:
            # A worker died after the last check. The futures of all running jobs raise errors too.
            self._worker_pool.restart_workers()
            future = self._worker_pool.submit(job)
        self._pending[future] = number, job

    def take(self) -> list[tuple[int, Outcome]]:
        """Wait until at least one trial is done; return (number, outcome) of all finished trials.

        Raises:
            Error: No worker is left, or a worker cannot run a job.
        """
        done: list[tuple[int, Outcome]] = []
        while not done:
            finished, _ = wait(self._pending, timeout=POLL_PERIOD, return_when=FIRST_COMPLETED)
            if not finished and self._jobs_are_lost():
                done += self._rerun_one_by_one([])
                continue
            suspects = []
            for future in finished:
                number, job = self._pending.pop(future)
                outcome = self._result(future)
                if outcome is None:
                    suspects.append((number, job))
                else:
                    done.append((number, outcome))
            if suspects:
                done += self._rerun_one_by_one(suspects)
        return done

    def _jobs_are_lost(self) -> bool:
        """Return whether the running jobs are lost; raise Error if no worker is left."""
        try:
            self._worker_pool.check()
        except self._worker_pool.worker_death_errors:
            return True
        return False

    def _result(self, future: Future[Outcome]) -> Outcome | None:
        """Return the outcome of a finished job; None if its worker died."""
        try:
            return future.result()
        except self._worker_pool.worker_death_errors:
            return None
        except CancelledError:
            return None
        except Error:
            raise
        except Exception as problem:
            kind = type(problem).__name__
            raise Error(f"a worker cannot run trials: {kind}: {problem}") from problem

    def _rerun_one_by_one(self, suspects: list[tuple[int, TrialJob]]) -> list[tuple[int, Outcome]]:
        # All running jobs of a broken pool are lost.
        suspects += self._pending.values()
        self._pending.clear()
        self._worker_pool.restart_workers()
        return [(number, self._run_alone(job)) for number, job in suspects]

    def _run_alone(self, job: TrialJob) -> Outcome:
        for _ in range(MAX_ATTEMPTS):
            future = self._worker_pool.submit(job)
            lost = False
            while not lost and not wait([future], timeout=POLL_PERIOD).done:
                lost = self._jobs_are_lost()
            outcome = None if lost else self._result(future)
            if outcome is not None:
                return outcome
            self._worker_pool.restart_workers()
        return broken(job)

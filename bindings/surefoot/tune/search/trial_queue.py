"""Trials under way: what came of them, and what becomes of those whose worker died."""

from __future__ import annotations

from concurrent.futures import FIRST_COMPLETED, CancelledError, Future, wait

from surefoot._core import Error
from surefoot.tune.search.rollout import Outcome, TrialJob, broken
from surefoot.tune.search.worker_pool import WorkerPool

MAX_ATTEMPTS = 3  # a trial that has killed as many workers, alone, is broken
POLL_PERIOD = 2.0  # [s] between looks whether anybody is there at all


class TrialQueue:
    """Jobs under way.

    A worker that dies takes with it what its pool was at, and nothing else: those jobs are run
    again, one at a time, so that one that kills every worker is known for what it is.

    Args:
        worker_pool: Who runs them.
    """

    def __init__(self, worker_pool: WorkerPool) -> None:
        self._crew = worker_pool
        self._pending: dict[Future[Outcome], tuple[int, TrialJob]] = {}

    def __len__(self) -> int:
        """Jobs under way."""
        return len(self._pending)

    def put(self, number: int, job: TrialJob) -> None:
        """Hand a trial's job over."""
        try:
            future = self._crew.submit(job)
        except (
            self._crew.worker_death_errors
        ):  # since the last look; what was under way will say so, too
            self._crew.restart_workers()
            future = self._crew.submit(job)
        self._pending[future] = number, job

    def take(self) -> list[tuple[int, Outcome]]:
        """Wait until at least one trial is done, and return those that are.

        Raises:
            Error: Nobody is left to answer, or a worker cannot run what it is given.
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
        """Whether jobs under way will never be answered; raises Error if nobody will be."""
        try:
            self._crew.check()
        except self._crew.worker_death_errors:
            return True
        return False

    def _result(self, future: Future[Outcome]) -> Outcome | None:
        """Return what a job came to, or None if its worker died."""
        try:
            return future.result()
        except self._crew.worker_death_errors:
            return None
        except CancelledError:
            return None
        except Error:
            raise
        except Exception as problem:
            kind = type(problem).__name__
            raise Error(f"a worker cannot run trials: {kind}: {problem}") from problem

    def _rerun_one_by_one(self, suspects: list[tuple[int, TrialJob]]) -> list[tuple[int, Outcome]]:
        # A pool that has broken fails everything that was under way in it.
        suspects += self._pending.values()
        self._pending.clear()
        self._crew.restart_workers()
        return [(number, self._run_alone(job)) for number, job in suspects]

    def _run_alone(self, job: TrialJob) -> Outcome:
        for _ in range(MAX_ATTEMPTS):
            future = self._crew.submit(job)
            lost = False
            while not lost and not wait([future], timeout=POLL_PERIOD).done:
                lost = self._jobs_are_lost()
            outcome = None if lost else self._result(future)
            if outcome is not None:
                return outcome
            self._crew.restart_workers()
        return broken(job)

"""surefoot run --yes: a rise that nobody asks for with a key."""

from __future__ import annotations

from surefoot._core import Mode, RequestStatus, RunSnapshot, StandRunner


class AutomaticRise:
    """Arms and rises once, as soon as all checks pass, and ends a run that does not come to stand.

    Nothing is armed again after a latch.

    Args:
        runner: Is asked.
    """

    def __init__(self, runner: StandRunner) -> None:
        self._runner = runner
        self._rise_requested = self._rising = False

    def update(self, snapshot: RunSnapshot) -> None:
        """Ask for what is next."""
        self._rising |= snapshot.mode == Mode.RISE
        if snapshot.mode != Mode.PASSIVE:
            return
        if self._rising and not snapshot.stood:
            self._runner.finish()
        elif not self._rise_requested and snapshot.arming.ready:
            self._request_next(snapshot)

    def _request_next(self, snapshot: RunSnapshot) -> None:
        if not snapshot.armed:
            self._runner.arm()
        else:
            self._rise_requested = self._runner.request(Mode.RISE) == RequestStatus.ACCEPTED

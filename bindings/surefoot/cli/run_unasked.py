"""surefoot run --yes: a rise that nobody asks for with a key."""

from __future__ import annotations

from surefoot._core import Mode, RequestStatus, RunSnapshot, StandRunner


class UnaskedRise:
    """Arms and rises once, as soon as all checks pass, and ends a run that does not come to stand.

    Nothing is armed again after a latch.

    Args:
        runner: Is asked.
    """

    def __init__(self, runner: StandRunner) -> None:
        self._runner = runner
        self._asked = self._rising = False

    def look(self, now: RunSnapshot) -> None:
        """Ask for what is next."""
        self._rising |= now.mode == Mode.RISE
        if now.mode != Mode.PASSIVE:
            return
        if self._rising and not now.stood:
            self._runner.finish()
        elif not self._asked and now.arming.ready:
            self._ask(now)

    def _ask(self, now: RunSnapshot) -> None:
        if not now.armed:
            self._runner.arm()
        else:
            self._asked = self._runner.request(Mode.RISE) == RequestStatus.ACCEPTED

"""surefoot run --yes: arms and rises without a key press."""

from __future__ import annotations

from surefoot._core import Mode, RequestStatus, Runner, RunSnapshot


class AutomaticRise:
    """Automatic operator: arms and rises once, as soon as all arming checks pass.

    If the rise fails, the operator ends the run. After latched damping the robot is not armed
    again.

    Args:
        runner: The runner that receives the requests.
    """

    def __init__(self, runner: Runner) -> None:
        self._runner = runner
        self._rise_requested = self._rising = False

    def update(self, snapshot: RunSnapshot) -> None:
        """Send the next request, if one is due."""
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

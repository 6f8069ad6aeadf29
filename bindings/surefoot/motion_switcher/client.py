"""Client of the motion switcher: ends the sport service before a program commands the motors."""

from __future__ import annotations

import json
import time
from collections.abc import Callable

from surefoot._core import DdsNetwork, DdsServiceClient, Error
from surefoot.motion_switcher.api import SERVICE, Api, Code

# [s] Longest wait for a server and for its reply. Chosen: longer than DDS needs to discover a robot
# on a network.
REPLY_TIMEOUT = 3.0
# [s] Wait after a release. The vendor's Python example waits for the same time.
RELEASE_WAIT = 1.0
_MAX_RELEASES = 10  # chosen: a switcher that is busy for longer has a problem of its own


class MotionSwitcher:
    """Client of the motion switcher of a robot.

    Args:
        network: Network and domain of the robot.
    """

    def __init__(self, network: DdsNetwork) -> None:
        self._client = DdsServiceClient(network, SERVICE)

    def is_present(self, timeout: float = REPLY_TIMEOUT) -> bool:
        """Return whether a motion switcher is discovered within a timeout [s]."""
        return self._client.wait_for_server(timeout)

    def check_mode(self) -> str:
        """Return the name of the active mode; "" if none is active.

        Raises:
            Error: No switcher answers, or its answer is not understood.
        """
        data = self._call(Api.CHECK_MODE, {})
        try:
            return str(json.loads(data)["name"])
        except (ValueError, KeyError, TypeError):
            raise Error(
                f'motion switcher: got the answer {data!r}, expected JSON with "name"'
            ) from None

    def select_mode(self, name: str) -> None:
        """Activate a mode, such as "normal"; raise Error if the switcher refuses it."""
        self._call(Api.SELECT_MODE, {"name": name})

    def release(self, on_message: Callable[[str], None], wait: float = RELEASE_WAIT) -> str:
        """End the active mode; return its name, "" if none was active.

        Args:
            on_message: Function that receives each step as text.
            wait: Time between a release and the next check [s].

        Raises:
            Error: No switcher answers, or a mode is still active after ten releases.
        """
        first = name = self.check_mode()
        for _ in range(_MAX_RELEASES):
            if not name:
                return first
            on_message(f"motion switcher: mode '{name}' is active, releasing it")
            self._call(Api.RELEASE_MODE, {}, allowed=(Code.OK, Code.BUSY))
            time.sleep(wait)
            name = self.check_mode()
        raise Error(
            f"motion switcher: got mode '{name}' after {_MAX_RELEASES} releases, expected none; "
            "end the mode with the vendor's app"
        )

    def _call(
        self, api: Api, parameter: dict[str, str], allowed: tuple[int, ...] = (Code.OK,)
    ) -> str:
        code, data = self._client.call(api, json.dumps(parameter), REPLY_TIMEOUT)
        if code in allowed:
            return data
        raise Error(f"motion switcher: {api.name}: got code {code} ({_meaning(code)}), expected 0")


def _meaning(code: int) -> str:
    return Code(code).name if code in set(Code) else "a code of the switcher"

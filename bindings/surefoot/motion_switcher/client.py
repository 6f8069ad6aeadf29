"""Client of the motion switcher: ends the sport service before a program commands the motors."""

from __future__ import annotations

import json
import time
from collections.abc import Callable

from surefoot._core import DdsNetwork, DdsServiceClient, Error
from surefoot.motion_switcher.api import SERVICE, Api, Code

# [s] Longest wait for a server and for its reply. The vendor's examples wait for the same time.
REPLY_TIMEOUT = 5.0
# [s] Wait between a request and the next check. The vendor's Python example waits for the same
# time.
CHECK_PERIOD = 1.0
# [s] Longest wait for a change of the mode, after the first request. Chosen: twice the wait for a
# reply, because the reply can be missing while the switcher still works.
CHANGE_TIMEOUT = 10.0
# Codes that say nothing about the result: the switcher does something else, or has not replied.
_UNFINISHED = (Code.BUSY, Code.TIMEOUT)


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
        name = self._checked_mode(allowed=(Code.OK,))
        assert name is not None  # not None, because the code was OK
        return name

    def select_mode(
        self, name: str, timeout: float = CHANGE_TIMEOUT, period: float = CHECK_PERIOD
    ) -> None:
        """Activate a mode, such as "normal", and wait until it is active.

        Args:
            name: Name of the mode.
            timeout: Longest wait after the first request [s].
            period: Time between two checks [s].

        Raises:
            Error: No switcher answers, it refuses the mode, or the mode is not active in time.
        """
        times = timeout, period
        active = self._change(Api.SELECT_MODE, {"name": name}, name, (Code.BUSY,), *times)
        if active != name:
            raise Error(
                f"motion switcher: got {_mode_text(active)} {timeout:g} s after the request for "
                f"'{name}', expected '{name}'; activate the mode with the vendor's app"
            )

    def release(
        self,
        on_message: Callable[[str], None],
        timeout: float = CHANGE_TIMEOUT,
        period: float = CHECK_PERIOD,
    ) -> str:
        """End the active mode; return its name, "" if none was active.

        Args:
            on_message: Function that receives each step as text.
            timeout: Longest wait after the first request [s].
            period: Time between two checks [s].

        Raises:
            Error: No switcher answers, it refuses, or a mode is still active after the timeout.
        """
        first = self.check_mode()
        if not first:
            return first
        on_message(f"motion switcher: mode '{first}' is active, releasing it")
        # After OK the release is repeated as well, as in the vendor's example.
        active = self._change(Api.RELEASE_MODE, {}, "", (Code.OK, Code.BUSY), timeout, period)
        if active != "":
            raise Error(
                f"motion switcher: got {_mode_text(active)} {timeout:g} s after the release of "
                f"'{first}', expected no mode; end the mode with the vendor's app"
            )
        return first

    def _change(
        self,
        api: Api,
        parameter: dict[str, str],
        target: str,
        repeated: tuple[int, ...],
        timeout: float,
        period: float,
    ) -> str | None:
        """Request a mode and wait until it is active or the timeout is over.

        Args:
            api: Function that changes the mode.
            parameter: Its parameter.
            target: Name of the mode to wait for; "": no mode.
            repeated: Codes after which the request is sent again. A code TIMEOUT is none of them,
                because the switcher may still work on the request.
            timeout: Longest wait after the first request [s].
            period: Time between two checks [s].

        Returns:
            Name of the active mode; None: the switcher was busy or did not reply.
        """
        code, _ = self._call(api, parameter, allowed=(Code.OK, *_UNFINISHED))
        deadline = time.monotonic() + timeout
        while True:
            time.sleep(period)
            active = self._checked_mode(allowed=(Code.OK, *_UNFINISHED))
            if active == target or time.monotonic() >= deadline:
                return active
            if active is not None and code in repeated:
                code, _ = self._call(api, parameter, allowed=(Code.OK, *_UNFINISHED))

    def _checked_mode(self, allowed: tuple[int, ...]) -> str | None:
        """Return the name of the active mode; None after an allowed code that is not OK."""
        code, data = self._call(Api.CHECK_MODE, {}, allowed)
        if code != Code.OK:
            return None
        try:
            return str(json.loads(data)["name"])
        except (ValueError, KeyError, TypeError):
            raise Error(
                f'motion switcher: got the answer {data!r}, expected JSON with "name"'
            ) from None

    def _call(
        self, api: Api, parameter: dict[str, str], allowed: tuple[int, ...]
    ) -> tuple[int, str]:
        # A switcher executes each request, so only the one that changes nothing is repeated.
        repeat = api is Api.CHECK_MODE
        code, data = self._client.call(api, json.dumps(parameter), REPLY_TIMEOUT, repeat)
        if code in allowed:
            return code, data
        unreachable = code in (Code.NO_SERVER, Code.TIMEOUT)
        raise Error(
            f"motion switcher: {api.name}: got code {code} ({_meaning(code)}), expected 0; "
            + ("check the cable to the robot" if unreachable else "use the vendor's app instead")
        )


def _mode_text(name: str | None) -> str:
    """Return the result of a check as text; None: there was no result."""
    if name is None:
        return "no reply"
    return f"mode '{name}'" if name else "no mode"


def _meaning(code: int) -> str:
    return Code(code).name if code in set(Code) else "a code of the switcher"

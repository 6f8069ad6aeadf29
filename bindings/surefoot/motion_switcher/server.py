"""Motion switcher of a virtual robot."""

from __future__ import annotations

import json
from collections.abc import Callable

from surefoot._core import DdsNetwork, DdsServiceServer, ServiceRequest
from surefoot.motion_switcher.api import FORM, MODES, SERVICE, Api, Code


class MotionSwitcherServer:
    """Motion switcher that knows a mode, but has no sport service.

    Args:
        network: Network and domain of the robot.
        mode: Mode that is active at the start; "": none.
        on_mode: Function that receives each new mode.

    Attributes:
        mode: Name of the active mode; "": none.
    """

    def __init__(self, network: DdsNetwork, mode: str, on_mode: Callable[[str], None]) -> None:
        self._server = DdsServiceServer(network, SERVICE)
        self._on_mode = on_mode
        self._silent = False
        self.mode = mode
        on_mode(mode)

    def poll(self) -> None:
        """Answer the requests that wait."""
        while (request := self._server.take()) is not None:
            code, data = self._answer(request)
            self._server.reply(request, code, data)

    def _answer(self, request: ServiceRequest) -> tuple[int, str]:
        try:
            parameter = json.loads(request.parameter or "{}")
        except ValueError:
            return Code.WRONG_PARAMETER, ""
        if not isinstance(parameter, dict):
            return Code.WRONG_PARAMETER, ""
        if request.api_id == Api.CHECK_MODE:
            return Code.OK, json.dumps({"form": FORM, "name": self.mode})
        if request.api_id == Api.RELEASE_MODE:
            return self._set_mode("")
        if request.api_id == Api.SELECT_MODE and parameter.get("name") in MODES:
            return self._set_mode(str(parameter["name"]))
        if request.api_id == Api.SET_SILENT and isinstance(parameter.get("silent"), bool):
            self._silent = parameter["silent"]
            return Code.OK, ""
        if request.api_id == Api.GET_SILENT:
            return Code.OK, json.dumps({"silent": self._silent})
        return Code.WRONG_PARAMETER, ""

    def _set_mode(self, mode: str) -> tuple[int, str]:
        if mode != self.mode:
            self.mode = mode
            self._on_mode(mode)
        return Code.OK, ""

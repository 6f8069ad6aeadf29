"""Functions, codes and modes of the motion switcher."""

from __future__ import annotations

from enum import IntEnum

SERVICE = "motion_switcher"
# Modes of robots with feet. Form "0" is a robot with feet, "1" one with wheels.
MODES = ("normal", "ai", "advanced")
FORM = "0"


class Api(IntEnum):
    """Numbers of the functions."""

    CHECK_MODE = 1001  # parameter {}, result {"form", "name"}; name "": no mode is active
    SELECT_MODE = 1002  # parameter {"name"}
    RELEASE_MODE = 1003  # parameter {}
    SET_SILENT = 1004  # parameter {"silent"}
    GET_SILENT = 1005  # result {"silent"}


class Code(IntEnum):
    """Codes of replies; 7001 .. 7005 are the switcher's own."""

    OK = 0
    NO_SERVER = 3102  # the request was not sent, because no server was discovered
    TIMEOUT = 3104  # the server has not answered in time
    WRONG_PARAMETER = 7001
    BUSY = 7002

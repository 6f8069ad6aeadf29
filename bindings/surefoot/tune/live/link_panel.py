"""Damp and re-arm: the controls of a robot that is not simulated here."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import viser

from surefoot.tune.live.gain_limiter import RANGE_FACTOR
from surefoot.tune.live.udp_session import UdpSession


def add_link_panel(
    gui: viser.GuiApi, robot: UdpSession, reset_reference: Callable[[], Any]
) -> None:
    """Add the controls; they go straight to the robot, whatever else the page is at.

    Args:
        gui: Where to.
        robot: The robot.
        reset_reference: Is called before a re-arm, which forgets the body reference.
    """
    damp = gui.add_button("Damp", color="red", hint="the motors brake, and stay so")
    damp.on_click(lambda _: robot.damp())
    rearm = gui.add_button("Re-arm", hint="stand again from where it is")

    @rearm.on_click
    def _(_: Any) -> None:
        reset_reference()
        robot.rearm()

    gui.add_markdown(
        f"_Gains move between 1/{RANGE_FACTOR:g} and {RANGE_FACTOR:g} times the robot's own, and take a second "
        "for either._"
    )

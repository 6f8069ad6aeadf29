"""Buttons of a robot on UDP: Damp, Re-arm, Walk and Stand."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import viser

from surefoot.tune.live.gain_limiter import RANGE_FACTOR
from surefoot.tune.live.udp_session import UdpSession


def add_link_panel(
    gui: viser.GuiApi, robot: UdpSession, can_walk: bool, reset_reference: Callable[[], Any]
) -> None:
    """Add the controls.

    They call the robot directly from the GUI's thread, so Damp does not wait for the session's
    thread.

    Args:
        gui: GUI that gets the controls.
        robot: Session on the robot.
        can_walk: Whether to add Walk and Stand.
        reset_reference: Function that zeroes the reference sliders. It is called before a re-arm,
            because a re-arm resets the body reference.
    """
    damp = gui.add_button("Damp", color="red", hint="the motors damp until Re-arm")
    damp.on_click(lambda _: robot.damp())
    rearm = gui.add_button("Re-arm", hint="stand again from the present pose")

    @rearm.on_click
    def _(_: Any) -> None:
        reset_reference()
        robot.rearm()

    if can_walk:
        walk = gui.add_button("Walk", hint="the velocity of the sliders and keys is in force")
        walk.on_click(lambda _: robot.request_walk())
        stand = gui.add_button("Stand", hint="stop on four feet and stand")
        stand.on_click(lambda _: robot.request_stand())
    gui.add_markdown(
        f"_Gains stay between 1/{RANGE_FACTOR:g} and {RANGE_FACTOR:g} times the robot's own; "
        "a change by that factor takes 1 s._"
    )

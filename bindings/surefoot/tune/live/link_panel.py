"""Damp and re-arm: the controls of a robot that is not simulated here."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import viser

from surefoot.tune.live.guard import FACTOR
from surefoot.tune.live.linked_robot import LinkedRobot


def add_link_panel(gui: viser.GuiApi, robot: LinkedRobot, latch_anew: Callable[[], Any]) -> None:
    """Add the controls; they go straight to the robot, whatever else the page is at.

    Args:
        gui: Where to.
        robot: The robot.
        latch_anew: Is called before a re-arm, which forgets the body reference.
    """
    damp = gui.add_button("Damp", color="red", hint="the motors brake, and stay so")
    damp.on_click(lambda _: robot.damp())
    rearm = gui.add_button("Re-arm", hint="stand again from where it is")

    @rearm.on_click
    def _(_: Any) -> None:
        latch_anew()
        robot.rearm()

    gui.add_markdown(
        f"_Gains move between 1/{FACTOR:g} and {FACTOR:g} times the robot's own, and take a second "
        "for either._"
    )

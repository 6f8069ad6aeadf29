"""Damp and re-arm: the controls of a robot that is not simulated here."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import viser

from surefoot.tune.live.guard import FACTOR
from surefoot.tune.live.linked_robot import LinkedRobot


def add_link_panel(
    gui: viser.GuiApi, robot: LinkedRobot, post: Callable[[Callable[[], Any]], None]
) -> None:
    """Add the controls.

    Args:
        gui: Where to.
        robot: The robot.
        post: Has an action done by the thread that the robot belongs to.
    """
    damp = gui.add_button("Damp", color="red", hint="the motors brake, and stay so")
    damp.on_click(lambda _: post(robot.damp))
    rearm = gui.add_button("Re-arm", hint="stand again from where it is")
    rearm.on_click(lambda _: post(robot.rearm))
    gui.add_markdown(
        f"_Gains move between 1/{FACTOR:g} and {FACTOR:g} times the robot's own, and take a second "
        "for either._"
    )

"""Controls of simulated time: run, pause, step, reset, speed."""

from __future__ import annotations

from typing import Any

import viser

from surefoot.tune.live.session_thread import SessionThread
from surefoot.tune.live.simulation import Simulation

SPEEDS = {"x 1": 1.0, "x 1/2": 0.5, "x 1/5": 0.2, "x 1/20": 0.05, "x 2": 2.0}


def add_time_panel(gui: viser.GuiApi, loop: SessionThread, simulation: Simulation) -> None:
    """Add the controls of time.

    Args:
        gui: GUI that gets the controls.
        loop: Thread that ticks the simulation.
        simulation: Simulation; the Reset button restarts it.
    """
    hint = "Step: one control period of 2 ms"
    buttons = gui.add_button_group("time", ("Run", "Pause", "Step", "Reset"), hint=hint)

    @buttons.on_click
    def _(_: Any) -> None:
        if buttons.value == "Reset":
            loop.post(simulation.reset)
        elif buttons.value == "Step":
            loop.paused = True
            loop.step()
        else:
            loop.paused = buttons.value == "Pause"

    speed = gui.add_dropdown("speed", tuple(SPEEDS), initial_value="x 1")

    @speed.on_update
    def _(_: Any) -> None:
        loop.speed = SPEEDS[speed.value]

"""Sliders of the body reference."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import viser

from surefoot.tune.live.session import REFERENCE_RANGES, Session

_STEPS = {"m": 0.005, "deg": 0.5}


def add_reference_panel(
    gui: viser.GuiApi, session: Session, post: Callable[[Callable[[], Any]], None]
) -> Callable[[], None]:
    """Add a slider for every axis of the body reference, and a button that zeroes them.

    Args:
        gui: GUI that gets the sliders.
        session: Session that receives the reference.
        post: Function that runs an action in the thread that owns the session.

    Returns:
        Function that zeroes the sliders.
    """
    hint = "relative to the latched pose; limited by the gains named reach_..."
    sliders: dict[str, Any] = {
        axis: gui.add_slider(f"{axis} [{unit}]", low, high, _STEPS[unit], 0.0, hint=hint)
        for axis, (unit, low, high) in REFERENCE_RANGES.items()
    }

    def send_reference(_: Any) -> None:
        values = {axis: float(slider.value) for axis, slider in sliders.items()}
        post(lambda: session.set_reference(values))

    for slider in sliders.values():
        slider.on_update(send_reference)

    def zero_sliders() -> None:
        for slider in sliders.values():
            slider.value = 0.0

    gui.add_button("Back to the latched pose").on_click(lambda _: zero_sliders())
    return zero_sliders

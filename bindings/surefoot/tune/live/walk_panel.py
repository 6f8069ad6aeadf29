"""Panel that commands the velocity of a robot, by sliders and keys."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import viser

from surefoot._core import Gait, WalkVelocity
from surefoot.tune.live.session import Session

# The keys of surefoot run, with its steps. W A S D Q E move the camera of the page.
_KEYS: tuple[tuple[Any, str, int, int], ...] = (
    ("I", "forward", 0, 1),
    ("K", "backward", 0, -1),
    ("H", "to the left", 1, 1),
    ("G", "to the right", 1, -1),
    ("J", "turn left", 2, 1),
    ("L", "turn right", 2, -1),
)
"""Key, meaning, axis of the velocity, sign."""
_STOP_KEY: Any = "0"
_UNITS = ("m/s", "m/s", "rad/s")
_STEPS = (0.01, 0.01, 0.05)  # steps of the sliders, in _UNITS
_KEY_STEPS = (0.1, 0.1, 0.2)  # steps of the keys, in _UNITS
_KEY_HINT = "_Keys: I K forward, backward; H G left, right; J L turn; 0 stop._"


class WalkPanel:
    """Sliders, keys and gait of a walking robot.

    Args:
        gui: GUI that gets the controls.
        session: Session on a robot that can walk.
        limits: Lowest and highest velocity, see velocity_range().
        post: Function that runs an action in the thread that owns the session.
    """

    def __init__(
        self,
        gui: viser.GuiApi,
        session: Session,
        limits: tuple[tuple[float, ...], tuple[float, ...]],
        post: Callable[[Callable[[], Any]], None],
    ) -> None:
        self._session, self._post = session, post
        self._version = session.velocity_version
        lowest, highest = limits
        names = ("forward", "left", "turn left")
        self._sliders: list[Any] = [
            gui.add_slider(
                f"{name} [{unit}]",
                _rounded(low, step),
                _rounded(high, step),
                step,
                0.0,
                hint="the robot stops when no browser shows the page",
            )
            for name, unit, low, high, step in zip(
                names, _UNITS, lowest, highest, _STEPS, strict=True
            )
        ]
        for slider in self._sliders:
            slider.on_update(lambda event: self._send() if event.client is not None else None)
        stop = gui.add_button("Stop", icon=viser.Icon.PLAYER_STOP)
        stop.on_click(lambda _: self._move((0.0, 0.0, 0.0)))
        hint = "auto: stand at velocity 0, trot otherwise; trot: also in place"
        gait = gui.add_dropdown("gait", tuple(g.name.lower() for g in Gait), hint=hint)
        gait.on_update(lambda _: post(lambda: session.set_gait(Gait[gait.value.upper()])))
        self._add_keys(gui)
        gui.add_markdown(_KEY_HINT)
        self._text = gui.add_markdown("")
        self.refresh()

    def refresh(self) -> None:
        """Show the figures of the walk, and the velocity if the session has set it to 0."""
        if self._session.velocity_version != self._version:
            self._version = self._session.velocity_version
            self._show((0.0, 0.0, 0.0))
        text = self._session.walk_text()
        if text != self._text.content:
            self._text.content = text

    def _add_keys(self, gui: viser.GuiApi) -> None:
        for key, meaning, axis, sign in _KEYS:
            command = gui.add_command(f"Walk: {meaning}", hotkey=key)
            command.on_trigger(partial(self._step, axis, sign))
        stop = gui.add_command("Walk: stop", hotkey=_STOP_KEY)
        stop.on_trigger(lambda _: self._move((0.0, 0.0, 0.0)))

    def _step(self, axis: int, sign: int, _: Any) -> None:
        velocity = [float(slider.value) for slider in self._sliders]
        slider = self._sliders[axis]
        value = velocity[axis] + sign * _KEY_STEPS[axis]
        velocity[axis] = round(min(max(value, slider.min), slider.max), 3)
        self._move((velocity[0], velocity[1], velocity[2]))

    def _move(self, velocity: tuple[float, float, float]) -> None:
        self._show(velocity)
        self._send()

    def _show(self, velocity: tuple[float, float, float]) -> None:
        for slider, value in zip(self._sliders, velocity, strict=True):
            slider.value = value

    def _send(self) -> None:
        velocity = WalkVelocity(*(float(slider.value) for slider in self._sliders))
        self._post(lambda: self._session.set_velocity(velocity))


def _rounded(value: float, step: float) -> float:
    """Return a value rounded towards 0 to a whole number of steps."""
    return round(int(value / step + (1e-6 if value > 0.0 else -1e-6)) * step, 6)

"""Sliders for all gains, in one folder per group."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import viser

from surefoot._core import GainInfo, gain_table, get_gain
from surefoot.tune.live.gain_editor import GainEditor
from surefoot.tune.live.gain_limiter import GainLimiter
from surefoot.tune.live.slider_range import RANGE_FACTORS, SliderRange, rounded_range, slider_range

_EXPANDED_GROUP = "Body"  # group whose folder is open when the page loads
_INITIAL_RANGE = "x 4"


class GainSliders:
    """Sliders that show and change the gains of an editor.

    Args:
        gui: GUI that gets the sliders.
        editor: Editor of the gains.
        post: Function that runs an action in the thread that owns the editor.
        gain_limiter: Ranges of the sliders. None: the user chooses the ranges ("slider reach").
    """

    def __init__(
        self,
        gui: viser.GuiApi,
        editor: GainEditor,
        post: Callable[[Callable[[], Any]], None],
        gain_limiter: GainLimiter | None = None,
    ) -> None:
        self._gui, self._editor, self._post, self._gain_limiter = gui, editor, post, gain_limiter
        self._slider_version = editor.slider_version
        self._range_factor = RANGE_FACTORS[_INITIAL_RANGE]
        if gain_limiter is None:
            self._add_range_choice()
        self._sliders: dict[str, viser.GuiSliderHandle[float]] = {}
        groups: dict[str, list[GainInfo]] = {}
        for info in gain_table():
            groups.setdefault(info.group, []).append(info)
        for group, rows in groups.items():
            with gui.add_folder(group, expand_by_default=group == _EXPANDED_GROUP):
                for info in rows:
                    self._sliders[info.name] = self._add_slider(info)

    def refresh(self) -> None:
        """Update the sliders after a change without a slider (undo, file, A or B) or a refusal."""
        if self._editor.slider_version == self._slider_version:
            return
        self._slider_version = self._editor.slider_version
        for info in gain_table():
            value = self._editor.get(info.name)
            self._update_range(info, value)
            _set_slider(self._sliders[info.name], value)

    def _add_range_choice(self) -> None:
        hint = "upper end of the sliders, in multiples of the robot's own gains"
        choice = self._gui.add_dropdown(
            "slider reach", tuple(RANGE_FACTORS), initial_value=_INITIAL_RANGE, hint=hint
        )

        @choice.on_update
        def _(_: Any) -> None:
            self._range_factor = RANGE_FACTORS[choice.value]
            for info in gain_table():
                self._update_range(info, self._editor.get(info.name))

    def _add_slider(self, info: GainInfo) -> viser.GuiSliderHandle[float]:
        value = self._editor.get(info.name)
        span = self._range(info, value)
        own = get_gain(self._editor.robot_gains, info.name)
        unit = "" if info.unit == "1" else f" [{info.unit.replace('^2', '²')}]"
        slider = self._gui.add_slider(
            f"{info.name}{unit}",
            min=span.low,
            max=span.high,
            step=span.step,
            initial_value=value,
            disabled=span.low == span.high,
            hint=f"{info.meaning}; {info.minimum:g} to {info.maximum:g}, the robot's own: {own:g}",
        )
        slider.precision = span.digits

        @slider.on_update
        def _(event: Any) -> None:
            if event.client is not None:  # None if refresh() moved the slider
                new_value = round(float(slider.value), 9)
                self._post(lambda: self._editor.set(info.name, new_value))

        return slider

    def _update_range(self, info: GainInfo, value: float) -> None:
        slider, span = self._sliders[info.name], self._range(info, value)
        now = (slider.min, slider.max, slider.step)
        if now == (span.low, span.high, span.step):
            return
        slider.min, slider.max = span.low, span.high
        slider.step, slider.precision = span.step, span.digits

    def _range(self, info: GainInfo, value: float) -> SliderRange:
        if self._gain_limiter is not None:
            return rounded_range(*self._gain_limiter.limits(info.name), value)
        return slider_range(
            info, get_gain(self._editor.robot_gains, info.name), value, self._range_factor
        )


def _set_slider(slider: Any, value: float) -> None:
    # `slider` is Any, because viser's type annotations wrongly declare `value` read-only.
    slider.value = value

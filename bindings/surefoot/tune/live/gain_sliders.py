"""A slider for every gain, in folders by what the gain belongs to."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import viser

from surefoot._core import GainInfo, gain_table, get_gain
from surefoot.tune.live.gain_editor import GainEditor
from surefoot.tune.live.guard import Guard
from surefoot.tune.live.slider_range import ZOOMS, SliderRange, fitted, slider_range

_OPEN = "Body"  # the group whose folder is not folded up
_FIRST_ZOOM = "x 4"


class GainSliders:
    """Shows an editor's gains and takes changes to it.

    Args:
        gui: Where to add them.
        editor: The gains.
        post: Has an action done by the thread that the editor belongs to.
        guard: Ranges that gains must stay in; None for those of a zoom that can be chosen.
    """

    def __init__(
        self,
        gui: viser.GuiApi,
        editor: GainEditor,
        post: Callable[[Callable[[], Any]], None],
        guard: Guard | None = None,
    ) -> None:
        self._gui, self._editor, self._post, self._guard = gui, editor, post, guard
        self._revision = editor.revision
        self._zoom = ZOOMS[_FIRST_ZOOM]
        if guard is None:
            self._add_zoom()
        self._sliders: dict[str, viser.GuiSliderHandle[float]] = {}
        groups: dict[str, list[GainInfo]] = {}
        for info in gain_table():
            groups.setdefault(info.group, []).append(info)
        for group, rows in groups.items():
            with gui.add_folder(group, expand_by_default=group == _OPEN):
                for info in rows:
                    self._sliders[info.name] = self._add_slider(info)

    def refresh(self) -> None:
        """Follow changes that were not made here: undo, a file, A or B, a refusal."""
        if self._editor.revision == self._revision:
            return
        self._revision = self._editor.revision
        for info in gain_table():
            value = self._editor.get(info.name)
            self._fit(info, value)
            _move(self._sliders[info.name], value)

    def _add_zoom(self) -> None:
        hint = "how far sliders reach, in multiples of the robot's own gains"
        choice = self._gui.add_dropdown(
            "slider reach", tuple(ZOOMS), initial_value=_FIRST_ZOOM, hint=hint
        )

        @choice.on_update
        def _(_: Any) -> None:
            self._zoom = ZOOMS[choice.value]
            for info in gain_table():
                self._fit(info, self._editor.get(info.name))

    def _add_slider(self, info: GainInfo) -> viser.GuiSliderHandle[float]:
        value = self._editor.get(info.name)
        place = self._range(info, value)
        own = get_gain(self._editor.own, info.name)
        unit = "" if info.unit == "1" else f" [{info.unit.replace('^2', '²')}]"
        slider = self._gui.add_slider(
            f"{info.name}{unit}",
            min=place.low,
            max=place.high,
            step=place.step,
            initial_value=value,
            disabled=place.low == place.high,
            hint=f"{info.meaning}; {info.minimum:g} to {info.maximum:g}, the robot's own: {own:g}",
        )
        slider.precision = place.digits

        @slider.on_update
        def _(event: Any) -> None:
            if event.client is not None:  # else it is refresh() that moved it
                wanted = round(float(slider.value), 9)
                self._post(lambda: self._editor.set(info.name, wanted))

        return slider

    def _fit(self, info: GainInfo, value: float) -> None:
        slider, place = self._sliders[info.name], self._range(info, value)
        now = (slider.min, slider.max, slider.step)
        if now == (place.low, place.high, place.step):
            return
        slider.min, slider.max = place.low, place.high
        slider.step, slider.precision = place.step, place.digits

    def _range(self, info: GainInfo, value: float) -> SliderRange:
        if self._guard is not None:
            return fitted(*self._guard.limits(info.name), value)
        return slider_range(info, get_gain(self._editor.own, info.name), value, self._zoom)


def _move(slider: Any, value: float) -> None:
    # A mypy of viser's own handles takes `value` for read-only; it is not.
    slider.value = value

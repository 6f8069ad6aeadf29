"""Panel of gains: undo, stored sets A and B, files, sliders."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import viser

from surefoot.tune.live.gain_editor import SLOTS, GainEditor, differences
from surefoot.tune.live.gain_folder import GainFolder
from surefoot.tune.live.gain_limiter import GainLimiter
from surefoot.tune.live.gain_sliders import GainSliders
from surefoot.tune.live.notifier import Notifier

Post = Callable[[Callable[[], Any]], None]

_UNDO, _OWN = "Undo", "Robot's own"
_SAVE, _LOAD = "Save", "Load"
_MAX_LISTED = 8  # largest number of gains in the text about changes


class GainPanel:
    """Panel that shows and changes gains.

    Args:
        gui: GUI that gets the panel.
        editor: Editor of the gains.
        files: Folder in which gains are saved and loaded.
        post: Function that runs an action in the thread that owns the editor.
        notifier: Notifier that shows what was done.
        gain_limiter: Limits for a robot on UDP; None for a simulated robot.
    """

    def __init__(
        self,
        gui: viser.GuiApi,
        editor: GainEditor,
        files: GainFolder,
        post: Post,
        notifier: Notifier,
        gain_limiter: GainLimiter | None = None,
    ) -> None:
        self._gui, self._editor, self._files = gui, editor, files
        self._post, self._notifier = post, notifier
        self._add_history()
        self._add_files()
        self._text = gui.add_markdown("")
        self._sliders = GainSliders(gui, editor, post, gain_limiter)
        self._gains_version = -1
        self.refresh()

    def refresh(self) -> None:
        """Show the present gains."""
        self._sliders.refresh()
        if self._editor.gains_version != self._gains_version:
            self._gains_version = self._editor.gains_version
            self._text.content = changes_text(self._editor)

    def _add_history(self) -> None:
        editor, post = self._editor, self._post
        back = self._gui.add_button_group("go back", (_UNDO, _OWN))
        store = self._gui.add_button_group("keep as", SLOTS)
        use = self._gui.add_button_group("take", SLOTS)

        @back.on_click
        def _(_: Any) -> None:
            if back.value == _UNDO:
                post(lambda: self._notify_unless(editor.undo(), "nothing to undo"))
            else:
                post(lambda: editor.replace(editor.robot_gains))

        @store.on_click
        def _(_: Any) -> None:
            slot = store.value
            post(lambda: self._store(slot))

        @use.on_click
        def _(_: Any) -> None:
            slot = use.value
            post(
                lambda: self._notify_unless(editor.use(slot), f"no gains are stored as {slot} yet")
            )

    def _add_files(self) -> None:
        name = self._gui.add_text("file", "gains.toml", hint="in the folder given with --folder")
        buttons = self._gui.add_button_group("", (_SAVE, _LOAD))

        @buttons.on_click
        def _(_: Any) -> None:
            act = self._save if buttons.value == _SAVE else self._load
            self._post(lambda: act(name.value))

    def _store(self, slot: str) -> None:
        self._editor.store(slot)
        self._notifier.show_done(f"stored as {slot}")
        self._gains_version = -1  # makes refresh() update the text that compares A and B

    def _save(self, name: str) -> None:
        path = self._files.save(name, self._editor.gains, "Found with surefoot tune live.")
        self._notifier.show_done(f"saved to {path}")

    def _load(self, name: str) -> None:
        self._editor.replace(self._files.load(name))
        self._notifier.show_done(f"loaded {name}")

    def _notify_unless(self, done: bool, failure_text: str) -> None:
        if not done:
            self._notifier.show_error(failure_text)


def changes_text(editor: GainEditor) -> str:
    """Return the differences from the robot's own gains, and between A and B, as Markdown."""
    changed = editor.changed()
    lines = [_listing("changed", changed)] if changed else ["The robot's own gains."]
    if len(editor.slots) == len(SLOTS):
        between = differences(editor.slots["A"], editor.slots["B"])
        lines.append(_listing("A to B", between) if between else "A and B are the same.")
    return "\n\n".join(lines)


def _listing(title: str, pairs: dict[str, tuple[float, float]]) -> str:
    words = [f"`{name}` {a:g} → {b:g}" for name, (a, b) in list(pairs.items())[:_MAX_LISTED]]
    more = f", and {len(pairs) - _MAX_LISTED} more" if len(pairs) > _MAX_LISTED else ""
    return f"**{title}:** {', '.join(words)}{more}"

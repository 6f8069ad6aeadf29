"""Undo, A and B, files and sliders: everything about gains."""

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
_MAX_LISTED = 8  # gains at most that the text about changes names


class GainPanel:
    """The part of the page that shows and changes gains.

    Args:
        gui: Where to add it.
        editor: The gains.
        files: Where they are saved and loaded.
        post: Has an action done by the thread that the editor belongs to.
        notifier: Is told what was done.
        gain_limiter: Of a robot that is not simulated; None without one.
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
        self._version = -1
        self.refresh()

    def refresh(self) -> None:
        """Show the gains as they are now."""
        self._sliders.refresh()
        if self._editor.version != self._version:
            self._version = self._editor.version
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
            post(lambda: self._notify_unless(editor.use(slot), f"nothing was kept as {slot} yet"))

    def _add_files(self) -> None:
        name = self._gui.add_text("file", "gains.toml", hint="in the folder of --folder")
        buttons = self._gui.add_button_group("", (_SAVE, _LOAD))

        @buttons.on_click
        def _(_: Any) -> None:
            act = self._save if buttons.value == _SAVE else self._load
            self._post(lambda: act(name.value))

    def _store(self, slot: str) -> None:
        self._editor.store(slot)
        self._notifier.tell(f"kept as {slot}")
        self._version = -1  # the text names what is kept

    def _save(self, name: str) -> None:
        path = self._files.save(name, self._editor.gains, "Found with surefoot tune live.")
        self._notifier.tell(f"saved to {path}")

    def _load(self, name: str) -> None:
        self._editor.replace(self._files.load(name))
        self._notifier.tell(f"loaded {name}")

    def _notify_unless(self, done: bool, failure_text: str) -> None:
        if not done:
            self._notifier.complain(failure_text)


def changes_text(editor: GainEditor) -> str:
    """Return what differs from the robot's own gains, and B from A, as Markdown."""
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

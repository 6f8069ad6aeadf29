"""Notifications of the page."""

from __future__ import annotations

from typing import Literal

import viser


class Notifier:
    """Sender of notifications to all connected browsers.

    Args:
        server: The server.
    """

    def __init__(self, server: viser.ViserServer) -> None:
        self._server = server

    def show_error(self, text: str) -> None:
        """Show an error."""
        self._show("Not done", text, "red")

    def show_done(self, text: str) -> None:
        """Show what was done."""
        self._show("Done", text, "green")

    def _show(self, title: str, text: str, colour: Literal["red", "green"]) -> None:
        line = " ".join(text.split())
        for client in self._server.get_clients().values():
            client.add_notification(title, line, color=colour, auto_close_seconds=8.0)

"""What the page says when something could not be done, or was."""

from __future__ import annotations

from typing import Literal

import viser


class Notifier:
    """Shows a line in every browser that is connected.

    Args:
        server: The server.
    """

    def __init__(self, server: viser.ViserServer) -> None:
        self._server = server

    def complain(self, text: str) -> None:
        """Say what was wrong."""
        self._show("Not done", text, "red")

    def tell(self, text: str) -> None:
        """Say what was done."""
        self._show("Done", text, "green")

    def _show(self, title: str, text: str, colour: Literal["red", "green"]) -> None:
        line = " ".join(text.split())
        for client in self._server.get_clients().values():
            client.add_notification(title, line, color=colour, auto_close_seconds=8.0)

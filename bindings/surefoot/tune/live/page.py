"""Page of a session: scene, plots, panels, and the thread that refreshes all of them."""

from __future__ import annotations

import threading
import time

import viser

from surefoot._core import Error
from surefoot.tune.live.gain_folder import GainFolder
from surefoot.tune.live.gain_panel import GainPanel
from surefoot.tune.live.link_panel import add_link_panel
from surefoot.tune.live.notifier import Notifier
from surefoot.tune.live.plots import Plots
from surefoot.tune.live.push_panel import PushPanel
from surefoot.tune.live.reference_panel import add_reference_panel
from surefoot.tune.live.scene import Scene
from surefoot.tune.live.server import close_server
from surefoot.tune.live.session import Session, velocity_range
from surefoot.tune.live.session_thread import SessionThread
from surefoot.tune.live.simulation import Simulation
from surefoot.tune.live.time_panel import add_time_panel
from surefoot.tune.live.udp_session import UdpSession
from surefoot.tune.live.walk_panel import WalkPanel
from surefoot.tune.live.world_panel import add_world_panel

# Chosen for a person: smooth motion; plots ten times and texts four times a second.
FRAME_PERIOD = 1.0 / 30.0  # [s] time between two frames
_PLOT_EVERY, _TEXT_EVERY = 3, 8  # number of frames per refresh of the plots and of the texts
_RETRY_TIME = 1.0  # [s] time from an error to the next frame
_PLOT_WIDTH, _PANEL_WIDTH = 330, 400  # [pixels]


class Page:
    """Page that shows and controls a session.

    Args:
        server: Server without content.
        session: Session on the robot; a thread of the page ticks the session.
        files: Folder in which gains are saved and loaded.
        plain: Whether to draw without shadows and reflections, for computers without a GPU.

    Attributes:
        loop: Thread that ticks the session.
        frames_per_second: Frames sent in the last second.
    """

    def __init__(
        self,
        server: viser.ViserServer,
        session: Session,
        files: GainFolder,
        plain: bool = False,
    ) -> None:
        self._server, self._session = server, session
        self.notifier = Notifier(server)
        self.loop = SessionThread(session, self.notifier.show_error)
        self.frames_per_second = 0.0
        self._stop_event = threading.Event()
        self._draw_thread = threading.Thread(target=self._draw, name="surefoot page", daemon=True)
        server.gui.configure_theme(show_logo=False, show_share_button=False)
        self._scene = Scene(server, session.description)
        self._status = server.gui.add_markdown("")
        self._panels = self._add_robot_controls()
        tabs = server.gui.add_tab_group()
        with tabs.add_tab("Gains"):
            self._gains = GainPanel(
                server.gui,
                session.editor,
                files,
                self.loop.post,
                self.notifier,
                session.gain_limiter,
            )
        with tabs.add_tab("Body"):
            self._zero_reference = add_reference_panel(server.gui, session, self.loop.post)
        if isinstance(session, Simulation):
            with tabs.add_tab("World"):
                add_world_panel(server.gui, session, self.loop.post)
        with tabs.add_tab("View"):
            self._add_view_controls(plain)
        self._plots = self._add_plots()

    def start(self) -> None:
        """Start both threads: one ticks the session, one draws."""
        self.loop.start()
        self._draw_thread.start()

    def check(self) -> None:
        """Raise Error if a thread of the page has ended without stop()."""
        for thread in (self.loop, self._draw_thread):
            if not thread.is_alive():
                raise Error(f"thread '{thread.name}' has ended: start surefoot tune live again")

    def stop(self) -> None:
        """End both threads, close the session and close the server."""
        self._stop_event.set()
        self._draw_thread.join()
        self.loop.stop()
        self._session.close()
        close_server(self._server)

    def _add_robot_controls(self) -> list[WalkPanel | PushPanel]:
        """Add the controls of the robot; return the panels that need to be refreshed."""
        gui, session, post = self._server.gui, self._session, self.loop.post
        limits, panels = velocity_range(session.robot), list[WalkPanel | PushPanel]()
        if isinstance(session, UdpSession):
            add_link_panel(gui, session, limits is not None, lambda: self._zero_reference())
        if isinstance(session, Simulation):
            add_time_panel(gui, self.loop, session)
        if limits is not None:
            with gui.add_folder("Walk"):
                panels.append(WalkPanel(gui, session, limits, post))
        if isinstance(session, Simulation):
            with gui.add_folder("Push"):
                panels.append(PushPanel(gui, session, post, self.notifier))
        return panels

    def _add_view_controls(self, plain: bool) -> None:
        hint = "no shadows and reflections, for a computer without a GPU"
        box = self._server.gui.add_checkbox("plain light", plain, hint=hint)
        box.on_update(lambda _: self._scene.set_plain(box.value))
        self._scene.set_plain(plain)

    def _add_plots(self) -> Plots:
        gui = self._server.gui
        panel = gui.add_panel()
        with panel.add_tab("The last 10 s"):
            plots = Plots(gui, self._session.curves)
        panel.dock_left()
        panel.set_width(_PLOT_WIDTH)
        gui.main_panel.dock_right()
        gui.main_panel.set_width(_PANEL_WIDTH)
        return plots

    def _draw(self) -> None:
        count, window_start, window_frames = 0, time.monotonic(), 0
        while not self._stop_event.wait(
            max(0.0, window_start + (window_frames + 1) * FRAME_PERIOD - time.monotonic())
        ):
            count, window_frames = count + 1, window_frames + 1
            try:
                self._refresh(count)
            except Exception as problem:  # a failed frame must not end the thread
                self.notifier.show_error(f"{type(problem).__name__}: {problem}")
                if self._stop_event.wait(_RETRY_TIME):
                    break
            now = time.monotonic()
            if now - window_start > 1.0:
                self.frames_per_second = window_frames / (now - window_start)
                window_start, window_frames = now, 0

    def _refresh(self, count: int) -> None:
        self._session.attended = bool(self._server.get_clients())
        self._scene.show(self._session.scene_state)
        if count % _PLOT_EVERY == 0:
            self._plots.refresh()
        if count % _TEXT_EVERY == 0:
            self._refresh_texts()

    def _refresh_texts(self) -> None:
        self._gains.refresh()
        for panel in self._panels:
            panel.refresh()
        text = f"**{self._session.status}** · {self.frames_per_second:.0f} frames/s"
        if isinstance(self._session, Simulation):
            text += (
                " · paused"
                if self.loop.paused
                else f" · {self.loop.real_time_factor:.2f} x real time"
            )
        if text != self._status.content:
            self._status.content = text

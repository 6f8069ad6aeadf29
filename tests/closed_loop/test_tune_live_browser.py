# SPDX-License-Identifier: BSD-3-Clause
"""surefoot tune live in a real browser; out/tune-live.png is a screenshot."""

from __future__ import annotations

import contextlib
import os
import shutil
import signal
import subprocess
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest
import surefoot
from PIL import Image
from surefoot.robot.description import describe_robot
from surefoot.tune.live.gain_folder import GainFolder
from surefoot.tune.live.page import Page
from surefoot.tune.live.server import open_server
from surefoot.tune.live.simulation import Simulation

pytestmark = pytest.mark.real_time

sync_api = pytest.importorskip("playwright.sync_api", reason="playwright is not installed")

BROWSERS = ("chromium-headless-shell", "chromium", "chromium-browser", "google-chrome")
FLAGS = [
    "--headless",
    "--no-sandbox",
    "--remote-debugging-port=0",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--disable-dev-shm-usage",
    "--disable-background-networking",
    "--disable-component-update",
    "--force-color-profile=srgb",
    "--no-first-run",
]
TIMEOUT_MS = 60_000.0  # [ms]; frames are slow without a graphics card
PICTURE = Path(__file__).parents[2] / "out" / "tune-live.png"
KP = "com_kp_horizontal"


class Live(NamedTuple):
    """A served page, and the same page in a browser."""

    session: Simulation
    page: Page
    tab: sync_api.Page
    folder: Path


@contextlib.contextmanager
def without_preload() -> Iterator[None]:
    """Start processes without the stall-tolerant clock: a browser's sandbox allows no preload."""
    preloaded = os.environ.pop("LD_PRELOAD", None)
    try:
        yield
    finally:
        if preloaded is not None:
            os.environ["LD_PRELOAD"] = preloaded


@contextlib.contextmanager
def browser_process(path: str, profile: Path) -> Iterator[str]:
    """Start a browser, yield its address, and kill it at the end.

    A request to close would first draw all pending frames.
    """
    profile.mkdir()
    command = [path, *FLAGS, f"--user-data-dir={profile}"]
    said, chosen = profile / "stderr.txt", profile / "DevToolsActivePort"
    with said.open("w") as file:
        process = subprocess.Popen(
            command, start_new_session=True, stdout=subprocess.DEVNULL, stderr=file
        )

    def listens() -> bool:
        assert process.poll() is None, f"{path} has ended: {said.read_text()}"
        return chosen.is_file() and "\n" in chosen.read_text()

    try:
        wait_until(listens)
        yield f"http://127.0.0.1:{chosen.read_text().split()[0]}"
    finally:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        process.wait()


@pytest.fixture
def chromium(tmp_path: Path) -> Iterator[sync_api.Browser]:
    path = next((path for name in BROWSERS if (path := shutil.which(name))), None)
    if path is None:
        pytest.skip(f"no browser: none of {', '.join(BROWSERS)} is on the PATH")
    with (
        without_preload(),
        sync_api.sync_playwright() as playwright,
        browser_process(path, tmp_path / "profile") as address,
    ):
        yield playwright.chromium.connect_over_cdp(address)


@pytest.fixture
def live(tmp_path: Path, chromium: sync_api.Browser) -> Iterator[Live]:
    session = Simulation(describe_robot("go1"))
    server = open_server("127.0.0.1", 0, "surefoot tune live: go1")
    # Without a graphics card, shadows take 1 s of CPU time per frame.
    page = Page(server, session, GainFolder(tmp_path, session.robot), plain=True)
    page.start()
    # As small as the panel allows, because the CPU draws every pixel.
    tab = chromium.new_page(viewport={"width": 900, "height": 480})
    tab.set_default_timeout(TIMEOUT_MS)
    tab.goto(f"http://127.0.0.1:{server.get_port()}")
    tab.get_by_role("button", name="Push").wait_for()
    yield Live(session, page, tab, tmp_path)
    page.stop()


def wait_until(condition: Callable[[], bool]) -> None:
    end = time.monotonic() + TIMEOUT_MS / 1000.0
    while not condition():
        assert time.monotonic() < end, "the condition did not become true in time"
        time.sleep(0.05)


def controller_gain(live: Live, name: str) -> float:
    return surefoot.get_gain(live.session.controller.gains, name)


def move_slider(live: Live, name: str, presses: int) -> None:
    """Focus the slider below a name and press an arrow key."""
    slider = live.tab.get_by_text(name).first.locator("xpath=following::*[@role='slider'][1]")
    slider.focus()
    for _ in range(presses):
        slider.press("ArrowRight")


def test_browser_changes_a_gain_pushes_and_saves_a_file(live: Live) -> None:
    tab, session = live.tab, live.session
    own = controller_gain(live, KP)

    move_slider(live, KP, 10)
    # A slider has whole steps; the robot's own gain may be between two of them.
    wait_until(lambda: abs(controller_gain(live, KP) - own - 10.0) <= 1.0)
    moved = controller_gain(live, KP)
    tab.get_by_text(f"{own:g} → {moved:g}").wait_for()

    tab.get_by_role("button", name="Push").click()
    wait_until(lambda: session.score.seconds_left > 0.0)
    tab.get_by_text("Last push: ").wait_for()
    tab.get_by_text("lower is better").wait_for()
    assert session.healthy and session.curves.arrays()[1].max() > 2.0  # [mm]
    assert session.score.last_cost is not None and session.score.last_cost.terms["fall"] == 0.0

    tab.get_by_role("button", name="Save").click()
    wait_until(lambda: (live.folder / "gains.toml").is_file())
    saved = surefoot.load_gains(live.folder / "gains.toml")
    assert saved == session.editor.gains and surefoot.get_gain(saved, KP) == moved

    tab.get_by_role("button", name="Undo").click()
    wait_until(lambda: controller_gain(live, KP) == own)
    tab.get_by_role("button", name="Load").click()
    wait_until(lambda: session.editor.gains == saved)


def test_keys_walk_the_robot_and_the_stop_button_stops_it(live: Live) -> None:
    tab, session = live.tab, live.session
    for _ in range(3):
        tab.keyboard.press("i")
    tab.keyboard.press("j")
    wait_until(lambda: session.controller.commanded_velocity.vx == pytest.approx(0.3))
    wait_until(lambda: session.controller.commanded_velocity.yaw_rate == pytest.approx(0.2))
    tab.get_by_text("Command 0.30, 0.00 m/s, 0.20 rad/s").wait_for()
    tab.get_by_role("button", name="Stop").click()
    wait_until(lambda: not session.controller.walking)
    tab.keyboard.press("h")
    wait_until(lambda: session.controller.walking)
    tab.keyboard.press("0")
    wait_until(lambda: not session.controller.walking)
    tab.keyboard.press("i")
    wait_until(lambda: session.controller.walking)
    tab.close()  # nobody watches
    wait_until(lambda: not session.controller.walking)
    assert session.healthy


def test_page_shows_error_messages(live: Live) -> None:
    tab = live.tab
    (live.folder / "gains.toml").write_text("[gains]\ncom_kp_horizontl = 3\n")
    tab.get_by_role("button", name="Load").click()
    tab.get_by_text("com_kp_horizontl").wait_for()
    (live.folder / "gains.toml").unlink()
    (live.folder / "gains.toml").mkdir()
    tab.get_by_role("button", name="Save").click()
    tab.get_by_text("Is a directory").first.wait_for()
    tab.get_by_role("button", name="Compare A and B").click()
    tab.get_by_text("no gains are stored as A and B yet").wait_for()
    assert live.session.editor.changed() == {}


def test_page_screenshot_shows_robot_forces_support_and_push(live: Live) -> None:
    tab = live.tab
    tab.set_viewport_size({"width": 1280, "height": 800})
    tab.get_by_role("button", name="Push").click()
    tab.get_by_text("lower is better").wait_for()
    notice = tab.get_by_text("Software WebGL rendering detected")
    if notice.count():
        notice.locator("xpath=following::button[1]").click()
        notice.wait_for(state="detached")
    # Pause during the push, so that the screenshot shows its arrow.
    live.page.loop.speed = 0.02
    tab.get_by_role("button", name="Push").click()
    wait_until(lambda: live.session.scene_state.push is not None)
    live.page.loop.paused = True
    tab.get_by_text("paused").wait_for()
    time.sleep(2.0)
    PICTURE.parent.mkdir(exist_ok=True)
    tab.screenshot(path=PICTURE, timeout=TIMEOUT_MS)
    pixels = np.asarray(Image.open(PICTURE).convert("RGB"), dtype=int)
    red, green, blue = np.moveaxis(pixels[:, 340:860], -1, 0)
    assert np.count_nonzero((red < 90) & (green < 90) & (blue < 90)) > 3000  # legs
    assert np.count_nonzero((green > red + 30) & (green > blue + 15)) > 100  # forces
    assert np.count_nonzero((blue > red + 60) & (blue > 150)) > 100  # the support polygon's edge
    assert np.count_nonzero((red > green + 60) & (red > blue + 60)) > 100  # the push

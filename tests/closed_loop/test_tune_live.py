# SPDX-License-Identifier: BSD-3-Clause
"""surefoot tune live without a browser: gains, pushes, files, guarded ranges, addresses."""

from __future__ import annotations

import contextlib
import os
import re
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import surefoot
import viser
from surefoot import protocol
from surefoot.cli import main
from surefoot.robot.description import describe_robot
from surefoot.tune.live.control_process import RobotAddress
from surefoot.tune.live.gain_editor import GainEditor
from surefoot.tune.live.gain_folder import GainFolder
from surefoot.tune.live.gain_limiter import GainLimiter
from surefoot.tune.live.metric_curves import BUCKET_TIME, Curves, TickMetrics
from surefoot.tune.live.page import Page
from surefoot.tune.live.push_cost import push_cost
from surefoot.tune.live.robot_mesh import body_meshes
from surefoot.tune.live.scene_state import SceneState
from surefoot.tune.live.server import close_server, open_server
from surefoot.tune.live.session_thread import SessionThread
from surefoot.tune.live.simulation import Simulation
from surefoot.tune.live.slider_range import slider_range
from surefoot.tune.live.treadmill import Treadmill
from surefoot.tune.live.udp_session import UdpSession
from surefoot.tune.live.world import World
from virtual_robot_helpers import start_robot

pytestmark = pytest.mark.slow

OWN = surefoot.load_robot("go1").config.gains
KP = "com_kp_horizontal"
OWN_KP = surefoot.get_gain(OWN, KP)


def simulation(**world: object) -> Simulation:
    return Simulation(describe_robot("go1"), world=World(**world))


def run(session: Simulation, seconds: float) -> None:
    for _ in range(round(seconds / session.period)):
        session.tick()


def wait_until(condition: Callable[[], bool], seconds: float = 20.0) -> None:
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, "the condition did not become true in time"
        time.sleep(0.02)


def editor_with_clock() -> tuple[GainEditor, list[float]]:
    clock = [0.0]
    return GainEditor(OWN, now=lambda: clock[0]), clock


def test_one_slider_drag_is_one_undo_step() -> None:
    editor, clock = editor_with_clock()
    for value in (61.0, 62.0, 63.0):
        clock[0] += 0.1
        editor.set(KP, value)
    clock[0] += 5.0
    editor.set(KP, 70.0)
    assert editor.undo() and editor.get(KP) == 63.0
    assert editor.undo() and editor.gains == OWN
    assert not editor.undo()


def test_out_of_range_gains_are_refused_and_reset_the_slider() -> None:
    editor, _ = editor_with_clock()
    with pytest.raises(surefoot.Error, match=KP):
        editor.set(KP, 1e6)
    with pytest.raises(surefoot.Error, match="contact_force_on"):
        editor.set("contact_force_off", 0.3)
    assert editor.gains == OWN and editor.gains_version == 0 and editor.slider_version == 2


def test_slots_a_and_b_store_and_restore_gains() -> None:
    editor, _ = editor_with_clock()
    editor.store("A")
    editor.set(KP, 80.0)
    editor.store("B")
    assert editor.use("A") and editor.gains == OWN
    assert editor.use("B") and editor.get(KP) == 80.0
    assert editor.changed() == {KP: (OWN_KP, 80.0)}


def test_changed_gain_reaches_the_controller() -> None:
    session = simulation()
    session.editor.set(KP, 90.0)
    run(session, 0.01)
    assert surefoot.get_gain(session.controller.gains, KP) == 90.0


@pytest.mark.parametrize("degrees", [0.0, 90.0])
def test_a_pushed_robot_recovers_and_gets_a_score(degrees: float) -> None:
    session = simulation()
    run(session, 0.5)
    assert session.push(degrees, 50.0) > 3.0
    run(session, 0.05)
    session.update_view()
    assert session.scene_state.push is not None and session.score.seconds_left > 2.9
    run(session, 3.0)
    session.update_view()
    assert (
        session.healthy and session.scene_state.push is None and session.scene_state.contact.all()
    )
    assert session.score.last_cost is not None and 0.1 < session.score.last_cost.value < 10.0
    assert session.curves.arrays()[1].max() > 2.0  # [mm]


def test_fall_after_a_push_ends_with_reset() -> None:
    session = simulation()
    run(session, 0.5)
    session.push(90.0, 500.0)  # percent of the push limit; a robot that steps survives 300
    run(session, 3.2)
    session.update_view()
    assert not session.healthy and "fallen" in session.status
    assert session.score.last_cost is not None and session.score.last_cost.terms["fall"] > 0.0
    session.editor.set(KP, 90.0)
    session.reset()
    run(session, 0.5)
    assert session.healthy and surefoot.get_gain(session.controller.gains, KP) == 90.0


def test_new_world_restarts_the_stand_and_an_impossible_world_is_refused() -> None:
    session = simulation()
    session.requested_world = World(payload_kg=3.0, friction=0.5, delay_ms=2.0, sensors="ideal")
    session.apply_requested_world()
    run(session, 0.5)
    assert session.healthy and session.plant.settings.payload_kg == 3.0
    with pytest.raises(surefoot.Error, match="fell"):
        session.set_world(World(payload_kg=200.0))
    run(session, 0.1)
    assert session.healthy and session.world.payload_kg == 3.0


def test_reference_sliders_move_the_body() -> None:
    session = simulation()
    run(session, 0.5)
    before = session.plant.truth.q[2]
    session.set_reference({"height": -0.03, "roll": 5.0})
    run(session, 2.0)
    assert session.plant.truth.q[2] - before == pytest.approx(-0.03, abs=0.003)


def test_walking_robot_follows_its_velocity_and_shows_its_errors() -> None:
    session = simulation()
    run(session, 0.5)
    session.set_velocity(surefoot.WalkVelocity(0.5, 0.0, 0.3))
    run(session, 4.0)
    rms = session.walk_figures.rms
    assert session.healthy and "walking" in session.status and rms is not None
    assert np.all(rms < [0.05, 0.05, 0.1, 2.0, 2.0])  # [m/s, m/s, rad/s, deg, deg]
    assert "Command 0.50, 0.00 m/s, 0.30 rad/s" in session.walk_figures.text()
    assert session.curves.arrays()[1].max() < 80.0  # [mm] the reference walks too
    session.push(90.0, 20.0)
    assert session.score.seconds_left == 0.0  # the cost of a push is that of a stand


def test_unattended_robot_stops_and_restart_stands() -> None:
    session = simulation()
    session.set_velocity(surefoot.WalkVelocity(0.4, 0.0, 0.0))
    run(session, 1.5)
    assert session.controller.walking
    session.attended = False
    run(session, 2.5)
    assert not session.controller.walking and session.healthy
    session.attended = True
    run(session, 1.0)
    assert session.controller.walking
    version = session.velocity_version
    session.reset()
    run(session, 0.5)
    assert not session.controller.walking and session.velocity_version == version + 1


def test_gait_trot_steps_in_place_also_after_a_reset() -> None:
    session = simulation()
    session.set_gait(surefoot.Gait.TROT)
    session.reset()
    run(session, 1.0)
    assert session.controller.walking and session.walk_figures.rms is not None


def test_view_follows_a_walking_robot_along_a_slope() -> None:
    quaternion = np.array([np.cos(0.1), 0.0, -np.sin(0.1), 0.0])  # uphill forward by 0.2 rad
    treadmill = Treadmill(0.15, 0.5)
    for x in np.linspace(0.0, 7.3, 100):
        qpos = np.array([x, 0.02, x * np.tan(0.2) + 0.3, 1.0, 0.0, 0.0, 0.0])
        corner = qpos[:3] - [0.0, 0.0, 0.3]
        feet = np.tile(corner, (4, 1))
        state = SceneState(qpos, feet, np.zeros((4, 3)), np.ones(4, bool), qpos[:3], quaternion)
        seen = treadmill.follow(state)
        assert np.linalg.norm(seen.qpos[:2]) <= 0.15 + 1e-9
        normal = np.array([-np.sin(0.2), 0.0, np.cos(0.2)])
        assert abs(seen.contact_points[0] @ normal) < 1e-9  # the feet stay on the ground
        place = treadmill.ground_position(quaternion)
        assert abs(place @ normal) < 1e-9 and np.linalg.norm(place) < 0.5
        moved = seen.contact_points[0] - place
        sections = (corner - moved) @ np.array([np.cos(0.2), 0.0, np.sin(0.2)]) / 0.5
        assert abs(sections - round(sections)) < 1e-6  # the grid moves with the feet


def test_comparison_gives_worse_gains_a_higher_cost() -> None:
    loose = OWN.__copy__()
    for name in (KP, "base_kp_tilt", "weight_base_tilt"):
        surefoot.set_gain(loose, name, 0.1 * surefoot.get_gain(OWN, name))
    costs = [push_cost(describe_robot("go1"), World(), gains, 0.0, 50.0) for gains in (OWN, loose)]
    assert costs[0].value < costs[1].value


def test_saved_gains_load_unchanged(tmp_path: Path) -> None:
    robot = surefoot.load_robot("go1")
    files = GainFolder(tmp_path, robot)
    gains = OWN.__copy__()
    surefoot.set_gain(gains, KP, 71.25)
    path = files.save("my.toml", gains, "a comment")
    assert files.load("my.toml") == gains == surefoot.load_gains(path)
    for name in ("../my.toml", "/tmp/my.toml", "my.txt", ".toml", ""):
        with pytest.raises(surefoot.Error, match="file"):
            files.save(name, gains)
    (tmp_path / "wrong.toml").write_text("[gains]\ncom_kp_horizontl = 3\n")
    with pytest.raises(surefoot.Error, match="com_kp_horizontal"):
        files.load("wrong.toml")
    (tmp_path / "folder.toml").mkdir()
    with pytest.raises(OSError):
        files.save("folder.toml", gains)


def test_plots_keep_every_peak() -> None:
    curves = Curves()
    for k in range(1000):
        curves.add(0.002 * (k + 1), TickMetrics(50.0 if k == 333 else 1.0, 0.0, 0.0, 0.0, 0.0))
    time_, error, *_ = curves.arrays()
    assert error.max() == 50.0 and len(time_) <= 2.0 / BUCKET_TIME + 1
    assert np.all(np.diff(time_) > 0.0)


def test_slider_range_contains_the_gain() -> None:
    for info in surefoot.gain_table():
        own = surefoot.get_gain(OWN, info.name)
        place = slider_range(info, own, own, 4.0)
        assert info.minimum <= place.low <= own <= place.high <= info.maximum
        assert (place.high - place.low) / place.step >= 50


@pytest.mark.parametrize("name", ["a1", "go1", "go2", "b1"])
def test_robot_mesh_has_few_parts_and_the_size_of_the_robot(name: str) -> None:
    session = Simulation(describe_robot(name))
    from surefoot.sim.model.mujoco_model import build_model

    model = build_model(session.robot, session.description, session.plant.settings, visuals=True)
    parts = body_meshes(model)
    assert len({part.body for part in parts}) == 13 and len(parts) < 25
    assert all(np.isfinite(part.vertices).all() for part in parts)
    reach = max(np.abs(part.vertices).max() for part in parts)
    assert 0.2 < reach < 1.0  # [m]


def test_simulation_runs_in_real_time_and_stops_when_paused() -> None:
    session, complaints = simulation(), list[str]()
    loop = SessionThread(session, complaints.append)
    loop.start()
    wait_until(lambda: session.ticks > 500)
    begin, ticks = time.monotonic(), session.ticks
    time.sleep(1.0)
    factor = (session.ticks - ticks) * session.period / (time.monotonic() - begin)
    loop.paused = True
    time.sleep(0.1)
    still = session.ticks
    loop.step(3)
    wait_until(lambda: session.ticks != still)
    time.sleep(0.1)
    loop.post(lambda: session.editor.set(KP, -1.0))
    wait_until(lambda: bool(complaints))
    loop.stop()
    assert session.ticks == still + 3 and 0.5 < factor < 1.2
    assert KP in complaints[0]


def test_guarded_gains_stay_within_a_factor_2_and_change_slowly() -> None:
    gain_limiter = GainLimiter(OWN)
    editor = GainEditor(OWN, check=gain_limiter.check)
    with pytest.raises(surefoot.Error, match=f"'{KP}': got .*, expected {0.5 * OWN_KP:g} to"):
        editor.set(KP, 2.01 * OWN_KP)
    editor.set(KP, 2.0 * OWN_KP)
    editor.set("contact_force_on", 0.14)
    present = OWN
    for seconds in range(1, 11):
        present = gain_limiter.step_towards(present, editor.gains, 0.1)
        present.validate()
        assert surefoot.get_gain(present, KP) == pytest.approx(OWN_KP * 2.0 ** (0.1 * seconds))
    assert gain_limiter.step_towards(present, editor.gains, 0.1) == editor.gains


def test_udp_robot_stands_with_guarded_gains(tmp_path: Path) -> None:
    process, port = start_robot()
    robot = UdpSession(describe_robot("go1"), RobotAddress("127.0.0.1", port, "go1-v3.8"))
    server = open_server("127.0.0.1", 0, "test")
    page = Page(server, robot, GainFolder(tmp_path, robot.robot))
    loop = page.loop
    page.start()
    try:
        wait_until(lambda: robot.healthy)
        loop.post(lambda: robot.editor.set(KP, 90.0))
        wait_until(lambda: OWN_KP < surefoot.get_gain(robot.active_gains, KP) < 90.0)
        wait_until(lambda: robot.active_gains == robot.editor.gains)
        loop.post(lambda: robot.set_reference({"height": -0.03}))
        height = robot.scene_state.qpos[2]
        wait_until(lambda: robot.scene_state.qpos[2] < height - 0.02)
        assert robot.healthy and robot.scene_state.contact.sum() == 4
        robot.damp()
        wait_until(lambda: "damping: asked" in robot.status)
        robot.rearm()
        wait_until(lambda: robot.healthy)
        time.sleep(1.5)
        assert page.frames_per_second > 5.0  # the page still draws
    finally:
        page.stop()
        process.send_signal(signal.SIGTERM)
        process.wait(timeout=20)


def test_udp_robot_walks_while_the_page_is_watched(tmp_path: Path) -> None:
    process, port = start_robot()
    address = RobotAddress("127.0.0.1", port, "go1-v3.8", power_level=5)
    robot = UdpSession(describe_robot("go1"), address)
    loop = SessionThread(robot, lambda _: None)
    loop.start()
    velocity = surefoot.WalkVelocity(vx=0.4)
    try:
        wait_until(lambda: robot.healthy)
        loop.post(lambda: robot.set_velocity(velocity))
        wait_until(lambda: robot.velocity_version == 1)  # sliders alone do not begin a walk
        robot.damp()
        wait_until(lambda: "damping" in robot.status)
        robot.request_walk()
        wait_until(lambda: "walk refused: " in robot.status)
        robot.rearm()
        wait_until(lambda: robot.healthy and "refused" not in robot.status)
        time.sleep(1.0)  # until the torques have faded in
        robot.request_walk()
        wait_until(lambda: robot.runner_status.phase == "walking")
        start = robot.runner_status.q[0]
        loop.post(lambda: robot.set_velocity(velocity))
        wait_until(lambda: robot.runner_status.q[0] > start + 0.5)
        assert robot.healthy and "Command 0.40, 0.00 m/s" in robot.walk_text()
        loop.post(lambda: robot.set_gait(surefoot.Gait.TROT))
        wait_until(lambda: "gait trot" in robot.walk_text())
        robot.attended = False
        wait_until(lambda: "Command 0.00, 0.00 m/s" in robot.walk_text())
        robot.request_stand()
        wait_until(lambda: robot.runner_status.phase == "standing")
        wait_until(lambda: robot.velocity_version == 2)
    finally:
        loop.stop()
        robot.close()
        process.send_signal(signal.SIGTERM)
        process.wait(timeout=20)


def test_robot_of_another_generation_is_refused(tmp_path: Path) -> None:
    process, port = start_robot("--robot", "a1")
    robot = UdpSession(describe_robot("go1"), RobotAddress("127.0.0.1", port, "go1-v3.8"))
    loop = SessionThread(robot, lambda _: None)
    loop.start()
    try:
        wait_until(lambda: "ended: wrong generation: " in robot.status)
        assert not robot.healthy
    finally:
        loop.stop()
        robot.close()
        process.send_signal(signal.SIGTERM)
        process.wait(timeout=20)


class Listener(threading.Thread):
    """A socket in place of a robot: counts the frames received and keeps the last."""

    def __init__(self) -> None:
        super().__init__(daemon=True)
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.bind(("127.0.0.1", 0))
        self.socket.settimeout(0.2)
        self.port, self.count, self.frame, self.last = self.socket.getsockname()[1], 0, b"", 0.0
        self.start()

    def run(self) -> None:
        while self.socket.fileno() >= 0:
            with contextlib.suppress(OSError):
                self.frame = self.socket.recv(2048)
                self.count, self.last = self.count + 1, time.monotonic()

    def last_frame_damps(self) -> bool:
        cmd = protocol.decode_low_cmd(self.frame, "go1-v3.8")
        motors = [cmd.motorCmd[i] for i in range(12)]
        return all(m.tau == 0.0 and m.Kp == 0.0 and m.Kd > 0.0 and m.dq == 0.0 for m in motors)


def test_hung_page_does_not_stop_commands_to_the_robot() -> None:
    listener = Listener()
    robot = UdpSession(describe_robot("go1"), RobotAddress("127.0.0.1", listener.port, "go1-v3.8"))
    try:
        time.sleep(6.0)  # without tick() nothing reads the output of the process
        before = listener.count
        wait_until(lambda: listener.count > before + 100)
    finally:
        begin = time.monotonic()
        robot.close()
    assert time.monotonic() - begin < 4.0
    assert robot._process.exitcode == 0
    assert listener.last_frame_damps()


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP, signal.SIGINT])
def test_control_process_damps_on_sigterm_and_ignores_sighup_and_sigint(number: int) -> None:
    listener = Listener()
    robot = UdpSession(describe_robot("go1"), RobotAddress("127.0.0.1", listener.port, "go1-v3.8"))
    try:
        wait_until(lambda: listener.count > 20)
        os.kill(robot._process.pid, number)
        if number == signal.SIGTERM:
            told = time.monotonic()
            robot._process.join(5.0)
            assert robot._process.exitcode == 0
            assert listener.last > told + 0.1  # it sent damping after the signal
            assert listener.last_frame_damps()
        else:  # a signal of the terminal: only the page stops the process
            before = listener.count
            wait_until(lambda: listener.count > before + 50)
    finally:
        robot.close()


def test_unexpected_callback_error_keeps_the_loop_alive(tmp_path: Path) -> None:
    complaints: list[str] = []
    loop = SessionThread(Simulation(describe_robot("go1")), complaints.append)
    loop.start()
    try:
        loop.post(lambda: 1 // 0)
        wait_until(lambda: len(complaints) > 0)
        assert "ZeroDivisionError" in complaints[0]
        assert loop.is_alive()
    finally:
        loop.stop()


@pytest.mark.parametrize("host", ["localhost", "127.0.0.1"])
def test_all_loopback_names_refuse_other_origins(host: str) -> None:
    from websockets.exceptions import InvalidStatus
    from websockets.sync.client import connect

    server = open_server(host, 0, "test")
    try:
        url = f"ws://127.0.0.1:{server.get_port()}"
        with pytest.raises(InvalidStatus, match="403"):
            connect(url, origin="http://evil.example")  # type: ignore[arg-type]
    finally:
        close_server(server)


def test_invalid_link_generation_raises_an_error() -> None:
    with pytest.raises(surefoot.Error, match="generation"):
        UdpSession(describe_robot("go1"), RobotAddress("127.0.0.1", 8007, "go1-v9"))


def test_pages_of_other_origins_are_refused() -> None:
    from websockets.exceptions import InvalidStatus
    from websockets.sync.client import connect

    server = open_server("127.0.0.1", 0, "test")
    try:
        url = f"ws://127.0.0.1:{server.get_port()}"
        own = f"http://127.0.0.1:{server.get_port()}"
        protocol = [f"viser-v{viser.__version__}"]
        connect(url, origin=own, subprotocols=protocol).close()
        with pytest.raises(InvalidStatus, match="403"):
            connect(url, origin="http://elsewhere.example", subprotocols=protocol)
    finally:
        close_server(server)


def test_server_binds_to_loopback_and_reports_a_port_in_use() -> None:
    server = open_server("127.0.0.1", 0, "test")
    try:
        port = server.get_port()
        assert server.get_host() == "127.0.0.1"
        with socket.create_connection(("127.0.0.1", port), timeout=5.0):
            pass
        with pytest.raises(OSError, match="in use"):
            open_server("127.0.0.1", port, "test")
    finally:
        close_server(server)
    with pytest.raises(surefoot.Error, match="expected an address of this machine"):
        open_server("192.0.2.1", 0, "test")
    with pytest.raises(surefoot.Error, match="65535"):
        open_server("127.0.0.1", 70000, "test")


@pytest.mark.parametrize(
    ("words", "status", "text"),
    [
        (("--gains", "nowhere.toml"), 2, "nowhere.toml"),
        (("--folder", "nowhere"), 2, "--folder: got 'nowhere'"),
        (("--robot", "go9"), 2, "go9"),
        (("--host", "127.0.0.1:x"), 2, "--host: got '127.0.0.1:x'"),
        (("--host", "127.0.0.1", "--power-level", "11"), 2, "--power-level: got 11"),
        (("--port", "-1"), 2, "--port: got -1"),
        (("--bind", "192.0.2.1"), 2, "expected an address of this machine"),
    ],
)
def test_invalid_tune_live_arguments_give_one_error_line(
    words: tuple[str, ...], status: int, text: str, capsys: pytest.CaptureFixture[str]
) -> None:
    port = () if "--port" in words else ("--port", "0")
    assert main(["tune", "live", *port, *words]) == status
    error = capsys.readouterr().err
    assert error.startswith("surefoot: error:") and text in error and error.count("\n") == 1


def test_tune_live_port_in_use_gives_one_error_line(capsys: pytest.CaptureFixture[str]) -> None:
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = taken.getsockname()[1]
        assert main(["tune", "live", "--port", str(port)]) == 1
    assert f"cannot listen on 127.0.0.1:{port}: it is in use" in capsys.readouterr().err


def test_tune_live_command_prints_its_address_and_ends_on_ctrl_c(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "surefoot.cli", "tune", "live", "--port", "0"]
    process = subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=tmp_path
    )
    assert process.stdout is not None
    line = process.stdout.readline()
    assert re.fullmatch(r"serving http://127\.0\.0\.1:\d+ \(go1\); Ctrl-C ends\n", line)
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=30)
    assert (process.returncode, out, err) == (0, "", "")

# SPDX-License-Identifier: BSD-3-Clause
"""Clients of a virtual robot: one without sockets and clock, one over UDP."""

from __future__ import annotations

import re
import signal
import socket
import subprocess
import sys
import threading
import time

import surefoot
from surefoot import protocol
from surefoot.virtual_robot import VirtualRobot, VirtualRobotSettings

CLIENT = ("client", 8090)
BLANK = bytes(614)


class MemoryPort:
    """A port in memory: the test fills its inbox and reads its outbox."""

    def __init__(self) -> None:
        self.inbox: list[tuple[bytes, tuple[str, int]]] = []
        self.outbox: list[tuple[bytes, tuple[str, int]]] = []

    def receive(self, limit: int) -> list[tuple[bytes, tuple[str, int]]]:
        taken, self.inbox = self.inbox[:limit], self.inbox[limit:]
        return taken

    def send(self, data: bytes, address: tuple[str, int]) -> bool:
        self.outbox.append((data, address))
        return True


class SteppedRobot:
    """A virtual robot that the test steps."""

    def __init__(self, robot: str = "go1", **settings) -> None:
        self.port = MemoryPort()
        self.lines: list[str] = []
        self.settings = VirtualRobotSettings(robot=robot, **settings)
        self.robot = VirtualRobot(self.settings, self.port, self.lines.append)

    def put_datagram(self, data: bytes, sender: tuple[str, int] = CLIENT) -> None:
        self.port.inbox.append((data, sender))

    def command(self, cmd: surefoot.LowCmd) -> None:
        self.put_datagram(protocol.encode_low_cmd(cmd, self.settings.generation))

    def run(self, seconds: float, cmd: surefoot.LowCmd | None = None) -> None:
        """Run for some seconds, with a command in every second cycle."""
        for k in range(round(seconds * self.settings.rate)):
            if cmd is not None and k % 2 == 0:
                self.command(cmd)
            self.robot.cycle()

    def states(self) -> list[protocol.ReceivedLowState]:
        """Return the LowStates sent since the last call."""
        frames, self.port.outbox = self.port.outbox, []
        return [protocol.decode_low_state(f, self.settings.generation) for f, _ in frames]


def servo(angles, kp: float = 20.0, kd: float = 1.0) -> surefoot.LowCmd:
    """Return a position-mode command with three angles, equal for all legs."""
    cmd = surefoot.LowCmd()
    for i in range(12):
        motor = cmd.motorCmd[i]
        motor.q, motor.dq, motor.Kp, motor.Kd = angles[i % 3], 0.0, kp, kd
    return cmd


class UdpClient:
    """A UDP client, as a small SDK program."""

    def __init__(self, port: int, generation: str = "go1-v3.8") -> None:
        self.generation = generation
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.connect(("127.0.0.1", port))
        self.socket.settimeout(5.0)

    def send(self, cmd: surefoot.LowCmd) -> None:
        self.socket.send(protocol.encode_low_cmd(cmd, self.generation))

    def receive(self) -> protocol.ReceivedLowState:
        return protocol.decode_low_state(self.socket.recv(2048), self.generation)

    def run(self, seconds: float, cmd: surefoot.LowCmd) -> list[protocol.ReceivedLowState]:
        """Send a command after every second sample for some seconds; return the samples."""
        states, end = [], time.monotonic() + seconds
        self.send(cmd)
        while time.monotonic() < end:
            states.append(self.receive())
            if len(states) % 2 == 0:
                self.send(cmd)
        return states


def start_robot(*words: str) -> tuple[subprocess.Popen[str], int]:
    """Start surefoot robot as a process; return it and its port, read from its first line."""
    command = [sys.executable, "-m", "surefoot.cli", "robot", "--port", "0", *words]
    process = subprocess.Popen(
        command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    assert process.stdout is not None
    found = re.match(r"listening on 127\.0\.0\.1:(\d+) as", process.stdout.readline())
    assert found, process.communicate(timeout=10)
    return process, int(found[1])


def start_controller(port: int, *words: str) -> subprocess.Popen[str]:
    """Start surefoot run as a process."""
    command = [sys.executable, "-m", "surefoot.cli", "run", "--port", str(port), *words]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def wait_for(process: subprocess.Popen[str], *words: str) -> str:
    """Read the output until a line has one of the words; kill the process after one minute."""
    assert process.stdout is not None
    watchdog = threading.Timer(60.0, process.kill)
    watchdog.start()
    try:
        while True:
            line = process.stdout.readline()
            if any(word in line for word in words):
                return line
            assert line, f"ended without {words}"
    finally:
        watchdog.cancel()


def arm_again(run: subprocess.Popen[str]) -> None:
    """Request arming of a damping controller until it stands: a late sample may refuse it."""
    for _ in range(10):
        run.send_signal(signal.SIGUSR1)
        if "not re-armed" not in (said := wait_for(run, " standing", "not re-armed")):
            return
        time.sleep(0.2)
    raise AssertionError(said)


def restore_sigint() -> None:
    """Restore SIGINT, for Popen(preexec_fn=...): background processes ignore it."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)

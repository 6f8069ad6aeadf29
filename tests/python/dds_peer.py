"""Peer of the DDS tests: a program with the vendor's Python classes, in an environment of its own.

Usage: dds_peer.py commander|robot DOMAIN SECONDS; prints one JSON object.
"""

from __future__ import annotations

import json
import sys
import time
from typing import Any

from unitree_sdk2py.core.channel import (
    ChannelFactoryInitialize,
    ChannelPublisher,
    ChannelSubscriber,
)
from unitree_sdk2py.idl.default import (
    unitree_go_msg_dds__LowCmd_,
    unitree_go_msg_dds__LowState_,
)
from unitree_sdk2py.idl.unitree_go.msg.dds_ import LowCmd_, LowState_
from unitree_sdk2py.utils.crc import CRC

TAU = 0.25  # [N.m] in every command
PERIOD = 0.004  # [s] between two messages


def command() -> Any:
    cmd = unitree_go_msg_dds__LowCmd_()
    cmd.head[0], cmd.head[1], cmd.level_flag = 0xFE, 0xEF, 0xFF
    for motor in cmd.motor_cmd:
        motor.mode, motor.q, motor.dq, motor.tau = 1, 2.146e9, 16000.0, TAU
    return cmd


def state() -> Any:
    message = unitree_go_msg_dds__LowState_()
    message.imu_state.quaternion[0] = 1.0
    for index, motor in enumerate(message.motor_state):
        motor.mode, motor.q, motor.temperature = 1, 0.1 * index, 30
    message.bms_state.soc = 80
    return message


def main() -> None:
    role, domain, seconds = sys.argv[1], int(sys.argv[2]), float(sys.argv[3])
    ChannelFactoryInitialize(domain, "lo")
    reads_states = role == "commander"
    sent, read = (LowCmd_, LowState_) if reads_states else (LowState_, LowCmd_)
    topics = ("rt/lowcmd", "rt/lowstate") if reads_states else ("rt/lowstate", "rt/lowcmd")
    received: list[Any] = []
    reader = ChannelSubscriber(topics[1], read)
    reader.Init(received.append, 10)
    writer = ChannelPublisher(topics[0], sent)
    writer.Init()
    crc, message = CRC(), command() if reads_states else state()
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if not reads_states:
            message.tick += 4
        message.crc = crc.Crc(message)
        writer.Write(message)
        time.sleep(PERIOD)
    messages = list(received)
    last = messages[-1] if messages else None
    result = {
        "received": len(messages),
        "wrong_crc": sum(crc.Crc(m) != m.crc for m in messages[-50:]),
        "payload": None if last is None else last.serialize()[4:].hex(),
        "modes": None if reads_states or last is None else [m.mode for m in last.motor_cmd],
    }
    print(json.dumps(result))


if __name__ == "__main__":
    main()

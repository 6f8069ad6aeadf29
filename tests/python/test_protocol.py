# SPDX-License-Identifier: BSD-3-Clause
"""The Python API of surefoot.protocol; the C++ tests check the frames."""

from __future__ import annotations

import numpy as np
import pytest
import surefoot
from surefoot import Error, protocol


@pytest.mark.parametrize("generation", protocol.GENERATIONS)
def test_decoded_frame_encodes_back_with_its_extras(generation: str) -> None:
    extras = protocol.FrameExtras()
    extras.robotID, extras.commVersion = 7, 9
    extras.led[:] = np.arange(12).reshape(4, 3)
    extras.cell_vol[:] = 32 * np.arange(20)
    for encode, decode, said in (
        (protocol.encode_low_cmd, protocol.decode_low_cmd, surefoot.LowCmd()),
        (protocol.encode_low_state, protocol.decode_low_state, surefoot.LowState()),
    ):
        frame = encode(said, generation, extras)
        assert encode(decode(frame, generation), generation) == frame
        assert decode(memoryview(frame), generation).crc == int.from_bytes(frame[-4:], "little")
    sizes = protocol.frame_sizes(generation)
    assert sizes == tuple(
        len(f)
        for f in (
            protocol.encode_low_cmd(surefoot.LowCmd(), generation),
            protocol.encode_low_state(surefoot.LowState(), generation),
        )
    )


def test_saturation_is_reported_and_never_wraps() -> None:
    cmd = surefoot.LowCmd()
    assert protocol.encode_low_cmd(cmd).saturated == ""
    cmd.motorCmd[4].tau = 128.0
    frame = protocol.encode_low_cmd(cmd, "go1-v3.8")
    assert "motor 4, tau" in frame.saturated
    assert 127.9 < protocol.decode_low_cmd(frame, "go1-v3.8").motorCmd[4].tau < 128.0


@pytest.mark.parametrize("bad", [None, "text", 5, [1, 2], np.zeros(614, np.uint8)])
def test_non_bytes_input_error_names_its_type(bad: object) -> None:
    with pytest.raises(Error, match=type(bad).__name__):
        protocol.decode_low_cmd(bad)  # type: ignore[arg-type]


def test_frame_generation_mismatch_names_both_generations() -> None:
    frame = protocol.encode_low_state(surefoot.LowState(), "go1-v3.4")
    with pytest.raises(Error, match=r"go1-v3\.4.*go1-v3\.8"):
        protocol.decode_low_state(frame, "go1-v3.8")


def test_remote_round_trips_through_bytes() -> None:
    remote = protocol.WirelessRemote()
    remote.press(protocol.Button.B)
    remote.lx, remote.ry = -0.5, 1.0
    back = protocol.WirelessRemote.from_bytes(remote.to_bytes())
    assert back.pressed(protocol.Button.B) and not back.pressed(protocol.Button.A)
    assert (back.lx, back.ry) == (-0.5, 1.0)
    garbage = bytes([0xFF] * 40)
    read = protocol.WirelessRemote.from_bytes(garbage)  # its stick values are not finite
    assert (read.lx, read.ly, read.rx, read.ry) == (0.0, 0.0, 0.0, 0.0)
    assert read.pressed(protocol.Button.B)  # B damps the robot, so it is read even from such bytes
    assert len(remote.to_bytes()) == 40


def test_default_generation_of_go2_raises_an_error() -> None:
    assert protocol.default_generation("b1") == "b1-v3.8"
    with pytest.raises(Error, match="choose a generation"):
        protocol.default_generation("go2")

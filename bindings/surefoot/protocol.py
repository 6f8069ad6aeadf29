"""UDP frames of unitree_legged_sdk: encoding and decoding of LowCmd and LowState.

A frame is shorter than its struct: it carries tau, Kp, Kd and tauEst as 16-bit fixed-point numbers.
There are four generations of SDK and robots, whose frames are not compatible. Real-time: no;
surefoot/frames.hpp does the same in C++ without allocation.

==========  =============================  ==============  ================
generation  robots, SDK releases           LowCmd [bytes]  LowState [bytes]
==========  =============================  ==============  ================
a1-v3.3     A1 v3.2 - v3.3.4, Aliengo      610             771
go1-v3.4    Go1 v3.3.2, 3.4.2              602             795
go1-v3.8    Go1 v3.5 - v3.8, branch go1    614             807
b1-v3.8     B1 v3.8.1, v3.8.3, branch B1   614             839
==========  =============================  ==============  ================
"""

from __future__ import annotations

from surefoot import _core
from surefoot._core import Button, Error, FrameExtras, LowCmd, LowState, WirelessRemote

Bytes = bytes | bytearray | memoryview

__all__ = [
    "GENERATIONS",
    "Button",
    "Frame",
    "FrameExtras",
    "ReceivedLowCmd",
    "ReceivedLowState",
    "WirelessRemote",
    "crc32",
    "decode_low_cmd",
    "decode_low_state",
    "default_generation",
    "encode_low_cmd",
    "encode_low_state",
    "frame_sizes",
]

GENERATIONS: tuple[str, ...] = tuple(_core._generations())

_DEFAULT_GENERATIONS = {"a1": "a1-v3.3", "go1": "go1-v3.8", "b1": "b1-v3.8"}


class Frame(bytes):
    """Bytes of one frame.

    Attributes:
        saturated: Text that names the values that were out of the frame's range and are now at its
            limit; "" if none.
    """

    saturated: str = ""


class ReceivedLowCmd(LowCmd):
    """LowCmd decoded from a frame.

    Attributes:
        extras: Fields of the generation that LowCmd lacks; encode_low_cmd() encodes them again.
    """

    def __init__(self) -> None:
        super().__init__()
        self.extras = FrameExtras()


class ReceivedLowState(LowState):
    """LowState decoded from a frame.

    Attributes:
        extras: Fields of the generation that LowState lacks; encode_low_state() encodes them again.
    """

    def __init__(self) -> None:
        super().__init__()
        self.extras = FrameExtras()


def encode_low_cmd(
    cmd: LowCmd, generation: str = "go1-v3.8", extras: FrameExtras | None = None
) -> Frame:
    """Encode a command as a frame with CRC.

    tau is truncated to multiples of 1/256 N.m (b1-v3.8: 1/128), Kp of 1/32, Kd of 1/16. Values out
    of range saturate, and Frame.saturated names them; the vendor's library wraps them instead
    (128 N.m becomes -128 N.m). cmd.crc is ignored.

    Args:
        cmd: The command.
        generation: One of GENERATIONS.
        extras: Fields of the generation that LowCmd lacks; None uses cmd.extras if cmd has them.

    Raises:
        Error: The generation is unknown, or a number is NaN or infinite; the message names it.
    """
    return _frame(*_core._encode_low_cmd(cmd, _extras_of(cmd, extras), generation))


def encode_low_state(
    state: LowState, generation: str = "go1-v3.8", extras: FrameExtras | None = None
) -> Frame:
    """Encode a LowState as a frame with CRC.

    Torques are truncated and values out of range saturate as in encode_low_cmd(). ddq has a
    resolution of 1 rad/s^2, cell voltages of 32 mV.

    Args:
        state: The LowState.
        generation: One of GENERATIONS.
        extras: Fields of the generation that LowState lacks; None uses state.extras if state has
            them.

    Raises:
        Error: The generation is unknown, or a number is NaN or infinite; the message names it.
    """
    return _frame(*_core._encode_low_state(state, _extras_of(state, extras), generation))


def decode_low_cmd(frame: Bytes, generation: str = "go1-v3.8") -> ReceivedLowCmd:
    """Decode the command in a frame.

    Args:
        frame: Bytes of one datagram.
        generation: One of GENERATIONS.

    Raises:
        Error: The generation is unknown; the frame is of another generation or length, is all
            zero, does not begin with FE EF (v3.8), is not low-level (v3.8), has a wrong CRC, or
            contains a number that is NaN or infinite. The message says which.
    """
    cmd = ReceivedLowCmd()
    _core._decode_low_cmd(_as_bytes(frame), generation, cmd, cmd.extras)
    return cmd


def decode_low_state(frame: Bytes, generation: str = "go1-v3.8") -> ReceivedLowState:
    """Decode the LowState in a frame.

    Args:
        frame: Bytes of one datagram.
        generation: One of GENERATIONS.

    Raises:
        Error: The same errors as in decode_low_cmd().
    """
    state = ReceivedLowState()
    _core._decode_low_state(_as_bytes(frame), generation, state, state.extras)
    return state


def frame_sizes(generation: str) -> tuple[int, int]:
    """Return the lengths of a LowCmd and a LowState frame [bytes].

    Raises:
        Error: The generation is unknown.
    """
    return _core._frame_sizes(generation)


def crc32(data: Bytes) -> int:
    """Return the CRC-32 of the frames, over all complete 32-bit words of `data`.

    Polynomial 0x04C11DB7, initial value 0xFFFFFFFF, no reflection, no final xor. Words are
    little-endian and are processed most significant bit first.
    """
    return _core._crc32(_as_bytes(data))


def default_generation(robot: str) -> str:
    """Return the generation of the newest UDP firmware of a robot.

    Raises:
        Error: The robot has no UDP frames (go2), or is unknown.
    """
    if robot in _DEFAULT_GENERATIONS:
        return _DEFAULT_GENERATIONS[robot]
    raise Error(
        f"robot '{robot}': has no known UDP frames (a Go2 uses DDS); choose a generation: "
        f"{', '.join(GENERATIONS)}"
    )


def _as_bytes(data: Bytes) -> bytes:
    if not isinstance(data, bytes | bytearray | memoryview):
        raise Error(f"frame: got {type(data).__name__}, expected bytes, bytearray or memoryview")
    return bytes(data)


def _extras_of(message: LowCmd | LowState, extras: FrameExtras | None) -> FrameExtras:
    if extras is not None:
        return extras
    if isinstance(message, ReceivedLowCmd | ReceivedLowState):
        return message.extras
    return FrameExtras()


def _frame(data: bytes, saturated: str) -> Frame:
    frame = Frame(data)
    frame.saturated = saturated
    return frame

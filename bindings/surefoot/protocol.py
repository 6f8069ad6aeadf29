"""Frames of unitree_legged_sdk as they travel: what UDP carries to and from the robot.

A frame is shorter than its struct: tau, Kp, Kd and tauEst travel as 16-bit fixed point. Four
generations of SDK and robots each have their own; none understands another. Not for the tick: in
C++ surefoot/frames.hpp does the same without allocating.

generation  robots, SDK releases               LowCmd  LowState
a1-v3.3     A1 v3.2 - v3.3.4, Aliengo             610       771
go1-v3.4    Go1 v3.3.2, 3.4.2                     602       795
go1-v3.8    Go1 v3.5 - v3.8, branch go1           614       807
b1-v3.8     B1 v3.8.1, v3.8.3, branch B1          614       839
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
    """The bytes of one frame.

    Attributes:
        saturated: What was out of the frame's range and put at its limit, in words; "" if nothing.
    """

    saturated: str = ""


class ReceivedLowCmd(LowCmd):
    """A LowCmd that came in a frame.

    Attributes:
        extras: What its generation carries beyond LowCmd; encode_low_cmd() takes it along.
    """

    def __init__(self) -> None:
        super().__init__()
        self.extras = FrameExtras()


class ReceivedLowState(LowState):
    """A LowState that came in a frame.

    Attributes:
        extras: What its generation carries beyond LowState; encode_low_state() takes it along.
    """

    def __init__(self) -> None:
        super().__init__()
        self.extras = FrameExtras()


def encode_low_cmd(
    cmd: LowCmd, generation: str = "go1-v3.8", extras: FrameExtras | None = None
) -> Frame:
    """Return a command as it travels, CRC included.

    tau is truncated to 1/256 N.m (b1-v3.8: 1/128), Kp to 1/32, Kd to 1/16. Where the vendor's
    library wraps (128 N.m becomes -128 N.m) values saturate, and Frame.saturated says so. cmd.crc
    is not looked at.

    Args:
        cmd: The command.
        generation: One of GENERATIONS.
        extras: What the generation carries beyond LowCmd; None takes cmd.extras if it has some.

    Raises:
        Error: An unknown generation; a number that is not finite, by name.
    """
    return _frame(*_core._encode_low_cmd(cmd, _extras_of(cmd, extras), generation))


def encode_low_state(
    state: LowState, generation: str = "go1-v3.8", extras: FrameExtras | None = None
) -> Frame:
    """Return a report as it travels, CRC included.

    As encode_low_cmd(); besides, ddq travels in whole rad/s^2 and cell voltages in 32 mV.
    """
    return _frame(*_core._encode_low_state(state, _extras_of(state, extras), generation))


def decode_low_cmd(frame: Bytes, generation: str = "go1-v3.8") -> ReceivedLowCmd:
    """Return the command in a frame.

    Args:
        frame: The bytes of one datagram.
        generation: One of GENERATIONS.

    Raises:
        Error: An unknown generation; a frame of another generation or of no known length; one that
            is all zero, begins with something else than FE EF (v3.8), is not low-level (v3.8), has
            a wrong CRC or a number that is not finite. The message says which.
    """
    cmd = ReceivedLowCmd()
    _core._decode_low_cmd(_as_bytes(frame), generation, cmd, cmd.extras)
    return cmd


def decode_low_state(frame: Bytes, generation: str = "go1-v3.8") -> ReceivedLowState:
    """Return the report in a frame; errors as decode_low_cmd()."""
    state = ReceivedLowState()
    _core._decode_low_state(_as_bytes(frame), generation, state, state.extras)
    return state


def frame_sizes(generation: str) -> tuple[int, int]:
    """Return the lengths of a LowCmd and a LowState frame [bytes]. Raises Error."""
    return _core._frame_sizes(generation)


def crc32(data: Bytes) -> int:
    """Return the wire's CRC-32 of all whole 32-bit words in data.

    Polynomial 0x04C11DB7, initial value 0xFFFFFFFF, nothing reflected, no final xor; the words are
    little-endian and enter most significant bit first.
    """
    return _core._crc32(_as_bytes(data))


def default_generation(robot: str) -> str:
    """Return the generation that a robot's newest UDP firmware speaks.

    Raises:
        Error: The robot does not speak UDP frames (go2), or is none we know: name a generation.
    """
    if robot in _DEFAULT_GENERATIONS:
        return _DEFAULT_GENERATIONS[robot]
    raise Error(
        f"robot '{robot}' has no UDP frames of its own that are known (a Go2 speaks DDS); name a "
        f"generation: {', '.join(GENERATIONS)}"
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

# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

import copy
import gc
import inspect
import struct
from operator import attrgetter

import numpy as np
import pytest
import surefoot
from surefoot import LowCmd, LowState

HEADER = {
    "head": (0, "2B"),
    "levelFlag": (2, "B"),
    "frameReserve": (3, "B"),
    "SN": (4, "2I"),
    "version": (12, "2I"),
    "bandWidth": (20, "H"),
}
LOW_STATE = HEADER | {
    "imu.quaternion": (22, "4f"),
    "imu.gyroscope": (38, "3f"),
    "imu.accelerometer": (50, "3f"),
    "imu.rpy": (62, "3f"),
    "imu.temperature": (74, "b"),
    "bms.version_h": (835, "B"),
    "bms.version_l": (836, "B"),
    "bms.bms_status": (837, "B"),
    "bms.SOC": (838, "B"),
    "bms.current": (839, "i"),
    "bms.cycle": (843, "H"),
    "bms.BQ_NTC": (845, "2b"),
    "bms.MCU_NTC": (847, "2b"),
    "bms.cell_vol": (849, "10H"),
    "footForce": (869, "4h"),
    "footForceEst": (877, "4h"),
    "tick": (885, "I"),
    "wirelessRemote": (889, "40B"),
    "reserve": (929, "I"),
    "crc": (933, "I"),
}
LOW_CMD = HEADER | {
    "bms.off": (682, "B"),
    "bms.reserve": (683, "3B"),
    "wirelessRemote": (686, "40B"),
    "reserve": (726, "I"),
    "crc": (730, "I"),
}
MOTOR_STATE = {
    "mode": (0, "B"),
    "q": (1, "f"),
    "dq": (5, "f"),
    "ddq": (9, "f"),
    "tauEst": (13, "f"),
    "q_raw": (17, "f"),
    "dq_raw": (21, "f"),
    "ddq_raw": (25, "f"),
    "temperature": (29, "b"),
    "reserve": (30, "2I"),
}
MOTOR_CMD = {
    "mode": (0, "B"),
    "q": (1, "f"),
    "dq": (5, "f"),
    "tau": (9, "f"),
    "Kp": (13, "f"),
    "Kd": (17, "f"),
    "reserve": (21, "3I"),
}
CASES = [(LowState, lambda s: s, *row) for row in LOW_STATE.items()]
CASES += [(LowCmd, lambda c: c, *row) for row in LOW_CMD.items()]
for slot in (0, 7, 19):
    for name, (offset, code) in MOTOR_STATE.items():
        place = (75 + 38 * slot + offset, code)
        CASES.append((LowState, lambda s, slot=slot: s.motorState[slot], name, place))
    for name, (offset, code) in MOTOR_CMD.items():
        place = (22 + 33 * slot + offset, code)
        CASES.append((LowCmd, lambda c, slot=slot: c.motorCmd[slot], name, place))


def sample(code: str):
    """Return values that differ from a field's default, and their packed bytes."""
    kind, count = code[-1], int(code[:-1] or 1)
    values = [-7.25 - k if kind == "f" else 17 + k for k in range(count)]
    return (np.array(values, dtype=kind) if count > 1 else values[0]), struct.pack(
        f"<{code}", *values
    )


@pytest.mark.parametrize(("frame", "size"), [(LowState, 937), (LowCmd, 734)])
def test_a_frame_has_the_size_of_the_sdks_struct(frame, size: int) -> None:
    assert len(frame().to_bytes()) == size
    assert frame().raw.shape == (size,)


@pytest.mark.parametrize(("frame", "find", "name", "place"), CASES)
def test_a_field_is_written_to_its_own_bytes_and_no_others(frame, find, name, place) -> None:
    start, code = place
    written = frame()
    value, packed = sample(code)
    *owner, field = name.split(".")
    setattr(attrgetter(*owner)(find(written)) if owner else find(written), field, value)
    expected = bytearray(frame().to_bytes())
    expected[start : start + len(packed)] = packed
    assert written.to_bytes() == bytes(expected)


@pytest.mark.parametrize(("frame", "find", "name", "place"), CASES)
def test_a_field_is_read_from_its_own_bytes(frame, find, name, place) -> None:
    start, code = place
    value, packed = sample(code)
    data = bytearray(frame().to_bytes())
    data[start : start + len(packed)] = packed
    read = attrgetter(name)(find(frame.from_bytes(bytes(data))))
    np.testing.assert_array_equal(read, value)


@pytest.mark.parametrize("frame", [LowState, LowCmd])
def test_any_bytes_survive_the_round_trip(frame) -> None:
    data = np.random.default_rng(3).bytes(len(frame().to_bytes()))
    assert frame.from_bytes(data).to_bytes() == data


@pytest.mark.parametrize(("frame", "size"), [(LowState, 937), (LowCmd, 734)])
@pytest.mark.parametrize("wrong", [-1, 1, -500])
def test_bytes_of_another_length_are_refused_with_both_lengths(frame, size, wrong) -> None:
    with pytest.raises(ValueError, match=f"got {size + wrong} bytes, expected {size}"):
        frame.from_bytes(bytes(size + wrong))


def test_writing_to_an_element_of_a_field_writes_to_the_frame() -> None:
    state = LowState()
    state.imu.quaternion[2] = 0.5
    state.footForceEst[3] = -12
    state.motorState[4].reserve[1] = 9
    again = LowState.from_bytes(state.to_bytes())
    np.testing.assert_array_equal(again.imu.quaternion, [0.0, 0.0, 0.5, 0.0])
    np.testing.assert_array_equal(again.footForceEst, [0, 0, 0, -12])
    np.testing.assert_array_equal(again.motorState[4].reserve, [0, 9])


def test_the_raw_view_is_the_frame_itself() -> None:
    state = LowState()
    state.raw[885:889] = [1, 2, 0, 0]
    assert state.tick == 513
    state.tick = 3
    np.testing.assert_array_equal(state.raw[885:889], [3, 0, 0, 0])


def test_a_view_keeps_its_frame_alive() -> None:
    views = [LowState().imu.quaternion for _ in range(50)]
    gc.collect()
    for k, view in enumerate(views):
        view[:] = k
    np.testing.assert_array_equal([view[3] for view in views], np.arange(50))


def test_an_array_of_another_length_is_refused() -> None:
    with pytest.raises(ValueError, match=r"IMU.quaternion: got shape \(3,\), expected \(4,\)"):
        LowState().imu.quaternion = np.zeros(3, dtype=np.float32)


@pytest.mark.parametrize("duplicate", [copy.copy, copy.deepcopy])
def test_a_copy_is_another_frame(duplicate) -> None:
    state = LowState()
    twin = duplicate(state)
    twin.imu.quaternion[0] = 1.0
    twin.tick = 5
    assert (state.tick, state.imu.quaternion[0]) == (0, 0.0)


@pytest.mark.parametrize("row", [LowState().motorState, LowCmd().motorCmd])
def test_there_are_twenty_motor_slots_and_no_more(row) -> None:
    assert len(row) == 20
    row[19].q, row[0].q = 19.0, 1.0
    assert (row[-1].q, row[-20].q) == (19.0, 1.0)
    for outside in (20, -21):
        with pytest.raises(IndexError, match=r"0 \.\. 19"):
            row[outside]


def test_motor_numbers_run_fr_fl_rr_rl_by_hip_thigh_calf() -> None:
    names = [f"{leg}_{k}" for leg in ("FR", "FL", "RR", "RL") for k in range(3)]
    assert [getattr(surefoot, name) for name in names] == list(range(12))


def test_stop_values_match_the_sdk() -> None:
    assert surefoot.PosStopF == 2.146e9
    assert surefoot.VelStopF == 16000.0
    assert surefoot.LOWLEVEL == 0xFF


def packed_command(motors: list[bytes]) -> bytes:
    return bytes([0xFE, 0xEF, 0xFF]).ljust(22, b"\0") + b"".join(motors).ljust(712, b"\0")


def packed_motor(dq: float = 16000.0, kd: float = 0.0) -> bytes:
    return struct.pack("<B5f3I", 0x0A, 2.146e9, dq, 0.0, 0.0, kd, 0, 0, 0)


def test_default_low_cmd_equals_the_sdk_init_cmd_data() -> None:
    assert LowCmd().to_bytes() == packed_command([packed_motor()] * 20)


def test_damping_command_brakes_only_the_twelve_motors() -> None:
    expected = packed_command([packed_motor(dq=0.0, kd=2.5)] * 12 + [packed_motor()] * 8)
    assert surefoot.damping_low_cmd(2.5).to_bytes() == expected


def test_a_default_low_state_is_an_empty_low_level_frame() -> None:
    assert LowState().to_bytes() == bytes([0xFE, 0xEF, 0xFF]).ljust(937, b"\0")


NAMED = {name: getattr(surefoot, name) for name in surefoot.__all__}
DOCUMENTED = {name: thing for name, thing in NAMED.items() if callable(thing)}
for owner_name, owner in list(DOCUMENTED.items()):
    if inspect.isclass(owner):
        for name in vars(owner):
            if not name.startswith("_"):
                DOCUMENTED[f"{owner_name}.{name}"] = inspect.getattr_static(owner, name)


def docstring_of(name: str) -> str:
    """Return a docstring without the signature line that nanobind adds."""
    text = inspect.getdoc(DOCUMENTED[name]) or ""
    head, _, tail = text.partition("\n")
    return tail if head.startswith(f"{name.split('.')[-1]}(") else text


@pytest.mark.parametrize("name", DOCUMENTED)
def test_every_public_name_has_a_docstring(name: str) -> None:
    assert len(docstring_of(name).strip()) >= 4


def test_every_name_of_the_core_is_exported() -> None:
    core = {name for name in vars(surefoot._core) if not name.startswith("_")}
    assert core <= set(surefoot.__all__)
    assert {"LowState", "LowCmd", "StandController", "load_robot", "Error"} <= set(surefoot.__all__)


USED = [f"MotorState.{name}" for name in ("q", "dq", "tauEst", "temperature")]
USED += [f"IMU.{name}" for name in ("quaternion", "gyroscope", "accelerometer")]
USED += ["LowState.footForceEst", "LowState.tick"]
UNUSED = [f"MotorState.{name}" for name in ("ddq", "q_raw", "dq_raw", "ddq_raw")]
UNUSED += ["IMU.rpy", "IMU.temperature"]


def test_docstrings_mark_used_and_unused_fields() -> None:
    assert [name for name in USED if "Read by" not in docstring_of(name)] == []
    assert [name for name in UNUSED if "does not read this field" not in docstring_of(name)] == []
    assert "joint-side" in docstring_of("MotorState")
    assert "joint-side" in docstring_of("MotorCmd")

"""Recorder of a controller's sensor input, as a log for surefoot estimate."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from surefoot._core import LowState
from surefoot.geometry.batch_rotations import matrices_from_xyzw
from surefoot.messages.low_state_layout import LOW_STATE
from surefoot.sensor_log.clock import read_clock
from surefoot.sensor_log.columns_from_low_states import sensor_columns
from surefoot.sensor_log.sensor_log import SensorLog
from surefoot.sim import Truth


class SensorRecorder:
    """Recorder of every LowState that a controller receives, with the true state of the plant.

    Row k has the k-th LowState and the true state at the time when the sensors were sampled. With
    real sensors this is one control period before the controller receives the LowState.
    """

    def __init__(self) -> None:
        self._states: list[bytes] = []
        self._truths: list[Truth] = []

    def record(self, state: LowState, truth: Truth) -> None:
        """Append a LowState and the true state at its sampling time as one row."""
        self._states.append(state.to_bytes())
        self._truths.append(truth)

    @property
    def low_states(self) -> npt.NDArray[np.uint8]:
        """(n, 937) bytes of the LowStates recorded so far."""
        return np.frombuffer(b"".join(self._states), dtype=np.uint8).reshape(-1, LOW_STATE.itemsize)

    def log(self, source: str = "surefoot stand") -> SensorLog:
        """Return the recorded rows as a log: unrounded sensor columns and ``truth_...`` columns.

        Args:
            source: Name of the log in messages.

        Raises:
            Error: The clock of the LowStates is constant, goes backwards, or has a wrong unit.
        """
        columns = sensor_columns(self.low_states)
        columns.update(self._truth_columns())
        clock, time = read_clock(source, columns)
        return SensorLog(source, columns, time, clock)

    def _truth_columns(self) -> dict[str, np.ndarray]:
        q = np.array([truth.q[:7] for truth in self._truths])
        v = np.array([truth.v[:3] for truth in self._truths])
        forces = np.array([truth.foot_forces for truth in self._truths])
        return {
            "truth_p": q[:, :3],
            "truth_quaternion": q[:, [6, 3, 4, 5]],
            "truth_v": np.einsum("nij,nj->ni", matrices_from_xyzw(q[:, 3:7]), v),
            "truth_foot_forces": np.swapaxes(forces, 1, 2).reshape(-1, 12),
            "truth_contact": np.array([t.contact for t in self._truths]).astype(np.float64),
            "truth_com": np.array([truth.com for truth in self._truths]),
        }

"""The last ticks of a run in a file that surefoot estimate reads."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from surefoot._core import Error, FaultId, Mode, RunLog
from surefoot.cli.simulation import check_place
from surefoot.estimate import SensorLog, write_log
from surefoot.estimate.columns import RUN
from surefoot.estimate.sensor_columns import sensor_columns
from surefoot.low_cmd_layout import LOW_CMD
from surefoot.low_state_layout import MOTORS


def check_log_place(place: str | None) -> None:
    """Raise Error for a place where no NPZ file can be written; None is none."""
    check_place("--log", place)
    if place is not None and Path(place).suffix.lower() != ".npz":
        raise Error(f"--log: got '{place}', expected a name that ends in .npz")


def write_run_log(path: str, log: RunLog) -> None:
    """Write what a runner knew and sent, tick by tick; raises OSError.

    The columns are a sensor log's; arrays run_... say the rest (docs/estimation.md).
    """
    reports, commands = log.reports, log.commands
    extras = {
        "time": log.time,
        "heard": log.heard,
        "mode": _names(Mode, log.mode),
        "damping": _names(FaultId, log.damping),
        "tau": commands.view(LOW_CMD)[:, 0]["motorCmd"]["tau"][:, :MOTORS],
        "reports": reports,
        "commands": commands,
    }
    sensors = SensorLog("surefoot run", sensor_columns(reports), log.time)
    write_log(path, sensors, {f"{RUN}{name}": values for name, values in extras.items()})


def _names(kind: type[Mode] | type[FaultId], values: np.ndarray) -> np.ndarray:
    names = {member.value: name.lower() for name, member in kind.__members__.items()}
    return np.array([names[value] for value in values.tolist()])

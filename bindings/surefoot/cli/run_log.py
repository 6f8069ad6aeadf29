"""Log of the last ticks of a run, in the format of surefoot estimate."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from surefoot._core import Error, FaultId, Gait, Mode, RunLog
from surefoot.cli.output_files import check_output_path
from surefoot.estimate import SensorLog, write_log
from surefoot.messages.low_cmd_layout import LOW_CMD
from surefoot.messages.low_state_layout import MOTOR_COUNT
from surefoot.sensor_log.column_definitions import RUN_PREFIX
from surefoot.sensor_log.columns_from_low_states import sensor_columns

# [s] Default of --log-time, the duration that the log covers. Chosen: it includes what led to a
# fault, and bounds the memory.
LOG_TIME = 60.0


def check_log(path: str | None, time: float | None) -> None:
    """Raise Error unless --log is a .npz file that can be written and --log-time is above 0."""
    if path is None and time is not None:
        raise Error("--log-time: got no --log, expected both")
    if time is not None and not time > 0.0:
        raise Error(f"--log-time: got {time:g}, expected above 0, up to 600 [s]")
    check_output_path("--log", path)
    if path is not None and Path(path).suffix.lower() != ".npz":
        raise Error(f"--log: got '{path}', expected a name ending in .npz")


def write_run_log(path: str, log: RunLog) -> float:
    """Write the samples and commands of a run as a sensor log.

    The file has the columns of a sensor log, and arrays whose names begin with ``run_``.

    Returns:
        Duration [s] that the log covers.

    Raises:
        OSError: The file could not be written.
    """
    time, low_states, commands = log.time, log.samples, log.commands
    extras = {
        "time": time,
        "heard": log.has_new_state,
        "mode": _enum_names(Mode, log.mode),
        "velocity": log.velocity,
        "gait": _enum_names(Gait, log.gait),
        "damping": _enum_names(FaultId, log.damping_fault),
        "tau": commands.view(LOW_CMD)[:, 0]["motorCmd"]["tau"][:, :MOTOR_COUNT],
        "reports": low_states,
        "commands": commands,
    }
    elapsed = time - time[0]
    columns = sensor_columns(low_states) | {"time": elapsed[:, None]}
    if _restarted(columns["tick"][:, 0]):  # the robot's clock restarted, so use the host's clock
        del columns["tick"]
    sensors = SensorLog("surefoot run", columns, elapsed, clock="time")
    write_log(path, sensors, {f"{RUN_PREFIX}{name}": values for name, values in extras.items()})
    return float(elapsed[-1])


def _restarted(ticks: np.ndarray) -> bool:
    """Return whether the robot's clock [ms] ran backwards; a wrap at 2^32 does not count."""
    return bool((np.diff(ticks.astype(np.uint32)).astype(np.int32) < 0).any())


def _enum_names(kind: type[Mode] | type[FaultId] | type[Gait], values: np.ndarray) -> np.ndarray:
    names = {member.value: name.lower() for name, member in kind.__members__.items()}
    return np.array([names[value] for value in values.tolist()])

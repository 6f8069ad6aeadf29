"""Run the C++ executable that times ticks.

The executable contains no Python. So the tick causes all heap allocations and page faults that the
executable counts.
"""

from __future__ import annotations

import json
import math
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

import surefoot
from surefoot._core import BodyReference, Error, QpForm, WalkVelocity
from surefoot.bench.recording import Recording

PROGRAM = Path(surefoot.__path__[0]) / "bin" / "surefoot_tick_bench"
# Layout of the C++ struct bench::CallTiming.
_CALL_TIMING = np.dtype([("wall", "<f4"), ("cpu", "<f4"), ("iterations", "<u2"), ("failed", "<u2")])


@dataclass(frozen=True)
class Series:
    """Timings of one kind of call.

    Attributes:
        wall: (n,) wall time [us].
        cpu: (n,) CPU time of the thread [us]; None where only the wall clock was read.
        iterations: (n,) iterations of the solver.
        failures: Number of failed calls: the controller used another fallback level than SOLVED, or
            WholeBodyController had no usable status.
        walking: Number of calls in which the robot stepped.
        allocations: Number of heap allocations in all calls.
        page_faults: Number of page faults in all calls.
        first_allocations: Number of heap allocations in the first pass, which is not timed.
        first_page_faults: Number of page faults in the first pass.
    """

    wall: npt.NDArray[np.float32]
    cpu: npt.NDArray[np.float32] | None
    iterations: npt.NDArray[np.uint16]
    failures: int
    walking: int
    allocations: int
    page_faults: int
    first_allocations: int
    first_page_faults: int


def run_tick_program(
    recording: Recording, form: QpForm, ticks: int
) -> tuple[dict[str, Series], dict[str, Any]]:
    """Time a recording; return the series by name, and two facts about the executable.

    "build" is the compiler and the flags of the library. "memory_locked" is true if the system
    allowed mlockall(). If it is false, the first pass has page faults, which map the memory.

    Raises:
        Error: The executable is missing, or it failed; the message has its error text.
    """
    passes = math.ceil(ticks / len(recording.low_states))
    with tempfile.TemporaryDirectory() as folder:
        robot, low_states, out = (Path(folder) / name for name in ("robot", "reports", "out"))
        recording.robot.save(str(robot))
        low_states.write_bytes(b"".join(state.to_bytes() for state in recording.low_states))
        arguments: list[str | Path] = [robot, low_states, out]
        arguments += ["--form", form.name.lower(), "--passes", str(passes)]
        arguments += ["--period-us", str(round(1e6 * recording.period))]
        if recording.references:
            references = Path(folder) / "references"
            np.array([_reference_row(r) for r in recording.references]).tofile(references)
            arguments += ["--references", references]
        if recording.velocities:
            velocities = Path(folder) / "velocities"
            np.array([_velocity_row(v) for v in recording.velocities]).tofile(velocities)
            arguments += ["--velocities", velocities, "--gait", recording.gait.name.lower()]
        try:
            process = subprocess.run([PROGRAM, *arguments], capture_output=True, text=True)
        except OSError as problem:
            raise Error(f"bench: {PROGRAM}: {problem.strerror}") from None
        if process.returncode != 0:
            raise Error(
                f"bench: {PROGRAM.name} ended with status {process.returncode}: "
                f"{process.stderr.strip()}"
            )
        return _read_output(out)


def _reference_row(r: BodyReference) -> list[float]:
    return [r.x, r.y, r.height, r.roll, r.pitch, r.yaw]  # order in the executable's input


def _velocity_row(v: WalkVelocity) -> list[float]:
    return [v.vx, v.vy, v.yaw_rate]  # order in the executable's input


def _read_output(path: Path) -> tuple[dict[str, Series], dict[str, Any]]:
    with path.open("rb") as file:
        header = json.loads(file.readline())
        found = {
            entry["name"]: _series(entry, np.fromfile(file, _CALL_TIMING, entry["n"]))
            for entry in header["series"]
        }
    build = f"{header['compiler']}, {' '.join(header['flags'].split())}"
    return found, {"build": build, "memory_locked": header["memory_locked"]}


def _series(entry: dict[str, Any], samples: npt.NDArray[Any]) -> Series:
    return Series(
        samples["wall"],
        samples["cpu"] if entry["cpu"] else None,
        samples["iterations"],
        int(samples["failed"].sum()),
        entry["walking"],
        entry["allocations"],
        entry["page_faults"],
        entry["first_allocations"],
        entry["first_page_faults"],
    )

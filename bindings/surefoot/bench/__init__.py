"""The bench: how long a tick takes on this machine, on what a robot's sensors said."""

from surefoot.bench.recording import Recording, record
from surefoot.bench.report import write_bench_report
from surefoot.bench.run import run_bench
from surefoot.bench.settings import BenchSettings
from surefoot.bench.text import bench_text

__all__ = [
    "BenchSettings",
    "Recording",
    "bench_text",
    "record",
    "run_bench",
    "write_bench_report",
]

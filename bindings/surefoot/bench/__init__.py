"""Benchmark of the tick time of the controller on this machine, on recorded LowStates."""

from surefoot.bench.recording import Recording, record
from surefoot.bench.report import write_bench_report
from surefoot.bench.result_text import bench_text
from surefoot.bench.run import run_bench
from surefoot.bench.settings import BenchSettings

__all__ = [
    "BenchSettings",
    "Recording",
    "bench_text",
    "record",
    "run_bench",
    "write_bench_report",
]

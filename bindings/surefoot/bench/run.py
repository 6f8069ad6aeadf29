"""Run of a benchmark: record the scenarios, time them, and collect the figures."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from surefoot.bench.recording import Recording, record
from surefoot.bench.settings import BenchSettings
from surefoot.bench.tick_program import Series, run_tick_program
from surefoot.bench.timing_statistics import series_statistics
from surefoot.system.machine import describe_machine

WHOLE_CALLS = ("tick", "state_to_torque", "null")
STANDING = "quiet"  # scenario to whose tick the ticks of the others are compared
PACED = "paced"
_NO_PEERS_REASON = "not requested: use --peers"


@dataclass(frozen=True)
class Bench:
    """Results of a benchmark.

    Attributes:
        figures: All figures as JSON values.
        series: Durations of all calls, by scenario and name of the call.
        recordings: Recorded runs, by scenario.
    """

    figures: dict[str, Any]
    series: dict[str, dict[str, Series]]
    recordings: dict[str, Recording]


def run_bench(settings: BenchSettings, progress: Callable[[str], None] | None = None) -> Bench:
    """Record every scenario, time its replay and return all figures.

    Args:
        settings: Settings of the benchmark.
        progress: Called with one line of text before each step.

    Raises:
        Error: A setting is invalid, or the tick program failed.
    """
    say = progress or (lambda _: None)
    all_series, recordings = {}, {}
    program: dict[str, Any] = {}
    for scenario in settings.scenarios:
        say(f"recording {scenario}")
        recordings[scenario] = record(settings, scenario)
        say(f"timing {scenario}")
        all_series[scenario], program = run_tick_program(
            recordings[scenario], settings.form, settings.ticks
        )
    first = next(iter(recordings.values()))
    scenarios = {
        name: _scenario_summary(recordings[name], series) for name, series in all_series.items()
    }
    _add_ratios(scenarios)
    figures = {
        "robot": first.robot.name,
        "form": settings.form.name.lower(),
        "rate": settings.rate,
        "seed": settings.seed,
        "scenarios": scenarios,
        **{f"ratio_{name}": None for name in RATIOS},
        "ratio_reason": _NO_PEERS_REASON,
        "machine": {**describe_machine(), **program},
    }
    return Bench(figures, all_series, recordings)


RATIOS = ("state_to_torque_over_tsid", "tick_over_tsid", "state_to_torque_over_placo")


def _scenario_summary(recording: Recording, series: dict[str, Series]) -> dict[str, Any]:
    tick_count = len(recording.low_states)
    stages = {
        k: _stage_summary(s, tick_count)
        for k, s in series.items()
        if k not in (*WHOLE_CALLS, PACED)
    }
    return {
        "reports": tick_count,
        "fell": recording.fell,
        **{name: series_statistics(series[name], tick_count) for name in WHOLE_CALLS},
        PACED: series_statistics(series[PACED], len(series[PACED].wall)),
        "stages_wall_us": stages,
    }


def _add_ratios(scenarios: dict[str, Any]) -> None:
    """Add the ratio of the median CPU time of a tick to that of the scenario STANDING."""
    standing = scenarios.get(STANDING)
    for scenario in scenarios.values():
        p50 = scenario["tick"]["cpu_us"]["p50"]
        ratio = None if standing is None else p50 / standing["tick"]["cpu_us"]["p50"]
        scenario[f"tick_over_{STANDING}"] = ratio


def _stage_summary(series: Series, tick_count: int) -> dict[str, float]:
    figures = series_statistics(series, tick_count)
    return {**figures["wall_us"], "slowest": figures["slowest_us"]}

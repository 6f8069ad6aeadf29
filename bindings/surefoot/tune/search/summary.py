"""A search in numbers, and in words."""

from __future__ import annotations

from typing import Any

from optuna.trial import FrozenTrial

from surefoot.gain_files import changed_gains, gain_values
from surefoot.plain import plain
from surefoot.tune.cost import TERMS
from surefoot.tune.search.run import Candidate, SearchResult
from surefoot.tune.search.space import apply


def summarise(result: SearchResult) -> dict[str, Any]:
    """Return everything as plain JSON types; costs are lower where better."""
    settings, trials = result.settings, result.trials
    two = len(settings.objectives) == 2
    summary = {
        "robot": settings.robot if isinstance(settings.robot, str) else list(settings.robot),
        "objective": list(settings.objectives),
        "trials": len(trials),
        "failures": sum(1 for trial in trials if _failed(trial)),
        "stopped_early": sum(1 for trial in trials if trial.user_attrs.get("stopped")),
        "start": _costs(result.start.searched),
        "best": _costs(result.best.searched),
        "start_on_held_seeds": _costs(result.start.held.costs),
        "own_on_held_seeds": _costs(result.own.held.costs),
        "best_on_held_seeds": _costs(result.best.held.costs),
        "held_seeds": settings.held_out,
        "falls_on_held_seeds": result.best.held.falls,
        "terms_on_held_seeds": {
            "start": result.start.held.terms,
            "own": result.own.held.terms,
            "best": result.best.held.terms,
        },
        "parameters": {p.name: p.get(result.best.gains) for p in settings.space},
        "gains": gain_values(result.best.gains),
        "gains_changed": changed_gains(result.best.gains, result.own.gains),
        "importance": result.importance,
        "rollouts": result.speed,
        "front": [_on_front(result, trial) for trial in result.front] if two else None,
    }
    exact = ("gains", "gains_changed", "front")
    return {name: value if name in exact else plain(value) for name, value in summary.items()}


def summary_text(s: dict[str, Any]) -> str:
    """Return a summary for people."""
    lines = [
        f"{s['robot']}: {s['trials']} trials, {s['failures']} with a fall or worse, "
        f"{s['stopped_early']} stopped early",
        f"{'cost (lower is better)':<26}{'searched':>16}{s['held_seeds']:>10} other seeds",
    ]
    for name, text in (("start", "start"), ("own", "the robot's own"), ("best", "best")):
        searched = _shown(s[name]) if name in s else "-"
        lines.append(f"  {text:<24}{searched:>16}{_shown(s[name + '_on_held_seeds']):>22}")
    lines.append("  best: " + ", ".join(f"{k} {v:.3g}" for k, v in s["parameters"].items()))
    if s["rollouts"]:
        speed = s["rollouts"]
        lines.append(
            f"  rollouts: {speed['real_time_factor_per_core']:.0f} x real time a core, "
            f"{speed['real_time_factor']:.0f} x with {speed['workers']} workers; "
            f"{speed['ticks_per_cpu_s']:.0f} ticks, {speed['physics_steps_per_cpu_s']:.0f} physics "
            "steps per second of CPU"
        )
    return "\n".join(lines)


def origin(s: dict[str, Any], command: str) -> str:
    """Return where gains come from, for the head of their file."""
    return (
        f"Made by: {command}\n"
        f"Cost {_shown(s['best'])} (start {_shown(s['start'])}); on {s['held_seeds']} seeds that "
        f"were not searched with {_shown(s['best_on_held_seeds'])} (start "
        f"{_shown(s['start_on_held_seeds'])}, the robot's own {_shown(s['own_on_held_seeds'])})."
    )


def term_lines(candidate: Candidate) -> list[str]:
    """Return a candidate's terms on held-out seeds, one a line."""
    terms = candidate.held.terms
    return [f"{name} {terms[name]:.2f}: {text}" for name, text in TERMS.items() if name in terms]


def _failed(trial: FrozenTrial) -> bool:
    return bool(trial.user_attrs.get("falls") or trial.user_attrs.get("broken"))


def _costs(costs: tuple[float, ...]) -> float | list[float] | None:
    if not costs:
        return None
    return costs[0] if len(costs) == 1 else list(costs)


def _shown(cost: float | list[float] | None) -> str:
    if cost is None:
        return "-"
    costs = cost if isinstance(cost, list) else [cost]
    return " / ".join(f"{value:.2f}" for value in costs)


def _on_front(result: SearchResult, trial: FrozenTrial) -> dict[str, Any]:
    gains = apply(trial.params, result.settings.start)
    return {"trial": trial.number, "costs": list(trial.values), "gains": gain_values(gains)}

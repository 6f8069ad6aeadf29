"""Summary of a search, as JSON values and as text."""

from __future__ import annotations

from typing import Any

from optuna.trial import FrozenTrial

from surefoot.files.json_values import json_value
from surefoot.robot.gain_files import changed_gains, gain_values
from surefoot.tune.cost import TERMS
from surefoot.tune.search.run import SearchResult
from surefoot.tune.search.space import apply_parameters
from surefoot.tune.walk_cost import WALK_TERMS


def summarise(result: SearchResult) -> dict[str, Any]:
    """Return the result of a search as JSON values; lower costs are better."""
    settings, trials = result.settings, result.trials
    two = len(settings.objectives) == 2
    summary = {
        "robot": settings.robot if isinstance(settings.robot, str) else list(settings.robot),
        "walk": settings.walk,
        "objective": list(settings.objectives),
        "trials": len(trials),
        "failures": sum(1 for trial in trials if _failed(trial)),
        "stopped_early": sum(1 for trial in trials if trial.user_attrs.get("stopped")),
        "start": _costs(result.start.search_costs),
        "best": _costs(result.best.search_costs),
        "start_on_held_seeds": _costs(result.start.held_out.costs),
        "own_on_held_seeds": _costs(result.own.held_out.costs),
        "best_on_held_seeds": _costs(result.best.held_out.costs),
        "held_seeds": settings.held_out,
        "falls_on_held_seeds": result.best.held_out.falls,
        "terms_on_held_seeds": {
            "start": result.start.held_out.terms,
            "own": result.own.held_out.terms,
            "best": result.best.held_out.terms,
        },
        "parameters": {p.name: p.get(result.best.gains) for p in settings.space},
        "gains": gain_values(result.best.gains),
        "gains_changed": changed_gains(result.best.gains, result.own.gains),
        "importance": result.importance,
        "rollouts": result.speed,
        "front": [_front_entry(result, trial) for trial in result.front] if two else None,
    }
    exact = ("gains", "gains_changed", "front")
    return {name: value if name in exact else json_value(value) for name, value in summary.items()}


def summary_text(s: dict[str, Any]) -> str:
    """Return the result of summarise() as text."""
    lines = [
        f"{s['robot']}: {s['trials']} trials, {s['failures']} with a fall or broken, "
        f"{s['stopped_early']} stopped early",
        f"{'cost (lower is better)':<26}{'search':>16}{s['held_seeds']:>8} held-out seeds",
    ]
    for name, text in (("start", "start"), ("own", "the robot's own"), ("best", "best")):
        search_costs = _cost_text(s[name]) if name in s else "-"
        lines.append(f"  {text:<24}{search_costs:>16}{_cost_text(s[name + '_on_held_seeds']):>22}")
    lines.append("  best: " + ", ".join(f"{k} {v:.3g}" for k, v in s["parameters"].items()))
    if s["rollouts"]:
        speed = s["rollouts"]
        lines.append(
            f"  rollouts: {speed['real_time_factor_per_core']:.0f} x real time per core, "
            f"{speed['real_time_factor']:.0f} x with {speed['workers']} workers; "
            f"{speed['ticks_per_cpu_s']:.0f} ticks, {speed['physics_steps_per_cpu_s']:.0f} physics "
            "steps per second of CPU"
        )
    return "\n".join(lines)


def gains_provenance(s: dict[str, Any], command: str) -> str:
    """Return the origin of the gains as text, for the header of their file."""
    return (
        f"Made by: {command}\n"
        f"Cost {_cost_text(s['best'])} (start {_cost_text(s['start'])}); on {s['held_seeds']} "
        f"held-out seeds {_cost_text(s['best_on_held_seeds'])} (start "
        f"{_cost_text(s['start_on_held_seeds'])}, the robot's own "
        f"{_cost_text(s['own_on_held_seeds'])})."
    )


def term_lines(result: SearchResult) -> list[str]:
    """Return the cost terms of the best gains on held-out seeds, one per line."""
    terms = result.best.held_out.terms
    definitions = WALK_TERMS if result.settings.walk else TERMS
    return [f"{name} {terms[name]:.2f}: {text}" for name, text in definitions.items()]


def _failed(trial: FrozenTrial) -> bool:
    return bool(trial.user_attrs.get("falls") or trial.user_attrs.get("broken"))


def _costs(costs: tuple[float, ...]) -> float | list[float] | None:
    if not costs:
        return None
    return costs[0] if len(costs) == 1 else list(costs)


def _cost_text(cost: float | list[float] | None) -> str:
    if cost is None:
        return "-"
    costs = cost if isinstance(cost, list) else [cost]
    return " / ".join(f"{value:.2f}" for value in costs)


def _front_entry(result: SearchResult, trial: FrozenTrial) -> dict[str, Any]:
    gains = apply_parameters(trial.params, result.settings.start)
    return {"trial": trial.number, "costs": list(trial.values), "gains": gain_values(gains)}

"""Sampler, ranking of trials and parameter importance, with Optuna."""

from __future__ import annotations

from collections.abc import Sequence

import optuna
from optuna.samplers import BaseSampler, CmaEsSampler, NSGAIISampler, RandomSampler, TPESampler
from optuna.trial import FrozenTrial

from surefoot.tune.search.settings import SearchSettings

# Chosen: two steps reach the ends of the range from its middle (docs/how-to/tune-with-a-search.md).
INITIAL_SIGMA = 0.25  # initial step size of CMA-ES as a share of the logarithmic range
# Chosen: ten generations in the default of 200 trials.
POPULATION_SIZE = 20  # population of NSGA-II
# Smallest number of trials for importance(). Chosen: with fewer trials, the result is mostly noise.
MIN_TRIALS = 20


def make_sampler(settings: SearchSettings, done: int) -> BaseSampler:
    """Return the sampler of a search.

    Args:
        settings: Settings of the search.
        done: Number of trials in the study. It changes the seed, so that a resumed search does not
            draw the same numbers again.
    """
    kind = settings.sampler or ("cmaes" if len(settings.objectives) == 1 else "nsga2")
    seed = settings.seed + done
    if kind == "cmaes":
        x0 = {p.name: p.get(settings.start) for p in settings.space}
        return CmaEsSampler(x0=x0, sigma0=INITIAL_SIGMA, seed=seed)
    if kind == "tpe":
        return TPESampler(seed=seed, multivariate=True, constant_liar=True)
    if kind == "nsga2":
        return NSGAIISampler(population_size=POPULATION_SIZE, seed=seed)
    return RandomSampler(seed=seed)


def relative_cost(costs: Sequence[float], start: tuple[float, ...]) -> float:
    """Return the sum of cost / cost of the start gains over the objectives, to rank trials."""
    return sum(cost / max(start_cost, 1e-9) for cost, start_cost in zip(costs, start, strict=True))


def rank_trials(trials: list[FrozenTrial], start: tuple[float, ...]) -> list[FrozenTrial]:
    """Return the trials in order of relative cost, lowest first."""
    return sorted(trials, key=lambda trial: relative_cost(trial.values, start))


def importance(study: optuna.Study, trials: list[FrozenTrial]) -> dict[str, float]:
    """Return the PED-ANOVA importance of each parameter; {} with fewer than MIN_TRIALS trials."""
    if len(trials) < MIN_TRIALS:
        return {}
    found = optuna.importance.get_param_importances(
        study,
        evaluator=optuna.importance.PedAnovaImportanceEvaluator(),
        target=lambda trial: trial.values[0],
    )
    return {name: float(share) for name, share in found.items()}

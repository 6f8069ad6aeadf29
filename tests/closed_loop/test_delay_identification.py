# SPDX-License-Identifier: BSD-3-Clause
"""Delay identification from a log of a moving body, and prediction with that delay."""

from __future__ import annotations

import math

import numpy as np
import pytest
from surefoot import BodyReference, ControllerOptions, Error, StandController, identify_delay
from surefoot.sim import Plant, PlantSettings, Push
from surefoot.sim.truth import Truth

pytestmark = pytest.mark.slow


def log_excitation(settings: PlantSettings, seconds: float = 2.5) -> tuple[np.ndarray, np.ndarray]:
    """Return the torques sent and reported while the body moves, from 0.5 s on [N.m]."""
    plant = Plant("go1", settings)
    gains = plant.robot.config.gains
    gains.reference_acceleration, gains.reference_turn_acceleration = 10.0, 100.0  # fast
    controller = StandController(plant.robot, gains)
    state = plant.reset()
    sent, reported = [], []
    for k in range(int(seconds * settings.control_rate)):
        t = k / settings.control_rate
        if t > 0.5:
            target = BodyReference(height=0.01 * math.sin(20 * t), roll=0.03 * math.sin(31 * t))
            controller.set_body_reference(target)
        reported.append([state.motorState[i].tauEst for i in range(12)])
        command = controller.update(state)
        sent.append([command.motorCmd[i].tau for i in range(12)])
        state = plant.step(command)
    start = int(0.5 * settings.control_rate)
    return np.array(sent[start:]), np.array(reported[start:])


@pytest.mark.parametrize("rate", [500.0, 1000.0])
@pytest.mark.parametrize("lag", [0.002, 0.005])
def test_added_plant_delay_is_identified_within_2_ms(rate: float, lag: float) -> None:
    found = [
        identify_delay(
            *log_excitation(
                PlantSettings(extra_delay=extra, motor_lag=lag, control_rate=rate, seed=1)
            ),
            1.0 / rate,
        )
        for extra in (0.0, 0.01)
    ]
    # One period each way, the motor lag, and the hold between two commands.
    assert 2.0 / rate < found[0] < 4.0 / rate + lag
    assert abs(found[1] - found[0] - 0.01) <= 0.002 + 1e-9


def test_synthetic_delay_between_two_ticks_is_identified() -> None:
    t = np.arange(0.0, 2.0, 0.002)
    phase = np.arange(12)[None, :]
    sent = np.sin(37.0 * t[:, None] + phase)
    reported = 0.95 * np.sin(37.0 * (t[:, None] - 0.0107) + phase)
    assert abs(identify_delay(sent, reported, 0.002) - 0.0107) < 0.0003


@pytest.mark.parametrize(
    ("sent", "reported", "said"),
    [
        (np.zeros((500, 12)), np.zeros((400, 12)), "shapes"),
        (np.zeros((500, 12)), np.zeros((500, 12)), "move the body"),
        (np.full((500, 12), np.nan), np.zeros((500, 12)), "NaN or infinite"),
        (np.zeros((10, 12)), np.zeros((10, 12)), "ticks"),
        (
            np.random.default_rng(0).normal(size=(500, 12)),
            np.random.default_rng(1).normal(size=(500, 12)),
            "explain",
        ),
    ],
)
def test_uninformative_log_is_refused(sent: np.ndarray, reported: np.ndarray, said: str) -> None:
    with pytest.raises(Error, match=said):
        identify_delay(sent, reported, 0.002)


def pushed(
    direction: str, share: float, late: float, predicted_delay: float, seconds: float
) -> tuple[Truth, ...]:
    """Push a go1 whose commands are delayed; return its true states, () if it falls.

    Args:
        direction: Direction of the push.
        share: Impulse as a share of the LIP push limit.
        late: Further delay of the plant [s].
        predicted_delay: Delay that the controller predicts [s].
        seconds: Duration of the run [s].
    """
    plant = Plant("go1", PlantSettings(extra_delay=late, foot_force="dead", seed=1))
    plant.add_push(Push(direction, share * plant.lip_push_limit(direction), 0.1, 1.0))
    controller = StandController(plant.robot, options=ControllerOptions(delay=predicted_delay))
    state, truths = plant.reset(), []
    for _ in range(round(500 * seconds)):
        state = plant.step(controller.update(state))
        truths.append(plant.truth)
        if truths[-1].fell:
            return ()
    return tuple(truths)


def joint_speed_after_push(delay: float) -> float:
    """Return the RMS joint velocity 2.5 .. 3 s after a push, with commands 20 ms late [rad/s]."""
    truths = pushed("lateral", 0.6, 0.02, delay, 4.0)
    return float(np.sqrt(np.mean([t.dq**2 for t in truths[-250:]]))) if truths else math.inf


def test_prediction_damps_a_push_with_commands_20_ms_late() -> None:
    assert joint_speed_after_push(0.0) > 0.1
    for delay in (0.020, 0.024, 0.028):
        assert joint_speed_after_push(delay) < 0.02


def test_push_with_16_ms_unmodelled_delay_ends_at_rest() -> None:
    # All motion differs from the plan. A push observer that stayed fast would cause a lasting sway.
    truths = pushed("forward", 0.5, 0.016, 0.0, 5.0)
    assert truths
    assert np.sqrt(np.mean([t.v[:2] ** 2 for t in truths[-250:]])) < 0.002  # [m/s]

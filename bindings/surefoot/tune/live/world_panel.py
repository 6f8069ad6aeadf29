"""Panel of the simulated world: friction, payload, latency, slope, sensors."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import viser

from surefoot.tune.live.simulation import Simulation
from surefoot.tune.live.world import World

_SENSORS = ("real", "ideal")
_FOOT_FORCE = ("robot", "est", "raw", "dead")


def add_world_panel(
    gui: viser.GuiApi, simulation: Simulation, post: Callable[[Callable[[], Any]], None]
) -> None:
    """Add the controls of the world; each change restarts the robot in the new world.

    An MJCF gives friction and slope, so their sliders are disabled.

    Args:
        gui: GUI that gets the controls.
        simulation: The simulation.
        post: Function that runs an action in the thread that owns the simulation.
    """
    world, mass = simulation.world, simulation.robot.mass
    fixed = simulation.description.mjcf is not None
    hint = f"the controller assumes {simulation.robot.config.friction:g}"
    if fixed:
        hint += f"; the MJCF has {simulation.plant.friction:g}"
    friction = gui.add_slider(
        "friction [1]", 0.1, 1.5, 0.05, world.friction, hint=hint, disabled=fixed
    )
    hint = "on the trunk, unknown to the controller"
    payload = gui.add_slider("payload [kg]", 0.0, float(round(1.5 * mass)), 0.5, 0.0, hint=hint)
    hint = "extra delay of commands; real sensors already delay LowState and LowCmd by 2 ms each"
    delay = gui.add_slider("latency [ms]", 0.0, 20.0, 1.0, world.delay_ms, hint=hint)
    hint = "latency that the controller compensates by prediction"
    predicted = gui.add_slider("compensated [ms]", 0.0, 20.0, 1.0, world.predicted_ms, hint=hint)
    hint = "uphill forward"
    slope = gui.add_slider("slope [deg]", -15.0, 15.0, 1.0, 0.0, hint=hint, disabled=fixed)
    sensors = gui.add_dropdown("sensors", _SENSORS, initial_value=world.sensors)
    hint = (
        "robot: est or dead, as on the real robot; est: footForceEst in newtons and footForce in "
        "counts; raw: footForce only; dead: both zero"
    )
    foot_force = gui.add_dropdown(
        "foot force", _FOOT_FORCE, initial_value=world.foot_force, hint=hint
    )
    hint = "vibration, clipping and lag of the sensors, and soft soles, as in surefoot walk"
    walking = gui.add_checkbox("errors of a walk", world.walking_errors, hint=hint)
    seed = gui.add_number("seed", world.seed, min=0, step=1, hint="seed of sensor and motor errors")
    gui.add_markdown("_A change restarts the robot with the same gains._")

    def change(_: Any) -> None:
        world_settings = World(
            friction=float(friction.value),
            payload_kg=float(payload.value),
            delay_ms=float(delay.value),
            predicted_ms=float(predicted.value),
            sensors=sensors.value,
            foot_force=foot_force.value,
            slope_deg=float(slope.value),
            walking_errors=bool(walking.value),
            seed=int(seed.value),
        )
        simulation.requested_world = world_settings
        post(simulation.apply_requested_world)

    for handle in (friction, payload, delay, predicted, slope, sensors, foot_force, walking, seed):
        handle.on_update(change)

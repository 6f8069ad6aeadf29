"""A planner of your own: the body of a simulated go1 moves on a circle over its standing feet."""

from __future__ import annotations

import numpy as np
import surefoot
from surefoot.sim import Plant, PlantSettings

RADIUS, FREQUENCY, RAMP = 0.02, 0.5, 4.0  # [m], [Hz], [s] time until the radius is reached


class Circle(surefoot.Planner):
    """Move the centre of mass on a horizontal circle; keep the orientation and the feet."""

    def __init__(self) -> None:
        super().__init__()
        self.time = 0.0
        self.center = np.zeros(3)  # [m] from the mean of the feet, whose position may drift

    def reset(self) -> None:
        """Start again: the next plan() latches the pose."""
        self.time = 0.0

    def plan(self, input: surefoot.PlannerInput, reference: surefoot.Reference) -> None:
        """Write the reference of this tick; an exception would end the tick."""
        feet = input.p_feet.mean(axis=1)
        if self.time == 0.0:
            self.center = input.p_com - feet
            reference.quat_world_base = input.state.q[3:7]
        self.time += input.dt
        rate = 2.0 * np.pi * FREQUENCY
        radial = np.array([np.cos(rate * self.time), np.sin(rate * self.time), 0.0])
        tangent = np.array([-radial[1], radial[0], 0.0])
        radius = RADIUS * min(self.time / RAMP, 1.0)
        growth = RADIUS / RAMP if self.time < RAMP else 0.0  # [m/s]
        reference.p_com = feet + self.center + radius * radial
        reference.v_com = growth * radial + radius * rate * tangent
        reference.a_com = 2.0 * growth * rate * tangent - radius * rate**2 * radial
        for leg in range(4):
            reference.foot(leg).p_world = input.p_feet[:, leg]


def main() -> None:
    """Move on the circle for ten seconds, then print the way of the body."""
    controller = surefoot.Controller(surefoot.load_robot("go1"), Circle())
    plant = Plant("go1", PlantSettings(sensors="real"))
    state, com = plant.reset(), []
    for _ in range(5000):  # 10 s at 500 Hz
        state = plant.step(controller.update(state))
        com.append(plant.truth.com)
    width = np.ptp(np.array(com)[2500:], axis=0)  # the last 5 s
    print(f"{controller.status.name}, fell: {plant.truth.fell}, ", end="")
    print(f"circle of {100 * width[0]:.1f} cm x {100 * width[1]:.1f} cm")


if __name__ == "__main__":
    main()

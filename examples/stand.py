"""A simulated go1 stands in torque mode: load a robot, make a controller, call update()."""

from __future__ import annotations

import surefoot
from surefoot.sim import Plant, PlantSettings


def main() -> None:
    """Stand for five seconds, then print the result."""
    robot = surefoot.load_robot("go1")
    controller = surefoot.StandController(robot)
    plant = Plant("go1", PlantSettings(sensors="real"))  # on the robot: the SDK's UDP class

    state = plant.reset()
    for _ in range(2500):  # 5 s at 500 Hz
        command = controller.update(state)  # LowState -> LowCmd, in torque mode
        if controller.status != surefoot.Status.OK:
            print(f"{plant.time:.3f} s: {controller.status.name}")
        state = plant.step(command)
    print(f"fell: {plant.truth.fell}, height of the base: {plant.truth.q[2]:.3f} m")


if __name__ == "__main__":
    main()

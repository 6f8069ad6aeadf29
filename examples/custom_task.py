"""A user task that keeps a camera on the trunk at a given height; any Pinocchio frame works."""

from __future__ import annotations

import numpy as np
import pinocchio as pin
import surefoot

CAMERA = pin.SE3(np.eye(3), np.array([0.3, 0.0, 0.05]))  # on joint 1, the trunk
AXES = pin.LOCAL_WORLD_ALIGNED


class CameraHeight(surefoot.Task):
    """Task on the camera's vertical acceleration J a + drift; its desired value is PD feedback."""

    def __init__(self, model: pin.Model, target_height: float) -> None:
        super().__init__()
        self.model, self.data = model, model.createData()
        self.target_height, self.height = target_height, 0.0

    def rows(self) -> int:
        """Return the number of rows: one, vertical."""
        return 1

    def write(self, state: surefoot.RobotState, rows: surefoot.TaskRows) -> bool:
        """Write J and the desired acceleration. False or an exception would stop the tick."""
        model, data = self.model, self.data
        pin.forwardKinematics(model, data, state.q, state.v, np.zeros(model.nv))
        pin.computeJointJacobians(model, data, state.q)
        speed = pin.getFrameVelocity(model, data, 1, CAMERA, AXES).linear[2]
        drift = pin.getFrameClassicalAcceleration(model, data, 1, CAMERA, AXES).linear[2]
        self.height = data.oMi[1].act(CAMERA).translation[2]
        # Weight 3 is large, because this row is in m/s^2, but built-in tasks are scaled to about g.
        rows.weight[:], rows.A_a[:] = 3.0, pin.getFrameJacobian(model, data, 1, CAMERA, AXES)[2]
        rows.b[:] = 100.0 * (self.target_height - self.height) - 20.0 * speed - drift
        return True


def main() -> None:
    """Raise the camera by 3 cm, on a robot that follows the accelerations exactly."""
    robot = surefoot.load_robot("go1")
    model = pin.Model()
    model.loadFromString(robot.serialized_model())
    controller = surefoot.WholeBodyController(robot)
    task = CameraHeight(model, 0.08)
    controller.add_task(task)
    state = surefoot.RobotState()
    state.q = robot.q_standing()
    reference = controller.hold(state)
    for _ in range(1000):  # 2 s
        state.v = state.v + 0.002 * controller.update(state, reference).accelerations
        state.q = pin.integrate(model, state.q, 0.002 * state.v)
    print(f"camera at {task.height:.3f} m, desired {task.target_height:.3f} m")


if __name__ == "__main__":
    main()

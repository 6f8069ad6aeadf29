"""Worker of PlaCo: a tick is update_kinematics and solve."""

from __future__ import annotations

from typing import Any

import numpy as np
import placo
from worker_loop import Problem, serve


class Placo:
    """The problem as a placo.DynamicsSolver."""

    def __init__(self, problem: Problem) -> None:
        robot = placo.RobotWrapper(problem.urdf, placo.Flags.ignore_collisions)
        self.robot = robot
        problem.check_joints(list(robot.joint_names()))
        for joint, inertia in zip(problem.names("joints"), problem.array("armature"), strict=True):
            robot.set_rotor_inertia(joint, inertia)
            robot.set_gear_ratio(joint, 1.0)
        self.problem = problem
        robot.state.q, robot.state.qd = problem.q[0], problem.v[0]
        robot.update_kinematics()
        self.solver = placo.DynamicsSolver(robot)
        self.contacts = [
            self._contact(problem, leg, foot) for leg, foot in enumerate(problem.names("feet"))
        ]
        self._add_tasks(problem)
        for joint, limit in zip(problem.names("joints"), problem.array("tau_max"), strict=True):
            self.solver.set_torque_limit(joint, limit)
        self.solver.enable_torque_limits(True)
        self.solver.torque_cost = 0.0  # the other implementations have no torque cost

    def _contact(self, problem: Problem, leg: int, foot: str) -> Any:
        anchor = problem.array("anchors")[3 * leg : 3 * leg + 3]
        task = self.solver.add_position_task(foot, anchor)
        task.configure(foot, "hard", 1.0)
        task.kp, task.kd = problem.array("foot_gains")
        contact = self.solver.add_unilateral_point_contact(task)
        contact.mu = problem.number("friction")
        contact.weight_forces = problem.number("force_weight")
        return contact

    def _add_tasks(self, problem: Problem) -> None:
        posture = self.solver.add_joints_task()
        pose = zip(problem.names("joints"), problem.array("posture").tolist(), strict=True)
        posture.set_joints(dict(pose))
        self.com = self.solver.add_com_task(problem.com[0])
        self.base = self.solver.add_orientation_task("root_joint", problem.rotation[0])
        tasks = {"com": self.com, "base": self.base, "posture": posture}
        for name, task in tasks.items():
            task.configure(name, "soft", problem.number(f"{name}_weight"))
            task.kp, task.kd = problem.array(f"{name}_gains")

    def load(self, k: int) -> None:
        """Set the state and the targets of tick k."""
        self.robot.state.q = self.problem.q[k]
        self.robot.state.qd = self.problem.v[k]
        self.com.target_world = self.problem.com[k]
        self.base.R_world_frame = self.problem.rotation[k]

    def tick(self) -> None:
        """Compute one tick; this is timed."""
        self.robot.update_kinematics()
        self.solution = self.solver.solve()

    def read_result(self) -> tuple[bool, Any, Any]:
        """Return whether the tick was solved, forces (12,) [N] and torques (nv - 6,) [N.m]."""
        forces = [np.ravel(contact.wrench) for contact in self.contacts]
        return self.solution.success, np.concatenate(forces), self.solution.tau[6:]


if __name__ == "__main__":
    serve(Placo, ["placo", "pin", "numpy"])

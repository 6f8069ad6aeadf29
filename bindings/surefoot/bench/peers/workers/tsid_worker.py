"""Worker of TSID: a tick is computeProblemData, solve and getActuatorForces."""

from __future__ import annotations

from typing import Any

import numpy as np
import pinocchio as pin
import tsid
from worker_loop import Problem, serve

UP = np.array([0.0, 0.0, 1.0])


class Tsid:
    """The problem as an InverseDynamicsFormulationAccForce, solved by eiquadprog-fast."""

    def __init__(self, problem: Problem) -> None:
        self.problem = problem
        model = pin.buildModelFromUrdf(problem.urdf, pin.JointModelFreeFlyer())
        problem.check_joints(list(model.names)[2:])  # skip the universe and the root
        self.robot = tsid.RobotWrapper(model, False)
        self.robot.set_rotor_inertias(problem.array("armature"))
        self.robot.set_gear_ratios(np.ones(problem.nv - 6))
        self.formulation = tsid.InverseDynamicsFormulationAccForce("tsid", self.robot, False)
        self.formulation.computeProblemData(0.0, problem.q[0], np.zeros(problem.nv))
        self.kept_alive: list[Any] = []  # the formulation does not keep its tasks alive
        self.feet = problem.names("feet")
        for leg, foot in enumerate(self.feet):
            self._add_contact(problem, foot, problem.array("anchors")[3 * leg : 3 * leg + 3])
        self._add_body(problem)
        self._add_joints(problem)
        formulation = self.formulation
        self.solver = tsid.SolverHQuadProgFast("solver")
        self.solver.resize(formulation.nVar, formulation.nEq, formulation.nIn)

    def _add_contact(self, problem: Problem, foot: str, anchor: Any) -> None:
        limit, mu = problem.number("force_max"), problem.number("friction")
        contact = tsid.ContactPoint(foot, self.robot, foot, UP, mu, 0.0, limit)
        stiffness, damping = problem.array("foot_gains")
        contact.setKp(stiffness * np.ones(3))
        contact.setKd(damping * np.ones(3))
        contact.useLocalFrame(False)  # otherwise forces and friction cone rotate with the foot
        contact.setReference(pin.SE3(np.eye(3), anchor))
        contact.setRegularizationTaskWeightVector(np.ones(3))
        contact.setForceReference(problem.number("force") * UP)
        self.formulation.addRigidContact(contact, problem.number("force_weight"))
        self.kept_alive.append(contact)

    def _add_body(self, problem: Problem) -> None:
        self.com = tsid.TaskComEquality("com", self.robot)
        self.base = tsid.TaskSE3Equality("base", self.robot, "root_joint")
        self.base.setMask(np.array([0.0, 0.0, 0.0, 1.0, 1.0, 1.0]))
        self.load(0)
        self._add_motion(problem, self.com, "com", 3)
        self._add_motion(problem, self.base, "base", 6)

    def _add_joints(self, problem: Problem) -> None:
        posture = tsid.TaskJointPosture("posture", self.robot)
        pose = tsid.TrajectorySample(problem.nv - 6)
        pose.value(problem.array("posture"))
        posture.setReference(pose)
        self._add_motion(problem, posture, "posture", problem.nv - 6)
        bounds = tsid.TaskActuationBounds("torques", self.robot)
        bounds.setBounds(-problem.array("tau_max"), problem.array("tau_max"))
        self.formulation.addActuationTask(bounds, 1.0, 0, 0.0)
        self.kept_alive.append(bounds)

    def _add_motion(self, problem: Problem, task: Any, name: str, size: int) -> None:
        stiffness, damping = problem.array(f"{name}_gains")
        task.setKp(stiffness * np.ones(size))
        task.setKd(damping * np.ones(size))
        self.formulation.addMotionTask(task, problem.number(f"{name}_weight"), 1, 0.0)
        self.kept_alive.append(task)

    def load(self, k: int) -> None:
        """Store the state of tick k and set its targets."""
        self.q, self.v = self.problem.q[k], self.problem.v[k]
        com_target = tsid.TrajectorySample(3)
        com_target.value(self.problem.com[k])
        self.com.setReference(com_target)
        pose = tsid.TrajectorySample(12, 6)
        pose.value(np.concatenate([np.zeros(3), self.problem.rotation[k].flatten(order="F")]))
        self.base.setReference(pose)

    def tick(self) -> None:
        """Compute one tick, with the kinematics in computeProblemData; this is timed."""
        data = self.formulation.computeProblemData(0.0, self.q, self.v)
        self.solution = self.solver.solve(data)
        self.torques = self.formulation.getActuatorForces(self.solution)

    def read_result(self) -> tuple[bool, Any, Any]:
        """Return whether the tick was solved, forces (12,) [N] and torques (nv - 6,) [N.m]."""
        forces = [self.formulation.getContactForce(foot, self.solution) for foot in self.feet]
        return self.solution.status == 0, np.concatenate(forces), self.torques


if __name__ == "__main__":
    serve(Tsid, ["tsid", "libtsid", "pin", "eiquadprog", "numpy"])

"""The peers, and what is in a tick of each."""

from __future__ import annotations

from dataclasses import dataclass

from surefoot.bench.peers.cpp_program import CppProgram
from surefoot.bench.peers.environment import PLACO, TSID, Environment


@dataclass(frozen=True)
class Peer:
    """A controller that ours is compared with.

    Attributes:
        name: In the figures.
        environment: Its own.
        script: Its worker, a file in workers/.
        cpp_program: The same in C++, if there is one; its libraries are the environment's.
        tick_description: What its clock runs over.
        problem_differences: Where its problem is not quite ours.
    """

    name: str
    environment: Environment
    script: str
    cpp_program: CppProgram | None
    tick_description: str
    problem_differences: str


PEERS = (
    Peer(
        "tsid",
        TSID,
        "tsid_worker.py",
        CppProgram("tsid_tick.cpp", ("tsid", "eiquadprog", "pinocchio_default")),
        "computeProblemData (kinematics in it), solve with eiquadprog-rt, sizes fixed (C++) "
        "or eiquadprog-fast (Python, which has no other), getActuatorForces",
        "four facets of friction a foot (ours 14), constant torque limits, hard (ours by the "
        "torque-speed curve, elastic), no limits of joint positions and velocities",
    ),
    Peer(
        "placo",
        PLACO,
        "placo_worker.py",
        None,  # its wheel holds no headers
        "update_kinematics, DynamicsSolver.solve",
        "four facets of friction a foot (ours 14), no upper bound of the normal force, constant "
        "torque limits, hard (ours by the torque-speed curve, elastic), no limits of joint "
        "positions and velocities, a torque cost of weight 0",
    ),
)
OUR_PROGRAM = CppProgram("surefoot_tick.cpp", ("surefoot", "pinocchio_default"))
OUR_TICKS = {
    "state_to_torque": "WholeBodyController.update (kinematics in it): RobotState to torques, "
    "contact points at the foot frames",
    "tick": "StandController.update: LowState to LowCmd, estimator, integral action, limits of the "
    "body and protections included",
}

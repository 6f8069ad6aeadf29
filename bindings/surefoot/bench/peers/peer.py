"""Peers, with the calls that their ticks consist of."""

from __future__ import annotations

from dataclasses import dataclass

from surefoot.bench.peers.cpp_program import CppProgram
from surefoot.bench.peers.environment import PLACO, TSID, Environment


@dataclass(frozen=True)
class Peer:
    """A controller that Surefoot is compared with.

    Attributes:
        name: Name in the figures.
        environment: Python environment of the peer.
        script: Python worker, a file in workers/.
        cpp_program: C++ worker, linked with the libraries of the environment. None: there is none.
        tick_description: Calls of the peer's API that are timed as one tick.
        problem_differences: Differences between the peer's problem and Surefoot's.
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
        "computeProblemData (with kinematics), solve with eiquadprog-rt, sizes fixed (C++) "
        "or eiquadprog-fast (the only one in Python), getActuatorForces",
        "four friction facets per foot (ours 14), constant hard torque limits (ours elastic, by "
        "the torque-speed curve), no limits of joint positions and velocities",
    ),
    Peer(
        "placo",
        PLACO,
        "placo_worker.py",
        None,  # no C++ worker, because PlaCo's wheel contains no headers
        "update_kinematics, DynamicsSolver.solve",
        "four friction facets per foot (ours 14), no upper bound of the normal force, constant "
        "hard torque limits (ours elastic, by the torque-speed curve), no limits of joint "
        "positions and velocities, a torque cost of weight 0",
    ),
)
OUR_PROGRAM = CppProgram("surefoot_tick.cpp", ("surefoot", "pinocchio_default"))
OUR_TICKS = {
    "state_to_torque": "WholeBodyController.update (with kinematics): RobotState to torques, "
    "contact points at the foot frames",
    "tick": "StandController.update: LowState to LowCmd, with estimator, integral action, limits "
    "of the body and protections",
}

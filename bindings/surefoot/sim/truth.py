"""True state of the plant, for the assessment of a controller; not an input of the controller."""

from __future__ import annotations

from dataclasses import dataclass

import mujoco
import numpy as np
import numpy.typing as npt

from surefoot.geometry.rotations import Array
from surefoot.sim.model.mujoco_handles import Handles
from surefoot.sim.pinocchio_adapter import PinocchioAdapter

# Cosine of 60 deg, the tilt above which the robot has fallen. The limit is that of unitree_guide
# (R33 < 0.5) and PX4 (FD_FAIL_R, FD_FAIL_P).
FALLEN_TILT_COS = 0.5


@dataclass(frozen=True)
class Truth:
    """True state without sensor errors. World z is up; feet are in the order FR FL RR RL.

    Attributes:
        time: Time since reset [s].
        q: (nq,) Pinocchio's q: position, quaternion x y z w, joints in Pinocchio's order.
        v: (nv,) Pinocchio's v: base twist in base axes, joint velocities.
        p_world_feet: (3, 4) centres of the foot spheres [m].
        foot_forces: (3, 4) ground force on each foot in the last physics step, world axes [N].
        contact: (4,) whether each foot carries any force.
        com: (3,) centre of mass of the whole robot, payload included [m].
        com_velocity: (3,) velocity of the centre of mass [m/s].
        tau: (12,) true motor torque, SDK order [N.m].
        dq: (12,) true joint velocity, on the link's side of the gear, SDK order [rad/s].
        fell: Whether a part other than a foot touches the ground, a part other than a foot or a
            calf the terrain, or the tilt exceeds 60 deg. The ground of an MJCF counts as terrain.
    """

    time: float
    q: Array
    v: Array
    p_world_feet: Array
    foot_forces: Array
    contact: npt.NDArray[np.bool_]
    com: Array
    com_velocity: Array
    tau: Array
    dq: Array
    fell: bool


def measure_truth(
    model: mujoco.MjModel,
    data: mujoco.MjData,
    handles: Handles,
    adapter: PinocchioAdapter,
    time: float,
    tau: Array,
) -> Truth:
    """Return a copy of the true state. MuJoCo's kinematics must be up to date."""
    mujoco.mj_subtreeVel(model, data)
    qpos, qvel = data.qpos.copy(), data.qvel.copy()
    forces = data.sensordata[handles.foot_forces]
    return Truth(
        time=time,
        q=adapter.q_from_mujoco(qpos),
        v=adapter.v_from_mujoco(qpos, qvel),
        p_world_feet=data.xpos[handles.foot_bodies].T.copy(),
        foot_forces=forces.T.copy(),
        contact=forces @ handles.ground_normal > 0.0,
        com=data.subtree_com[handles.root].copy(),
        com_velocity=data.subtree_linvel[handles.root].copy(),
        tau=tau.copy(),
        dq=qvel[handles.joint_v],
        fell=has_fallen(data, handles),
    )


def has_fallen(data: mujoco.MjData, handles: Handles) -> bool:
    """Return Truth.fell."""
    # The comparison is negated so that NaN counts as fallen.
    if not data.xmat[handles.root, 8] >= FALLEN_TILT_COS:
        return True
    # Plain Python is faster than numpy for so few contacts.
    ground, feet = handles.ground_geoms, handles.foot_geoms.tolist()
    terrain, calves = handles.terrain_geoms, handles.calf_geoms
    for geom1, geom2 in data.contact.geom.tolist():
        if (geom1 in ground and geom2 not in feet) or (geom2 in ground and geom1 not in feet):
            return True
        if geom1 in terrain or geom2 in terrain:
            part = geom2 if geom1 in terrain else geom1
            if part not in feet and part not in calves:
                return True
    return False

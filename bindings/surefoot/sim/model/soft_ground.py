"""Ground that feet sink into: a linear spring and a damper below each foot.

MuJoCo has no spring contact as such. It solves for a force f with R f = a_ref - a, where
a_ref = -(damping v + stiffness r) / d follows from penetration r, R = A (1 - d) / d from the
impedance d, and A is a fixed guess of the foot's inverse inertia. With

    stiffness = K (1 - d) A,    damping = C (1 - d) A

that is f = -K r - C v - a / R: a spring and a damper in newtons, and 1 / R [kg] of ground that
moves along. The smaller d, the lighter that ground, and the sooner an explicit damper is too stiff
for the physics step; so d is small where it can be.

Friction keeps the rigid ground's own laws: its regularisation comes from R through impratio, and
its velocity gain would come from the spring's damping. Both are set such that in tangential
direction nothing changes, for else feet would creep and a sliding foot would ride up.

The link that bears a foot goes down with it: shins do not touch soft ground. To everything else,
knees among it, the ground is as rigid as ever.
"""

from __future__ import annotations

import math

import mujoco

from surefoot._core import Robot
from surefoot.sim.model.scene import FOOT_SOLIMP, FOOT_SOLREF, GROUND, IMPRATIO
from surefoot.sim.settings import PlantSettings

GRAVITY = 9.81  # [m/s^2]
_MIN_IMPEDANCE = 0.1
_MAX_STEP_RATIO = 0.5  # of the damper's own time constant on a foot that bears nothing


def add_soft_contacts(spec: mujoco.MjSpec, robot: Robot, settings: PlantSettings) -> None:
    """Give every foot a contact of its own with the ground; a sink of 0 does nothing."""
    if settings.soft_ground_sink <= 0.0:
        return
    friction = settings.friction
    for name in robot.config.foot_frames:
        spec.add_pair(
            name=name,
            geomname1=GROUND,
            geomname2=name,
            condim=3,
            friction=[friction, friction, 0.005, 0.0001, 0.0001],
        )
        shin = spec.body(name).parent
        while not shin.joints and shin.parent.name != "world":
            shin = shin.parent
        spec.add_exclude(bodyname1="world", bodyname2=shin.name)


def set_contact_stiffness(model: mujoco.MjModel, robot: Robot, settings: PlantSettings) -> None:
    """Set the stiffness of those contacts, which rests on inertias of the compiled model."""
    if settings.soft_ground_sink <= 0.0:
        return
    # Critically damped for a quarter of the robot.
    mass = robot.mass / 4.0
    stiffness = mass * GRAVITY / settings.soft_ground_sink
    damping = 2.0 * math.sqrt(stiffness * mass)
    rigid_impedance = FOOT_SOLIMP[0]
    velocity_gain = 2.0 / (FOOT_SOLREF[0] * FOOT_SOLIMP[1])  # of friction on the rigid ground
    for name in robot.config.foot_frames:
        pair = model.pair(name)
        inverse_inertia = float(model.body_invweight0[model.body(name).id, 0])
        rate = damping * inverse_inertia * settings.physics_dt
        one_minus_impedance = min(1.0 - _MIN_IMPEDANCE, _MAX_STEP_RATIO / rate)  # 1 - d
        impedance = 1.0 - one_minus_impedance
        pair.solimp[:] = [impedance, impedance, 0.001, 0.5, 2.0]
        pair.solref[:] = [
            -stiffness * one_minus_impedance * inverse_inertia,
            -damping * one_minus_impedance * inverse_inertia,
        ]
        model.pair_solreffriction[pair.id] = [-1.0, -velocity_gain * impedance]
        model.opt.impratio = (
            IMPRATIO
            * (one_minus_impedance / impedance)
            / ((1.0 - rigid_impedance) / rigid_impedance)
        )

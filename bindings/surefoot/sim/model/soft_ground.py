"""Soft ground and soft soles: a linear spring and a damper between each foot and the ground.

Ground and sole are in series, so the depths by which they yield add up, and the weaker damper
limits the force of an impact: 1 / C = 1 / C_ground + 1 / C_sole. Soft ground alone is critically
damped. A sole has little damping, so a foot that touches down still moves while its force rises.

MuJoCo has no spring contact. It solves R f = a_ref - a for the contact force f, where a is the
acceleration, a_ref = -(damping v + stiffness r) / d the reference acceleration at penetration r and
velocity v, d the impedance, R = A (1 - d) / d, and A a constant estimate of the foot's inverse
inertia. With

    stiffness = K (1 - d) A,    damping = C (1 - d) A

the force is f = -K r - C v - a / R: a spring, a damper, and a ground mass of 1 / R [kg] that moves
with the foot. A smaller d makes this mass lighter. But a smaller d also shortens the time constant
of the damper. MuJoCo integrates the damper explicitly, so the time constant must not be too short
for the physics step. So d is chosen as small as the step allows.

Friction stays that of rigid ground. MuJoCo derives the regularisation of friction from R and
impratio, and by default the velocity gain of friction from the damping of the spring. impratio and
the velocity gain are set so that the tangential behaviour does not change. Otherwise feet would
creep, and a sliding foot would rise.

The calf sinks with its foot, so collisions of calves with the ground plane are switched off. For
all other parts, and for calves at the edges of a terrain, the ground is rigid.
"""

from __future__ import annotations

import math

import mujoco

from surefoot._core import Robot
from surefoot.sim.model.scene import FOOT_SOLIMP, FOOT_SOLREF, GROUND, IMPRATIO, terrain_names
from surefoot.sim.settings import PlantSettings

GRAVITY = 9.81  # [m/s^2]
_PLANE_BIT = 2  # bit of contype with which all parts but the calves collide with the ground plane
# Smallest d. Chosen: the ground mass is then a ninth of the foot's own mass; a lighter ground mass
# changes nothing.
_MIN_IMPEDANCE = 0.1
# Largest ratio of the physics step to the damper's time constant on an unloaded foot. Derived: an
# explicit damper is stable below 2 and does not overshoot below 1; 0.5 leaves a factor of two.
_MAX_STEP_RATIO = 0.5
# Damping ratio of a soft sole under a quarter of the robot's mass. Assumed: rubber has loss factors
# of 0.1 to 0.3, and the damping ratio is half of the loss factor. If larger: a foot stops sooner.
_SOLE_DAMPING_RATIO = 0.15


def add_soft_contacts(spec: mujoco.MjSpec, robot: Robot, settings: PlantSettings) -> None:
    """Add a separate ground contact for each foot, if settings.contact_sink is above 0."""
    if settings.contact_sink <= 0.0:
        return
    _let_calves_sink(spec, robot)
    friction = settings.friction
    for name in robot.config.foot_frames:
        for ground in (GROUND, *terrain_names(settings)):
            spec.add_pair(
                name=pair_name(name, ground),
                geomname1=ground,
                geomname2=name,
                condim=3,
                friction=[friction, friction, 0.005, 0.0001, 0.0001],
            )


def _let_calves_sink(spec: mujoco.MjSpec, robot: Robot) -> None:
    """Switch off the collisions of calves with the ground plane; those with a terrain stay."""
    calves = set()
    for name in robot.config.foot_frames:
        calf = spec.body(name).parent
        while not calf.joints and calf.parent.name != "world":
            calf = calf.parent
        calves.add(calf.name)
    plane = spec.geom(GROUND)
    plane.contype = plane.conaffinity = _PLANE_BIT
    for body in spec.bodies:
        if body.name != "world" and body.name not in calves:
            for geom in body.geoms:
                geom.contype |= _PLANE_BIT if geom.contype else 0


def pair_name(foot: str, ground: str) -> str:
    """Return the name of the soft contact of a foot with a geom of the ground."""
    return foot if ground == GROUND else f"{foot} {ground}"


def set_contact_stiffness(model: mujoco.MjModel, robot: Robot, settings: PlantSettings) -> None:
    """Set stiffness and damping of the soft contacts, with the inertias of the compiled model."""
    sink, ground_sink = settings.contact_sink, settings.soft_ground_sink
    if sink <= 0.0:
        return
    mass = robot.mass / 4.0
    stiffness = mass * GRAVITY / sink
    damping = 1.0 / sum(
        1.0 / _damping(mass, depth, ratio)
        for depth, ratio in ((ground_sink, 1.0), (sink - ground_sink, _SOLE_DAMPING_RATIO))
        if depth > 0.0
    )
    rigid_impedance = FOOT_SOLIMP[0]
    velocity_gain = 2.0 / (FOOT_SOLREF[0] * FOOT_SOLIMP[1])  # of friction on rigid ground
    for name in robot.config.foot_frames:
        inverse_inertia = float(model.body_invweight0[model.body(name).id, 0])
        step_ratio = damping * inverse_inertia * settings.physics_dt
        one_minus_impedance = min(1.0 - _MIN_IMPEDANCE, _MAX_STEP_RATIO / step_ratio)  # 1 - d
        impedance = 1.0 - one_minus_impedance
        for ground in (GROUND, *terrain_names(settings)):
            pair = model.pair(pair_name(name, ground))
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


def _damping(mass: float, sink: float, ratio: float) -> float:
    """Return the damping [N.s/m] of a spring that yields by `sink` under this mass."""
    return ratio * 2.0 * mass * math.sqrt(GRAVITY / sink)

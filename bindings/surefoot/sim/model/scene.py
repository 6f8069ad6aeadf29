"""The scene: ground, light, sky and physics options."""

from __future__ import annotations

import math

import mujoco

from surefoot.geometry.rotations import slope_quaternion
from surefoot.sim.model.moving_ground import add_platform
from surefoot.sim.settings import PlantSettings

GROUND = "ground"
TERRAIN = "surefoot_terrain"  # the name of each box of a terrain begins with it
# Values of MuJoCo Menagerie's Unitree quadrupeds. Friction is [sliding, torsional, rolling]; the
# last two are MuJoCo's defaults and have no effect at condim 3.
BODY_FRICTION = 0.6  # sliding friction coefficient of all geoms except the feet
IMPRATIO = 100.0  # stiffness of friction divided by the stiffness of the normal force

TERRAIN_DEPTH = 0.1  # [m] of the boxes below the ground; chosen: more than a foot's radius
TERRAIN_DARKEST = 0.25  # [m] height from which boxes are not drawn darker; chosen: five stairs

# Contact of a foot with the ground. Chosen: critically damped, with a time constant of 5 ms. This
# is ten default physics steps, so results do not depend on the step. The impedance is so close to 1
# that the feet of a standing robot sink by only 10 .. 20 um and creep by 20 .. 35 um in ten seconds
# (measured; test_plant_standing.py: below 0.1 mm). [0.001, 0.5, 2.0] are MuJoCo's defaults.
FOOT_SOLREF = [0.005, 1.0]
FOOT_SOLIMP = [0.995, 0.999, 0.001, 0.5, 2.0]


def set_physics(spec: mujoco.MjSpec, settings: PlantSettings) -> None:
    """Set time step, integrator, friction cone and gravity.

    The Euler integrator treats joint damping implicitly. A model without actuators has no other
    implicit terms, and the motors' velocity feedback is slow compared with the step. The elliptic
    cone has no preferred direction. A large impratio makes friction much stiffer than the normal
    force, so that feet do not creep.
    """
    spec.option.timestep = settings.physics_dt
    spec.option.integrator = mujoco.mjtIntegrator.mjINT_EULER
    spec.option.cone = mujoco.mjtCone.mjCONE_ELLIPTIC
    spec.option.impratio = IMPRATIO
    spec.option.gravity = [0.0, 0.0, -9.81]


def add_ground(spec: mujoco.MjSpec, settings: PlantSettings) -> None:
    """Add the ground: a platform, or an infinite plane through the origin, tilted by the slope."""
    spec.add_texture(
        name=GROUND,
        type=mujoco.mjtTexture.mjTEXTURE_2D,
        builtin=mujoco.mjtBuiltin.mjBUILTIN_CHECKER,
        rgb1=[0.82, 0.84, 0.86],
        rgb2=[0.66, 0.69, 0.72],
        width=512,
        height=512,
    )
    material = spec.add_material(name=GROUND, texrepeat=[2.0, 2.0], texuniform=True)
    material.textures[mujoco.mjtTextureRole.mjTEXROLE_RGB] = GROUND
    body, shape = spec.worldbody, mujoco.mjtGeom.mjGEOM_PLANE
    size, position = [0.0, 0.0, 0.5], [0.0, 0.0, 0.0]
    if settings.platform_heading_deg is not None:
        body, shape, size, position = add_platform(spec, settings.platform_heading_deg)
    body.add_geom(
        name=GROUND,
        type=shape,
        size=size,
        pos=position,
        quat=slope_quaternion(settings.slope_deg, settings.slope_heading_deg),
        material=GROUND,
        friction=[BODY_FRICTION, 0.005, 0.0001],
        condim=3,
    )


def add_terrain(spec: mujoco.MjSpec, settings: PlantSettings) -> None:
    """Add the boxes of settings.terrain to the world."""
    for name, box in zip(terrain_names(settings), settings.terrain.boxes(), strict=True):
        # A box reaches below the ground, so that a foot at its lower edge touches only its side.
        half_height = 0.5 * (box.height + TERRAIN_DEPTH)
        shade = 0.9 - 0.25 * min(1.0, box.height / TERRAIN_DARKEST)
        spec.worldbody.add_geom(
            name=name,
            type=mujoco.mjtGeom.mjGEOM_BOX,
            size=[0.5 * box.length, 0.5 * box.width, half_height],
            pos=[box.x, box.y, half_height - TERRAIN_DEPTH],
            quat=[math.cos(0.5 * box.heading), 0.0, 0.0, math.sin(0.5 * box.heading)],
            rgba=[shade, 0.95 * shade, 0.85 * shade, 1.0],
            friction=[BODY_FRICTION, 0.005, 0.0001],
            condim=3,
        )


def terrain_names(settings: PlantSettings) -> list[str]:
    """Return the names of the geoms of settings.terrain."""
    return [f"{TERRAIN}_{k}" for k in range(len(settings.terrain.boxes()))]


def add_light_and_sky(spec: mujoco.MjSpec) -> None:
    """Add a sky, and a light that follows the robot so that its shadow stays sharp."""
    spec.add_texture(
        name="sky",
        type=mujoco.mjtTexture.mjTEXTURE_SKYBOX,
        builtin=mujoco.mjtBuiltin.mjBUILTIN_GRADIENT,
        rgb1=[0.75, 0.84, 0.93],
        rgb2=[0.97, 0.98, 1.0],
        width=256,
        height=1536,
    )
    spec.worldbody.first_body().add_light(
        name="sun",
        type=mujoco.mjtLightType.mjLIGHT_DIRECTIONAL,
        mode=mujoco.mjtCamLight.mjCAMLIGHT_TRACKCOM,
        pos=[0.6, -0.8, 2.0],
        dir=[-0.3, 0.4, -1.0],
        castshadow=True,
    )

"""Backlash: play in the gears, within which the rotor turns and transmits no torque.

Each motor joint gets a second coordinate, the rotor angle reflected through the gear. Armature,
friction and damping of the joint are moved to the rotor, because seals, bearings and gears cause
most of a drive's friction on the rotor's side. The joint keeps only the inertia of the link.
Rotor and joint angle differ by at most half the play. Within the play no torque is transmitted. At
the ends of the play the teeth push each other through a unilateral constraint: a limited tendon on
rotor minus joint. MuJoCo solves this constraint implicitly, together with the foot contacts.
The rotor is a child of the world and acts as a reflected inertia. So gravity and the motion of the
link that carries the rotor have no effect on the rotor.
"""

from __future__ import annotations

import math

import mujoco

from surefoot._core import Error, Robot
from surefoot.sim.settings import PlantSettings

# Contact of the teeth. Tests: test_plant_backlash.py. Chosen: critically damped, so that after an
# impact the teeth separate with a tenth of their speed; and so stiff that the teeth yield by only
# 0.001 deg under the torques of a standing robot. The time constant of 2 ms is four default physics
# steps. [0.001, 0.5, 2.0] are MuJoCo's defaults.
TOOTH_SOLREF = [0.002, 1.0]
TOOTH_SOLIMP = [0.999, 0.999, 0.001, 0.5, 2.0]
# The armature is the rotor's inertia, but MuJoCo needs a body with mass for the coordinate.
# Numerical values: far below any armature (0.004 kg.m^2 and more).
_BODY_MASS = 1e-9  # [kg]
_BODY_INERTIA = 1e-12  # [kg.m^2]


def rotor_name(joint: str) -> str:
    """Return the name of a rotor's coordinate, of its body and of the tendon to its joint."""
    return f"surefoot_rotor_{joint}"


def add_backlash(spec: mujoco.MjSpec, robot: Robot, settings: PlantSettings) -> None:
    """Add a rotor to each motor joint if settings.backlash_deg is above 0.

    Call this after armature, friction and damping of the joints are set.

    Raises:
        Error: A rotor has no inertia, so its speed within the play would be undefined.
    """
    if settings.backlash_deg <= 0.0:
        return
    half = math.radians(settings.backlash_deg) / 2.0
    for name in robot.config.joint_names:
        joint = spec.joint(name)
        if joint.armature <= 0.0:
            raise Error(
                f"backlash_deg: got {settings.backlash_deg:g} with a rotor inertia of "
                f"{joint.armature:g} kg.m^2 in joint '{name}', expected an inertia above 0"
            )
        _add_rotor(spec, joint)
        tendon = spec.add_tendon(
            name=rotor_name(name),
            limited=True,
            range=[-half, half],
            margin=0.0,
            armature=0.0,
            frictionloss=0.0,
            stiffness=[0.0, 0.0, 0.0],
            damping=[0.0, 0.0, 0.0],
            solref_limit=TOOTH_SOLREF,
            solimp_limit=TOOTH_SOLIMP,
        )
        tendon.wrap_joint(rotor_name(name), 1.0)
        tendon.wrap_joint(name, -1.0)


def _add_rotor(spec: mujoco.MjSpec, joint: mujoco.MjsJoint) -> None:
    """Add a joint's rotor and move armature, friction and damping from the joint to the rotor."""
    body = spec.worldbody.add_body(name=rotor_name(joint.name))
    body.mass, body.inertia, body.ipos = _BODY_MASS, [_BODY_INERTIA] * 3, [0.0, 0.0, 0.0]
    body.explicitinertial = True
    # A new joint has the values of the default class "main", which an MJCF file may set.
    rotor = body.add_joint(
        name=body.name,
        type=mujoco.mjtJoint.mjJNT_HINGE,
        pos=[0.0, 0.0, 0.0],
        axis=[0.0, 0.0, 1.0],
        ref=0.0,
        springref=0.0,
        stiffness=[0.0, 0.0, 0.0],
        springdamper=[0.0, 0.0],
        limited=mujoco.mjtLimited.mjLIMITED_FALSE,
        range=[0.0, 0.0],
        actfrclimited=mujoco.mjtLimited.mjLIMITED_FALSE,
        solref_friction=joint.solref_friction.copy(),
        solimp_friction=joint.solimp_friction.copy(),
    )
    rotor.armature, joint.armature = joint.armature, 0.0
    rotor.frictionloss, joint.frictionloss = joint.frictionloss, 0.0
    rotor.damping, joint.damping = joint.damping.copy(), [0.0, 0.0, 0.0]

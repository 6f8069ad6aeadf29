"""Play in the gears: rotors that turn on their own until a tooth meets its neighbour.

Every motor's joint gets a second coordinate, the rotor's angle reflected through the gear. The
rotor's inertia, its friction and its damping move there from the joint, for seals, bearings and
gears make most of a drive's friction on the rotor's side; the joint keeps the link alone. The two
angles differ by at most half the play. Within it no torque passes; at its ends they push each
other, and only push, through a unilateral constraint (a limited tendon over rotor minus joint),
which MuJoCo solves implicitly, together with the feet's contacts. A rotor hangs on the world, as a
reflected inertia does: it feels neither gravity nor the motion of the link that bears it.
"""

from __future__ import annotations

import math

import mujoco

from surefoot._core import Error, Robot
from surefoot.sim.settings import PlantSettings

# Teeth that meet: critically damped, so they part again with a tenth of their speed, and stiff:
# under a standing robot's torques they yield by 0.001 deg. 2 ms are four default physics steps.
TOOTH_SOLREF = [0.002, 1.0]
TOOTH_SOLIMP = [0.999, 0.999, 0.001, 0.5, 2.0]
# A rotor's inertia is its armature; MuJoCo wants a body to bear the coordinate all the same.
_BODY_MASS = 1e-9  # [kg]
_BODY_INERTIA = 1e-12  # [kg.m^2]


def rotor_name(joint: str) -> str:
    """Return the name of the coordinate of a joint's rotor, of its body and of their tendon."""
    return f"surefoot_rotor_{joint}"


def add_backlash(spec: mujoco.MjSpec, robot: Robot, settings: PlantSettings) -> None:
    """Part rotors from joints, whose armature, friction and damping are set; 0 deg does nothing.

    Raises:
        Error: A rotor without inertia: nothing would say how fast it turns within the play.
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
            solref_limit=TOOTH_SOLREF,
            solimp_limit=TOOTH_SOLIMP,
        )
        tendon.wrap_joint(rotor_name(name), 1.0)
        tendon.wrap_joint(name, -1.0)


def _add_rotor(spec: mujoco.MjSpec, joint: mujoco.MjsJoint) -> None:
    """Add a joint's rotor and give it what belongs to it."""
    body = spec.worldbody.add_body(name=rotor_name(joint.name))
    body.mass, body.inertia, body.ipos = _BODY_MASS, [_BODY_INERTIA] * 3, [0.0, 0.0, 0.0]
    body.explicitinertial = True
    rotor = body.add_joint(name=body.name, type=mujoco.mjtJoint.mjJNT_HINGE, axis=[0.0, 0.0, 1.0])
    rotor.armature, joint.armature = joint.armature, 0.0
    rotor.frictionloss, joint.frictionloss = joint.frictionloss, 0.0
    rotor.damping, joint.damping = joint.damping.copy(), [0.0, 0.0, 0.0]

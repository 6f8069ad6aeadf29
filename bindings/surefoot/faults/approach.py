"""How a robot comes to the moment in which a fault begins."""

from __future__ import annotations

from surefoot._core import Mode
from surefoot.faults.scene import Scene
from surefoot.sim import Push

ASKED_TO_RISE = "asked to rise"  # no further than that
RISEN_SHARE = 0.4  # of the way up, where a rise is disturbed
RISE_TIME = 15.0  # [s] that a rise may take
SETTLE = 1.5  # [s] of standing before
PUSH_SHARE = 0.4  # of the push that the pendulum survives
PUSH_TIME, PUSH_LEAD = 0.1, 0.05  # [s] of the push; and of it before the fault


def approach(scene: Scene, mode: str) -> str:
    """Bring a robot to a mode's moment; return why it did not get there, or ""."""
    if scene.taken_over:
        scene.step()
        return _stand(scene, mode) if scene.is_armed() else "was not taken over"
    if not scene.arm():
        return f"was not armed: {scene.failures}"
    if mode == "lying":
        scene.run(0.2)
        return ""
    scene.supervisor.request(Mode.RISE)
    if mode == ASKED_TO_RISE:
        return ""
    if mode == "rising":
        return _rise(scene)
    if not scene.reaches(Mode.STAND, RISE_TIME):
        return _where(scene)
    return _stand(scene, mode)


def _stand(scene: Scene, mode: str) -> str:
    scene.run(SETTLE)
    if mode == "pushed":
        plant = scene.plant
        impulse = PUSH_SHARE * plant.lip_limit("lateral", PUSH_TIME)
        plant.add_push(Push("lateral", impulse, PUSH_TIME, plant.time))
        scene.run(PUSH_LEAD)
    return "" if scene.supervisor.mode == Mode.STAND else _where(scene)


def _rise(scene: Scene) -> str:
    for _ in range(round(RISE_TIME / 0.002)):
        scene.step()
        if scene.supervisor.height > RISEN_SHARE:
            return ""
    return _where(scene)


def _where(scene: Scene) -> str:
    supervisor = scene.supervisor
    return f"got no further than {supervisor.mode.name}, {supervisor.reason.name}"

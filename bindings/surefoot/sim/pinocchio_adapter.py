"""Conversion between the coordinates of MuJoCo and Pinocchio. No other module converts them.

=============  ========================  ==========================
quantity       Pinocchio                 MuJoCo
=============  ========================  ==========================
quaternion     x y z w                   w x y z
base velocity  linear in base axes       linear in world axes
base rotation  angular in base axes      angular in base axes
joints         alphabetical in the tree  order of the URDF document
=============  ========================  ==========================
"""

from __future__ import annotations

from typing import Any

import numpy as np

from surefoot._core import Error
from surefoot.geometry.rotations import Array, matrix_from_wxyz


class PinocchioAdapter:
    """Converts positions and velocities between a robot's two models. Joints are matched by name.

    Args:
        mj_model: MuJoCo model whose only free joint is the robot's base.
        pin_model: Pinocchio model of the same URDF with a free-flyer root.
    """

    def __init__(self, mj_model: Any, pin_model: Any) -> None:
        joints = list(zip(pin_model.names, pin_model.joints, strict=True))[2:]
        for name, joint in joints:
            if joint.nq != 1:
                raise Error(
                    f"joint '{name}': got {joint.nq} coordinates, expected 1 (a bounded joint)"
                )
        self.nq, self.nv = int(pin_model.nq), int(pin_model.nv)
        # Entry k of the four index arrays belongs to the same joint.
        self._q_pin = np.array([joint.idx_q for _, joint in joints])
        self._v_pin = np.array([joint.idx_v for _, joint in joints])
        self._q_mj = np.array([mj_model.joint(name).qposadr[0] for name, _ in joints])
        self._v_mj = np.array([mj_model.joint(name).dofadr[0] for name, _ in joints])

    def q_from_mujoco(self, qpos: Array) -> Array:
        """Return Pinocchio's q (nq,) for MuJoCo's qpos (nq,)."""
        q = np.empty(self.nq)
        q[0:3] = qpos[0:3]
        q[3:6], q[6] = qpos[4:7], qpos[3]
        q[self._q_pin] = qpos[self._q_mj]
        return q

    def v_from_mujoco(self, qpos: Array, qvel: Array) -> Array:
        """Return Pinocchio's v (nv,) for MuJoCo's qpos (nq,) and qvel (nv,)."""
        v = np.empty(self.nv)
        v[0:3] = matrix_from_wxyz(qpos[3:7]).T @ qvel[0:3]
        v[3:6] = qvel[3:6]
        v[self._v_pin] = qvel[self._v_mj]
        return v

    def qpos_from_pinocchio(self, q: Array) -> Array:
        """Return MuJoCo's qpos (nq,) for Pinocchio's q (nq,)."""
        qpos = np.empty(self.nq)
        qpos[0:3] = q[0:3]
        qpos[3], qpos[4:7] = q[6], q[3:6]
        qpos[self._q_mj] = q[self._q_pin]
        return qpos

    def qvel_from_pinocchio(self, q: Array, v: Array) -> Array:
        """Return MuJoCo's qvel (nv,) for Pinocchio's q (nq,) and v (nv,)."""
        return self.velocity_map(q) @ v

    def velocity_map(self, q: Array) -> Array:
        """Return the (nv, nv) matrix T of qvel = T v at Pinocchio's q (nq,)."""
        x, y, z, w = q[3:7]
        T = np.zeros((self.nv, self.nv))
        T[0:3, 0:3] = matrix_from_wxyz([w, x, y, z])
        T[3:6, 3:6] = np.eye(3)
        T[self._v_mj, self._v_pin] = 1.0
        return T

    def velocity_map_drift(self, q: Array, v: Array) -> Array:
        """Return dT/dt v (nv,), the velocity term of qacc = T dv/dt + dT/dt v.

        Only the linear rows of the base are not zero: dR/dt v_lin = R (w x v_lin).
        """
        drift = np.zeros(self.nv)
        drift[0:3] = self.velocity_map(q)[0:3, 0:3] @ np.cross(v[3:6], v[0:3])
        return drift

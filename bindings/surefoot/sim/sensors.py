"""Everything a LowState says, put together: the robot as its controller sees it."""

from __future__ import annotations

import mujoco
import numpy as np

from surefoot._core import LowState, Robot
from surefoot.sim.encoders import IdealEncoders, RealEncoders
from surefoot.sim.foot_sensors import FootSensors
from surefoot.sim.handles import Handles
from surefoot.sim.imu import IdealImu, RealImu
from surefoot.sim.motors import Motors
from surefoot.sim.rotations import Array, rpy_from_wxyz
from surefoot.sim.settings import PlantSettings
from surefoot.sim.wire import StateFrame, Wire


class Sensors:
    """Reads a MuJoCo state into LowStates.

    Args:
        robot: The robot.
        data: MuJoCo's state, read in place.
        handles: Indices into it.
        settings: Kind of sensors, rates, seed; foot_force resolved.
        tick0: LowState.tick of the first reading [ms].

    Attributes:
        imu: The IMU; its `bias` is the truth, for judging.
    """

    def __init__(
        self,
        robot: Robot,
        data: mujoco.MjData,
        handles: Handles,
        settings: PlantSettings,
        tick0: int,
    ) -> None:
        self._data, self._handles = data, handles
        self._wire = Wire(robot.name, settings.real)
        self._frame = StateFrame()
        self._tick0, self._readings, self._rate = tick0, 0, settings.control_rate
        self.imu: IdealImu | RealImu
        self._encoders: IdealEncoders | RealEncoders
        # A stream of random numbers for each: one sensor's draws never shift another's.
        imu_rng, encoder_rng, foot_rng = (
            np.random.default_rng([settings.seed, k]) for k in range(3)
        )
        kind, period = settings.foot_force or "dead", 1.0 / settings.control_rate
        if settings.real:
            self.imu = RealImu(data, handles, settings.physics_dt, imu_rng, settings.flaws)
            self._encoders = RealEncoders(settings.physics_dt, encoder_rng)
            self._feet = FootSensors(kind, period, foot_rng)
        else:
            self.imu, self._encoders = IdealImu(data, handles), IdealEncoders()
            self._feet = FootSensors(kind, period, None)

    def start(self) -> None:
        """Begin, with the robot at rest."""
        self.imu.start()

    def step(self, dq: Array) -> None:
        """Advance one physics step; dq (12,) are the true velocities at the motors [rad/s]."""
        self.imu.step()
        self._encoders.step(dq)

    def read(self, motors: Motors) -> LowState:
        """Return the LowState of this instant; torques are what the drivers think they make."""
        data, handles, fields = self._data, self._handles, self._frame.fields
        quaternion = self.imu.quaternion
        fields["quaternion"][:] = quaternion
        fields["gyroscope"][:] = self.imu.gyro
        fields["accelerometer"][:] = self.imu.accelerometer
        fields["rpy"][:] = rpy_from_wxyz(quaternion)
        fields["motor_q"][:], fields["motor_dq"][:] = self._encoders.read(
            data.qpos[handles.motor_q], data.qvel[handles.motor_v]
        )
        fields["motor_ddq"][:] = np.trunc(data.qacc[handles.motor_v])  # whole rad/s^2 on the wire
        fields["motor_tauEst"][:] = self._wire.torque(motors.believed)
        fields["motor_mode"][:] = motors.law.mode
        normal_forces = data.sensordata[handles.foot_forces] @ handles.ground_normal
        fields["footForce"][:], fields["footForceEst"][:] = self._feet.read(normal_forces)
        fields["tick"][0] = self._tick()
        self._readings += 1
        return self._frame.copy()

    def _tick(self) -> int:
        return (self._tick0 + round(1000.0 * self._readings / self._rate)) % 2**32

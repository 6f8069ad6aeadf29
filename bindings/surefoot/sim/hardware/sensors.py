"""All sensors of the robot, combined into a LowState."""

from __future__ import annotations

import mujoco
import numpy as np

from surefoot import _plant
from surefoot._core import Robot
from surefoot.sim.hardware.encoders import IdealEncoders, RealEncoders
from surefoot.sim.hardware.foot_sensors import FootSensors
from surefoot.sim.hardware.imu import draw_imu_errors
from surefoot.sim.hardware.walking_errors import accelerometer_readings, draw_vibration
from surefoot.sim.hardware.wire_format import WireFormat, default_low_state
from surefoot.sim.model.mujoco_handles import Handles
from surefoot.sim.settings import PlantSettings

_VIBRATION_STREAM = 4  # stream of random numbers; the other sensors use 0 .. 2, the motors 3


def mujoco_state(data: mujoco.MjData, handles: Handles) -> _plant.MujocoState:
    """Return views of MuJoCo's memory; they change when MuJoCo's state changes."""
    return _plant.MujocoState(
        *(data.qpos, data.qvel, data.qacc, data.qfrc_applied, data.sensordata),
        *(handles.motor_q.astype(np.int32), handles.motor_v.astype(np.int32)),
    )


class Sensors(_plant.Sensors):
    """Converts the state of MuJoCo to LowStates.

    Args:
        robot: The robot.
        data: MuJoCo's state, read in place.
        handles: Indices into data.
        settings: Kind of sensors, rates, seed; with foot_force resolved.
        tick0: LowState.tick of the first sample [ms].

    Attributes:
        imu_bias: True bias (6,) of gyroscope [rad/s] and accelerometer [m/s^2], IMU axes.
    """

    def __init__(
        self,
        robot: Robot,
        data: mujoco.MjData,
        handles: Handles,
        settings: PlantSettings,
        tick0: int,
    ) -> None:
        # Each sensor has its own random stream, so its draws do not change those of other sensors.
        imu_rng, encoder_rng, foot_rng = (
            np.random.default_rng([settings.seed, k]) for k in range(3)
        )
        walking, dt = settings.real and settings.walking_sensors, settings.physics_dt
        vibration_rng = np.random.default_rng([settings.seed, _VIBRATION_STREAM])
        self.imu_bias, imu_errors = np.zeros(6), None
        encoders: IdealEncoders | RealEncoders = IdealEncoders()
        if settings.real:
            imu_errors, self.imu_bias = draw_imu_errors(settings.flaws, dt, imu_rng, walking)
            encoders = RealEncoders(dt, encoder_rng)
        super().__init__(
            mujoco_state(data, handles),
            WireFormat(robot.name, settings.real),
            (handles.gyro.start, handles.accelerometer.start, handles.quaternion.start),
            imu_errors,
            imu_rng,
            draw_vibration(robot, settings, vibration_rng) if walking else None,
            accelerometer_readings(settings.control_rate) if walking else 1,
            encoders,
            FootSensors(
                settings.foot_force or "dead",
                1.0 / settings.control_rate,
                foot_rng if settings.real else None,
                dt if walking else None,
            ),
            handles.foot_forces.ravel().astype(np.int32),
            handles.ground_normal,
            default_low_state(),
            tick0,
            settings.control_rate,
        )

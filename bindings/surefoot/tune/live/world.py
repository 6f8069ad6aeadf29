"""Settings of the simulated world that the page can change."""

from __future__ import annotations

from dataclasses import dataclass

from surefoot.sim import PlantSettings
from surefoot.sim.settings import COARSE_DT

# The rate of the SDK's examples, dt = 0.002 s.
CONTROL_RATE = 500.0  # [Hz] ticks per second of the simulated robot


@dataclass(frozen=True)
class World:
    """Ground, payload, delays and sensors of the simulated robot; a change restarts the robot.

    Attributes:
        friction: Friction coefficient between foot and ground.
        payload_kg: Payload on the trunk, unknown to the controller [kg].
        delay_ms: Extra delay of commands [ms]. Real sensors also delay commands and samples by one
            control period each.
        predicted_ms: Delay that the controller compensates by prediction [ms], see
            ControllerOptions.delay.
        sensors: "real" or "ideal".
        foot_force: "est" (footForceEst and footForce work), "raw" (only footForce), "dead" (both
            zero) or "robot" ("est" or "dead", as the robot's TOML states).
        slope_deg: Slope of the ground, uphill forward [deg].
        walking_errors: Whether the plant has the sensor errors and soft soles of a walk, as in
            `surefoot walk`; sensor errors only with real sensors.
        seed: Seed of the errors of sensors and motors.
    """

    friction: float = 0.8
    payload_kg: float = 0.0
    delay_ms: float = 0.0
    predicted_ms: float = 0.0
    sensors: str = "real"
    foot_force: str = "robot"
    slope_deg: float = 0.0
    walking_errors: bool = True
    seed: int = 1

    def plant_settings(self) -> PlantSettings:
        """Return the plant settings of this world; raise Error if a value is out of its range."""
        return PlantSettings(
            sensors=self.sensors,
            walking_sensors=self.walking_errors,
            soft_soles=self.walking_errors,
            leg_collisions=True,
            foot_force=None if self.foot_force == "robot" else self.foot_force,
            friction=self.friction,
            payload_kg=self.payload_kg,
            slope_deg=self.slope_deg,
            extra_delay=self.delay_ms / 1000.0,
            control_rate=CONTROL_RATE,
            physics_dt=COARSE_DT,
            seed=self.seed,
        )

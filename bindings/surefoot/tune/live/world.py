"""What the page can change about the simulated world."""

from __future__ import annotations

from dataclasses import dataclass

from surefoot.sim import PlantSettings
from surefoot.sim.settings import COARSE_DT

CONTROL_RATE = 500.0  # [Hz]


@dataclass(frozen=True)
class World:
    """Surroundings and flaws of the simulated robot; another world begins with a new stand.

    Attributes:
        friction: Coefficient between foot and ground.
        payload_kg: Mass on the trunk that the controller does not know of [kg].
        delay_ms: Delay of commands beyond the sensors' own [ms].
        predicted_ms: Delay that the controller predicts across [ms].
        sensors: "real" or "ideal".
        foot_force: "robot" (what its TOML says of the real one), "est", "raw" or "dead".
        slope_deg: Of the ground, uphill forward [deg].
        seed: Of the sensors' and motors' errors.
    """

    friction: float = 0.8
    payload_kg: float = 0.0
    delay_ms: float = 0.0
    predicted_ms: float = 0.0
    sensors: str = "real"
    foot_force: str = "robot"
    slope_deg: float = 0.0
    seed: int = 1

    def plant_settings(self) -> PlantSettings:
        """Return the plant of this world; raises Error."""
        return PlantSettings(
            sensors=self.sensors,
            foot_force=None if self.foot_force == "robot" else self.foot_force,
            friction=self.friction,
            payload_kg=self.payload_kg,
            slope_deg=self.slope_deg,
            extra_delay=self.delay_ms / 1000.0,
            control_rate=CONTROL_RATE,
            physics_dt=COARSE_DT,
            seed=self.seed,
        )

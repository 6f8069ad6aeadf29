"""Settings of a stand."""

from __future__ import annotations

from dataclasses import dataclass

from surefoot.stand.reference_request import ReferenceRequest
from surefoot.stand.simulation_settings import SimulationSettings


@dataclass(frozen=True)
class StandSettings(SimulationSettings):
    """Settings of a simulated stand: those of SimulationSettings, and references.

    Equal settings give equal runs.

    Attributes:
        references: Requested body poses; requests for the same time apply in the order of this
            tuple.
    """

    references: tuple[ReferenceRequest, ...] = ()

    def __post_init__(self) -> None:
        super().__post_init__()
        for request in self.references:
            self.check_time(f"reference '{request}'", request.time)

"""Search for gains by simulation; all trials have the same disturbances."""

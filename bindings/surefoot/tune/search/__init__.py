"""Search for gains by simulation; all trials face the same disturbances."""

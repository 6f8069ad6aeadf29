"""What acts on the simulated robot: time steps, pushes, lifts, initial poses."""

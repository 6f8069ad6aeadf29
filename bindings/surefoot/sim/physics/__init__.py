"""Time steps, pushes, external lifts and initial poses of the simulated robot."""

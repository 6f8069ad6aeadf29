"""Walking scorecard of a quadruped: velocities, pushes while it walks, and conditions."""

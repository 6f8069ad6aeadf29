"""How good the state estimator is: simulated runs recorded once, replayed under many sensors."""

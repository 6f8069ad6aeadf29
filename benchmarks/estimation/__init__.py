"""Accuracy of the state estimator: simulated runs, recorded once and replayed with many sensors."""

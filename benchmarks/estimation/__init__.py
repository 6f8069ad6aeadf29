"""Accuracy benchmark of the state estimator, with recorded runs and many sensor conditions."""

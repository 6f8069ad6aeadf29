"""Fault matrix: sets up, runs, observes, judges and reports its cells."""

"""Fault matrix: set up a cell, run it, observe it, judge it, report it."""

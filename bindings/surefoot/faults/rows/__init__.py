"""Rows of the fault catalogue: faults, their injections, and the expected reactions."""

"""Rotations: one at a time and in batches."""

"""Rotations, single and in batches."""

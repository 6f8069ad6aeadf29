"""Kinds of faults: how each changes commands, samples, the link or the surroundings."""

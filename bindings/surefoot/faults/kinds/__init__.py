"""Kinds of faults: how each fault changes commands, samples, the link or the surroundings."""

"""Kinds of faults and how each changes commands, states, link or surroundings."""

"""A robot and its scene from an MJCF file of somebody else."""

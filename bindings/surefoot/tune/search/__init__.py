"""A search for gains: the same disturbances for every trial, on every core or a cluster."""

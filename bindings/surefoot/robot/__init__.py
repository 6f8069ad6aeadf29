"""A robot's description, configuration and gains: TOML and URDF files, checked and loaded."""

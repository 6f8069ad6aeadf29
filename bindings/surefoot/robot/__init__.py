"""Robot descriptions, configurations and gains, loaded from URDF and TOML files."""

"""The MuJoCo model of a robot and its ground."""

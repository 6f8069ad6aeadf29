"""Sensor logs of a robot: their columns, and readers and writers of CSV and NPZ files."""

"""Logs of a robot's sensors: columns, readers and writers of CSV and NPZ files."""

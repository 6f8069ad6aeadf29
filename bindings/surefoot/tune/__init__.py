"""Gain tuning: live page, search by simulation, design from frequency and damping."""

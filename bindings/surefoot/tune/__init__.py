"""Tuning: a live page, a search on every core, a design from frequencies and damping."""

"""The fault catalogue as data: rows, their injections, and what is expected of each."""

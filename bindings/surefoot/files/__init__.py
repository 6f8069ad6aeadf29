"""File formats and helpers: atomic writes, tables, JSON values, result stores."""

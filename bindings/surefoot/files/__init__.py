"""Files that are read and written: atomic writes, tables, JSON values, result stores."""

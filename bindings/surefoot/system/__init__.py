"""Worker processes, description of the machine, and terminal."""

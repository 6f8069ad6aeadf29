"""The machine and the terminal: worker processes, host description, keyboard."""

"""NumPy layouts of the packed LowState and LowCmd structs."""

"""NumPy dtypes of the packed LowState and LowCmd structs."""

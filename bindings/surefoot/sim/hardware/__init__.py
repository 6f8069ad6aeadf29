"""Models of motors, encoders, IMU, foot sensors and the quantised wire format."""

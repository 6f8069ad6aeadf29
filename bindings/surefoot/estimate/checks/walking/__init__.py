"""Checks of the log of a walking robot.

The hypothesis of healthy sensors and that of each fault predict how stance feet move relative to
each other and to the IMU. The hypothesis that explains the log best is the verdict, if it is much
better than healthy sensors and its fault is large enough to matter.
"""

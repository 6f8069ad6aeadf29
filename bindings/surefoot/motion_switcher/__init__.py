"""Motion switcher of Go2 and B2: it starts and ends the sport service, which commands the motors.

The names of modes, the numbers of functions and the codes are those of unitree_sdk2.
"""

from surefoot.motion_switcher.api import SERVICE, Api, Code
from surefoot.motion_switcher.client import MotionSwitcher
from surefoot.motion_switcher.server import MotionSwitcherServer

__all__ = ["SERVICE", "Api", "Code", "MotionSwitcher", "MotionSwitcherServer"]

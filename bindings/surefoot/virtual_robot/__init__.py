"""Virtual robot: a plant in MuJoCo that speaks the SDKs of robots, over UDP or DDS."""

from surefoot.virtual_robot.dds_robot_link import DdsRobotLink
from surefoot.virtual_robot.joint_shaker import Shake, parse_shake
from surefoot.virtual_robot.remote import RemoteEvent, read_remote_script
from surefoot.virtual_robot.robot import VirtualRobot
from surefoot.virtual_robot.run import RunOptions, run_robot
from surefoot.virtual_robot.settings import DDS_ROBOTS, VirtualRobotSettings
from surefoot.virtual_robot.udp_port import UdpPort

__all__ = [
    "DDS_ROBOTS",
    "DdsRobotLink",
    "RemoteEvent",
    "RunOptions",
    "Shake",
    "UdpPort",
    "VirtualRobot",
    "VirtualRobotSettings",
    "parse_shake",
    "read_remote_script",
    "run_robot",
]

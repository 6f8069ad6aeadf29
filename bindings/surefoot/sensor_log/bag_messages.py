"""Message definitions of Unitree's ROS 2 packages, which are not part of ROS.

Fields and order are those of unitree_ros2 (unitree_go) and of unitree_ros_to_real
(unitree_legged_msgs), both by Unitree. They are the wire format: the order matters.
"""

from __future__ import annotations

from typing import Any

UNITREE_GO = "unitree_go/msg/LowState"
UNITREE_LEGGED = "unitree_legged_msgs/msg/LowState"
IMU = "sensor_msgs/msg/Imu"
JOINT_STATE = "sensor_msgs/msg/JointState"

_DEFINITIONS = {
    UNITREE_GO: {
        "unitree_go/msg/IMUState": """
            float32[4] quaternion
            float32[3] gyroscope
            float32[3] accelerometer
            float32[3] rpy
            int8 temperature
        """,
        "unitree_go/msg/MotorState": """
            uint8 mode
            float32 q
            float32 dq
            float32 ddq
            float32 tau_est
            float32 q_raw
            float32 dq_raw
            float32 ddq_raw
            int8 temperature
            uint32 lost
            uint32[2] reserve
        """,
        "unitree_go/msg/BmsState": """
            uint8 version_high
            uint8 version_low
            uint8 status
            uint8 soc
            int32 current
            uint16 cycle
            int8[2] bq_ntc
            int8[2] mcu_ntc
            uint16[15] cell_vol
        """,
        UNITREE_GO: """
            uint8[2] head
            uint8 level_flag
            uint8 frame_reserve
            uint32[2] sn
            uint32[2] version
            uint16 bandwidth
            IMUState imu_state
            MotorState[20] motor_state
            BmsState bms_state
            int16[4] foot_force
            int16[4] foot_force_est
            uint32 tick
            uint8[40] wireless_remote
            uint8 bit_flag
            float32 adc_reel
            int8 temperature_ntc1
            int8 temperature_ntc2
            float32 power_v
            float32 power_a
            uint16[4] fan_frequency
            uint32 reserve
            uint32 crc
        """,
    },
    UNITREE_LEGGED: {
        "unitree_legged_msgs/msg/IMU": """
            float32[4] quaternion
            float32[3] gyroscope
            float32[3] accelerometer
            float32[3] rpy
            int8 temperature
        """,
        "unitree_legged_msgs/msg/MotorState": """
            uint8 mode
            float32 q
            float32 dq
            float32 ddq
            float32 tau_est
            float32 q_raw
            float32 dq_raw
            float32 ddq_raw
            int8 temperature
            uint32[2] reserve
        """,
        "unitree_legged_msgs/msg/BmsState": """
            uint8 version_h
            uint8 version_l
            uint8 bms_status
            uint8 soc
            int32 current
            uint16 cycle
            int8[8] bq_ntc
            int8[8] mcu_ntc
            uint16[30] cell_vol
        """,
        UNITREE_LEGGED: """
            uint8[2] head
            uint8 level_flag
            uint8 frame_reserve
            uint32[2] sn
            uint32[2] version
            uint16 band_width
            IMU imu
            MotorState[20] motor_state
            BmsState bms
            int16[4] foot_force
            int16[4] foot_force_est
            uint32 tick
            uint8[40] wireless_remote
            uint32 reserve
            uint32 crc
        """,
    },
}


def message_types(message_type: str, definition: str | None = None) -> Any:
    """Return the rosbags typestore that decodes a message type.

    Args:
        message_type: Name of the type.
        definition: Definition that the bag itself holds, or None. It is used for
            unitree_legged_msgs, whose fields differ between versions.
    """
    from rosbags.typesys import Stores, get_types_from_msg, get_typestore

    store = get_typestore(Stores.ROS2_HUMBLE)
    if definition is not None and message_type == UNITREE_LEGGED:
        store.register(get_types_from_msg(definition, message_type))
        return store
    types: dict[str, Any] = {}
    for name, text in _DEFINITIONS.get(message_type, {}).items():
        lines = "\n".join(line.strip() for line in text.strip().splitlines())
        types.update(get_types_from_msg(lines, name))
    store.register(types)
    return store

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

/// The low-level interface of unitree_legged_sdk v3.5 - v3.8 (Go1), byte for byte.
///
/// Field names, order and packing equal the SDK's, so the bytes of a vendor `LowState` can be
/// copied into this one. All joint quantities are joint-side: the SDK has removed the gear ratio,
/// and the signs are those of the URDF joints. Arrays of feet and legs are in leg order: FR, FL,
/// RR, RL. Motor number = 3 * leg + {0 hip, 1 thigh, 2 calf}. Slots 12 .. 19 exist on the wire and
/// drive no motor.
namespace surefoot {

constexpr double PosStopF = 2.146e9;         ///< MotorCmd::q that switches the position loop off
constexpr double VelStopF = 16000.0;         ///< MotorCmd::dq that switches the velocity loop off
constexpr std::uint8_t kModeServo = 0x0A;    ///< the motor follows q, dq, tau, Kp, Kd
constexpr std::uint8_t kModeDamping = 0x00;  ///< the driver brakes the motor; not sent by Surefoot
constexpr std::uint8_t LOWLEVEL = 0xFF;      ///< levelFlag of every low-level frame

constexpr int kLegs = 4;         ///< legs of a robot
constexpr int kLegJoints = 3;    ///< joints of a leg: hip, thigh, calf
constexpr int kMotors = 12;      ///< motors of a robot
constexpr int kMotorSlots = 20;  ///< motor slots in LowState and LowCmd

/// Leg numbers of the SDK's quadruped.h.
enum Leg : int {
  FR_ = 0,  ///< front right
  FL_ = 1,  ///< front left
  RR_ = 2,  ///< rear right
  RL_ = 3   ///< rear left
};

/// Return the leg on the other side, at the same end: FR and FL, RR and RL. Real-time: yes.
constexpr int lateral_neighbor(int leg) noexcept { return leg ^ 1; }
/// Return the leg at the other end, on the same side: FR and RR, FL and RL. Real-time: yes.
constexpr int longitudinal_neighbor(int leg) noexcept { return leg ^ 2; }
/// Return the diagonally opposite leg: FR and RL, FL and RR. Real-time: yes.
constexpr int diagonal_leg(int leg) noexcept { return leg ^ 3; }

/// Motor numbers of the SDK's quadruped.h.
enum Motor : int {
  FR_0 = 0,  ///< front right, hip (abduction)
  FR_1,      ///< front right, thigh
  FR_2,      ///< front right, calf
  FL_0,      ///< front left, hip (abduction)
  FL_1,      ///< front left, thigh
  FL_2,      ///< front left, calf
  RR_0,      ///< rear right, hip (abduction)
  RR_1,      ///< rear right, thigh
  RR_2,      ///< rear right, calf
  RL_0,      ///< rear left, hip (abduction)
  RL_1,      ///< rear left, thigh
  RL_2       ///< rear left, calf
};

#pragma pack(push, 1)

/// Inertial measurement unit, in the IMU's own axes.
struct IMU {
  std::array<float, 4> quaternion;     ///< w x y z, IMU axes to world axes, by the vendor's filter
  std::array<float, 3> gyroscope;      ///< [rad/s] angular velocity, IMU axes, raw
  std::array<float, 3> accelerometer;  ///< [m/s^2] specific force, raw: +9.81 on z at rest
  std::array<float, 3> rpy;            ///< [rad] roll, pitch, yaw (ZYX); not used
  std::int8_t temperature;             ///< [deg C] not used
};

/// State of one motor, joint-side: the SDK has removed the gear ratio.
struct MotorState {
  std::uint8_t mode;                     ///< 0x0A servo, 0x00 damping, 0x08 overheated
  float q;                               ///< [rad] joint angle
  float dq;                              ///< [rad/s] joint velocity
  float ddq;                             ///< [rad/s^2] joint acceleration; not used
  float tauEst;                          ///< [N.m] joint torque estimated from the motor current
  float q_raw;                           ///< reserved by the vendor; not used
  float dq_raw;                          ///< reserved by the vendor; not used
  float ddq_raw;                         ///< reserved by the vendor; not used
  std::int8_t temperature;               ///< [deg C] temperature; lags behind that of the winding
  std::array<std::uint32_t, 2> reserve;  ///< reserved by the vendor; not used
};

/// Command to one motor, joint-side: tau_motor = tau + Kp (q - q_motor) + Kd (dq - dq_motor).
struct MotorCmd {
  std::uint8_t mode;                     ///< 0x0A servo, 0x00 damping
  float q;                               ///< [rad] desired joint angle, or PosStopF
  float dq;                              ///< [rad/s] desired joint velocity, or VelStopF
  float tau;                             ///< [N.m] feed-forward torque
  float Kp;                              ///< [N.m/rad] position stiffness
  float Kd;                              ///< [N.m.s/rad] damping
  std::array<std::uint32_t, 3> reserve;  ///< reserved by the vendor; not used
};

/// Battery command. Surefoot never writes this command.
struct BmsCmd {
  std::uint8_t off;                     ///< 0xA5 switches the battery off
  std::array<std::uint8_t, 3> reserve;  ///< reserved by the vendor; not used
};

/// State of the battery. If SOC is low, the Supervisor makes the robot sit down.
struct BmsState {
  std::uint8_t version_h;                  ///< firmware version, high byte; not used
  std::uint8_t version_l;                  ///< firmware version, low byte; not used
  std::uint8_t bms_status;                 ///< status code of the vendor; not used
  std::uint8_t SOC;                        ///< [%] state of charge
  std::int32_t current;                    ///< [mA] battery current; not used
  std::uint16_t cycle;                     ///< number of charge cycles; not used
  std::array<std::int8_t, 2> BQ_NTC;       ///< [deg C] sensors BQ_NTC; not used
  std::array<std::int8_t, 2> MCU_NTC;      ///< [deg C] sensors MCU_NTC; not used
  std::array<std::uint16_t, 10> cell_vol;  ///< [mV] cell voltages; not used
};

/// Sample that the robot sends in every period.
struct LowState {
  std::array<std::uint8_t, 2> head;                ///< FE EF
  std::uint8_t levelFlag;                          ///< LOWLEVEL
  std::uint8_t frameReserve;                       ///< reserved by the vendor; not used
  std::array<std::uint32_t, 2> SN;                 ///< serial number; not used
  std::array<std::uint32_t, 2> version;            ///< version; not used
  std::uint16_t bandWidth;                         ///< vendor's field; not used
  IMU imu;                                         ///< inertial measurement unit
  std::array<MotorState, kMotorSlots> motorState;  ///< slots 0 .. 11: motors in SDK order
  BmsState bms;                                    ///< state of the battery
  std::array<std::int16_t, kLegs> footForce;  ///< [counts] grows with load; offsets differ, drift
  std::array<std::int16_t, kLegs> footForceEst;  ///< [N] foot forces; zero on most real robots
  std::uint32_t tick;                            ///< [ms] modulo 2^32; only differences count
  std::array<std::uint8_t, 40> wirelessRemote;   ///< see decode_wireless_remote()
  std::uint32_t reserve;                         ///< reserved by the vendor; not used
  std::uint32_t crc;                             ///< CRC of the received frame
};

/// Command to the robot, one in every period. encode_low_cmd() writes head and crc into the frame,
/// and for the generations with a header also levelFlag.
struct LowCmd {
  std::array<std::uint8_t, 2> head;             ///< FE EF
  std::uint8_t levelFlag;                       ///< LOWLEVEL
  std::uint8_t frameReserve;                    ///< reserved by the vendor; not used
  std::array<std::uint32_t, 2> SN;              ///< serial number; not used
  std::array<std::uint32_t, 2> version;         ///< version; not used
  std::uint16_t bandWidth;                      ///< vendor's field; not used
  std::array<MotorCmd, kMotorSlots> motorCmd;   ///< slots 0 .. 11: motors in SDK order
  BmsCmd bms;                                   ///< battery command
  std::array<std::uint8_t, 40> wirelessRemote;  ///< not used in commands
  std::uint32_t reserve;                        ///< reserved by the vendor; not used
  std::uint32_t crc;                            ///< ignored: encode_low_cmd() computes the CRC
};

#pragma pack(pop)

static_assert(sizeof(IMU) == 53 && sizeof(MotorState) == 38 && sizeof(MotorCmd) == 33);
static_assert(sizeof(BmsCmd) == 4 && sizeof(BmsState) == 34);
static_assert(sizeof(LowState) == 937 && sizeof(LowCmd) == 734);
static_assert(offsetof(IMU, gyroscope) == 16 && offsetof(IMU, accelerometer) == 28);
static_assert(offsetof(IMU, rpy) == 40 && offsetof(IMU, temperature) == 52);
static_assert(offsetof(MotorState, tauEst) == 13 && offsetof(MotorState, temperature) == 29);
static_assert(offsetof(MotorCmd, tau) == 9 && offsetof(MotorCmd, Kd) == 17);
static_assert(offsetof(LowState, imu) == 22 && offsetof(LowState, motorState) == 75);
static_assert(offsetof(LowState, bms) == 835 && offsetof(LowState, footForce) == 869);
static_assert(offsetof(LowState, footForceEst) == 877 && offsetof(LowState, tick) == 885);
static_assert(offsetof(LowState, wirelessRemote) == 889 && offsetof(LowState, crc) == 933);
static_assert(offsetof(LowCmd, motorCmd) == 22 && offsetof(LowCmd, bms) == 682);
static_assert(offsetof(LowCmd, wirelessRemote) == 686 && offsetof(LowCmd, crc) == 730);

/// Make the same command as InitCmdData of the SDK.
///
/// All 20 slots are in servo mode with both loops switched off: q = PosStopF, dq = VelStopF,
/// tau = Kp = Kd = 0; head FE EF, levelFlag LOWLEVEL. Real-time: yes.
LowCmd init_low_cmd() noexcept;

/// Make a LowState with head FE EF, levelFlag LOWLEVEL and zeros elsewhere. Real-time: yes.
LowState init_low_state() noexcept;

/// Make the command in which every motor brakes by itself.
///
/// The 12 motors get mode 0x0A, q = PosStopF, dq = 0, tau = Kp = 0, Kd = `kd`. The motor drivers
/// compute the damping, so it continues if the process that sent the command dies. Real-time: yes.
/// @param kd Kd of the motor drivers [N.m.s/rad], joint-side
LowCmd damping_low_cmd(double kd) noexcept;

}  // namespace surefoot

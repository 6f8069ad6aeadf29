// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

/// The low-level interface of unitree_legged_sdk v3.5 - v3.8 (Go1), byte for byte.
///
/// Field names, order and packing equal the SDK's, so the bytes of a vendor `LowState` can be
/// copied into this one. All joint quantities are joint-side: the SDK has removed the gear ratio,
/// and the signs are those of the URDF joints. Arrays of feet and legs run FR, FL, RR, RL; motor
/// number = 3 * leg + {0 hip, 1 thigh, 2 calf}. Slots 12 .. 19 exist on the wire and drive no
/// motor.
namespace surefoot {

constexpr double PosStopF = 2.146e9;         ///< MotorCmd::q that switches the position loop off
constexpr double VelStopF = 16000.0;         ///< MotorCmd::dq that switches the velocity loop off
constexpr std::uint8_t kModeServo = 0x0A;    ///< motor follows q, dq, tau, Kp, Kd
constexpr std::uint8_t kModeDamping = 0x00;  ///< motor brakes by itself
constexpr std::uint8_t LOWLEVEL = 0xFF;      ///< levelFlag of every low-level frame

constexpr int kLegs = 4;
constexpr int kLegJoints = 3;
constexpr int kMotors = 12;      ///< motors that exist
constexpr int kMotorSlots = 20;  ///< slots in the structs

/// Leg numbers.
enum Leg : int { FR_ = 0, FL_ = 1, RR_ = 2, RL_ = 3 };

/// Return the other leg of the same end: FR and FL, RR and RL.
constexpr int lateral_neighbor(int leg) noexcept { return leg ^ 1; }
/// Return the other leg of the same side: FR and RR, FL and RL.
constexpr int longitudinal_neighbor(int leg) noexcept { return leg ^ 2; }
/// Return the diagonally opposite leg: FR and RL, FL and RR.
constexpr int diagonal_leg(int leg) noexcept { return leg ^ 3; }

/// Motor numbers of the SDK's quadruped.h.
enum Motor : int {
  FR_0 = 0,
  FR_1,
  FR_2,  // hip (abduction), thigh, calf
  FL_0,
  FL_1,
  FL_2,
  RR_0,
  RR_1,
  RR_2,
  RL_0,
  RL_1,
  RL_2
};

#pragma pack(push, 1)

/// Inertial measurement unit, in the IMU's own axes.
struct IMU {
  std::array<float, 4> quaternion;  ///< w x y z, IMU axes to world axes; vendor's attitude filter
  std::array<float, 3> gyroscope;   ///< [rad/s] angular velocity, raw
  std::array<float, 3> accelerometer;  ///< [m/s^2] specific force, raw: +9.81 on z at rest
  std::array<float, 3> rpy;            ///< [rad] roll, pitch, yaw (ZYX); not used
  std::int8_t temperature;             ///< [deg C]
};

/// State of one motor.
struct MotorState {
  std::uint8_t mode;                     ///< 0x0A servo, 0x00 damping, 0x08 overheated
  float q;                               ///< [rad] joint angle
  float dq;                              ///< [rad/s] joint velocity
  float ddq;                             ///< [rad/s^2] not used
  float tauEst;                          ///< [N.m] torque estimated from the motor current
  float q_raw;                           ///< reserved by the vendor; not used
  float dq_raw;                          ///< reserved by the vendor; not used
  float ddq_raw;                         ///< reserved by the vendor; not used
  std::int8_t temperature;               ///< [deg C] lags behind the winding temperature
  std::array<std::uint32_t, 2> reserve;  ///< not used
};

/// Command to one motor, joint-side: tau_motor = tau + Kp (q - q_motor) + Kd (dq - dq_motor).
struct MotorCmd {
  std::uint8_t mode;  ///< 0x0A servo, 0x00 damping
  float q;            ///< [rad] desired joint angle, or PosStopF
  float dq;           ///< [rad/s] desired joint velocity, or VelStopF
  float tau;          ///< [N.m] feed-forward torque
  float Kp;           ///< [N.m/rad] position stiffness
  float Kd;           ///< [N.m.s/rad] damping
  std::array<std::uint32_t, 3> reserve;
};

/// Battery command. `off` = 0xA5 switches the battery off: Surefoot never writes it.
struct BmsCmd {
  std::uint8_t off;
  std::array<std::uint8_t, 3> reserve;
};

/// State of the battery. The Supervisor makes the robot sit down when SOC is low.
struct BmsState {
  std::uint8_t version_h;
  std::uint8_t version_l;
  std::uint8_t bms_status;
  std::uint8_t SOC;      ///< [%] state of charge
  std::int32_t current;  ///< [mA]
  std::uint16_t cycle;
  std::array<std::int8_t, 2> BQ_NTC;       ///< [deg C]
  std::array<std::int8_t, 2> MCU_NTC;      ///< [deg C]
  std::array<std::uint16_t, 10> cell_vol;  ///< [mV]
};

/// Sample that the robot sends in every period.
struct LowState {
  std::array<std::uint8_t, 2> head;  ///< FE EF
  std::uint8_t levelFlag;
  std::uint8_t frameReserve;
  std::array<std::uint32_t, 2> SN;
  std::array<std::uint32_t, 2> version;
  std::uint16_t bandWidth;
  IMU imu;
  std::array<MotorState, kMotorSlots> motorState;
  BmsState bms;
  std::array<std::int16_t, kLegs> footForce;     ///< raw counts; offsets differ and drift
  std::array<std::int16_t, kLegs> footForceEst;  ///< [N]; zero on most real robots
  std::uint32_t tick;                            ///< [ms] modulo 2^32; only differences count
  std::array<std::uint8_t, 40> wirelessRemote;   ///< see decode_wireless_remote()
  std::uint32_t reserve;
  std::uint32_t crc;
};

/// Command to the robot, one in every period. encode_low_cmd() writes head and crc into the frame,
/// and for the generations with a header also levelFlag.
struct LowCmd {
  std::array<std::uint8_t, 2> head;  ///< FE EF
  std::uint8_t levelFlag;
  std::uint8_t frameReserve;
  std::array<std::uint32_t, 2> SN;
  std::array<std::uint32_t, 2> version;
  std::uint16_t bandWidth;
  std::array<MotorCmd, kMotorSlots> motorCmd;
  BmsCmd bms;
  std::array<std::uint8_t, 40> wirelessRemote;
  std::uint32_t reserve;
  std::uint32_t crc;
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
/// @param kd motor-side damping [N.m.s/rad]
LowCmd damping_low_cmd(double kd) noexcept;

}  // namespace surefoot

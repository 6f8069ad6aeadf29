// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/eigen/dense.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>

#include <optional>

#include "plant/physics.hpp"

namespace nb = nanobind;
using namespace nb::literals;
using namespace surefoot::plant;

namespace {

using Array3 = std::array<double, 3>;
Vector3 vector(const Array3& values) { return Vector3(values[0], values[1], values[2]); }

void bind_motors(nb::module_& m) {
  nb::class_<MotorCommands>(m, "MotorCommands",
                            "Commands of the twelve motors in a LowCmd, SI units, SDK motor order.")
      .def_prop_ro(
          "mode", [](const MotorCommands& c) { return c.mode; }, "Motor modes, shape (12,).")
      .def_prop_ro(
          "q", [](const MotorCommands& c) { return c.q; },
          "Desired joint angles [rad], shape (12,).")
      .def_prop_ro(
          "dq", [](const MotorCommands& c) { return c.dq; },
          "Desired joint velocities [rad/s], shape (12,).")
      .def_prop_ro(
          "tau", [](const MotorCommands& c) { return c.tau; },
          "Feed-forward torques [N.m], shape (12,).")
      .def_prop_ro(
          "kp", [](const MotorCommands& c) { return c.kp; }, "Stiffness [N.m/rad], shape (12,).")
      .def_prop_ro(
          "kd", [](const MotorCommands& c) { return c.kd; }, "Damping [N.m.s/rad], shape (12,).");
  nb::class_<WireFormat>(m, "WireFormat", "Quantisation of commands and torques on the wire.")
      .def(
          "__init__",
          [](WireFormat* self, double per_tau, bool real) { new (self) WireFormat{per_tau, real}; },
          "per_tau"_a, "real"_a,
          "Args:\n"
          "    per_tau: Counts per N.m of a torque.\n"
          "    real: If False, values do not change.")
      .def(
          "torque",
          [](const WireFormat& w, const Array12& tau) {
            return Array12(tau.unaryExpr([&w](double x) { return w.torque(x); }));
          },
          "tau"_a, "Return torques (12,) [N.m] after transmission as int16.")
      .def("read", &WireFormat::read, "cmd"_a,
           nb::sig("def read(self, cmd: object) -> MotorCommands"),
           "Return the motor commands of a LowCmd. A value that is not finite counts as not\n"
           "set.");
  nb::class_<MotorLaw>(
      m, "MotorLaw",
      "Torque law of the motor drivers: tau' = offset - kp q' - kd dq'.\n\n"
      "q' and dq' are the measured angles and velocities. All arrays have shape (12,).")
      .def(
          "__init__",
          [](MotorLaw* self, const Array12& offset, const Array12& kp, const Array12& kd,
             const std::optional<Modes>& mode) {
            new (self) MotorLaw{offset, kp, kd, mode.value_or(MotorLaw().mode)};
          },
          "offset"_a, "kp"_a, "kd"_a, "mode"_a = nb::none(),
          "Args:\n"
          "    mode: Motor modes; None: servo mode.")
      .def_prop_ro(
          "offset", [](const MotorLaw& l) { return l.offset; },
          "Constant torques [N.m], shape (12,).")
      .def_prop_ro(
          "kp", [](const MotorLaw& l) { return l.kp; }, "Stiffness [N.m/rad], shape (12,).")
      .def_prop_ro(
          "kd", [](const MotorLaw& l) { return l.kd; }, "Damping [N.m.s/rad], shape (12,).")
      .def_prop_ro(
          "mode", [](const MotorLaw& l) { return l.mode; },
          "Motor modes that LowState reports, shape (12,).");
  m.def("command_law", &command_law, "command"_a, "brake_kd"_a,
        "Return the law tau' = tau + Kp (q - q') + Kd (dq - dq') of a command.\n\n"
        "A motor that is not in servo mode brakes with brake_kd [N.m.s/rad].");
  nb::class_<Motors>(m, "Motors",
                     "Simulated motors. They compute joint torques from the present law.")
      .def(nb::init<const Array12&, const Array12&, const Array12&, double, const Array12&>(),
           "tau_max"_a, "corner_speed"_a, "no_load_speed"_a, "share"_a, "scale"_a,
           "Args:\n"
           "    tau_max: Torque limits up to corner_speed [N.m], shape (12,).\n"
           "    corner_speed: Velocities at which the limits start to fall [rad/s].\n"
           "    no_load_speed: Velocities at which the limits reach zero [rad/s].\n"
           "    share: Share by which the torque approaches its target in a step, 0 .. 1.\n"
           "    scale: Factors on the torques of the motors, shape (12,).")
      .def_prop_rw(
          "law", [](const Motors& s) { return MotorLaw(s.law); },
          [](Motors& s, const MotorLaw& law) { s.law = law; }, "Present torque law.")
      .def_prop_ro(
          "estimated_torque", [](const Motors& s) { return Array12(s.estimated_torque); },
          "Torques that the drivers estimate [N.m], shape (12,).")
      .def_prop_ro(
          "torque", [](const Motors& s) { return Array12(s.torque); },
          "Torques that the motors produce [N.m], shape (12,).")
      .def(
          "limits",
          [](const Motors& s, const Array12& dq) {
            return std::pair<Array12, Array12>(-s.max_torque(-dq), s.max_torque(dq));
          },
          "dq"_a, "Return the smallest and the largest torque (12,) [N.m] at dq (12,) [rad/s].")
      .def(
          "step",
          [](Motors& s, const Array12& q, const Array12& dq) { return Array12(s.step(q, dq)); },
          "q"_a, "dq"_a,
          "Advance by one physics step at joint angles q (12,) [rad] and velocities dq\n"
          "(12,) [rad/s]. Return the torques (12,) [N.m].");
}

void bind_sensors(nb::module_& m) {
  nb::class_<MahonyFilter>(m, "MahonyFilter", "Model of the vendor's attitude filter.")
      .def(
          "__init__",
          [](MahonyFilter* self, const Array3& a, double gain) {
            new (self) MahonyFilter(vector(a), gain);
          },
          "accelerometer"_a, "gain"_a,
          "Start with the tilt that an accelerometer reading (3,) [m/s^2] gives at rest.\n\n"
          "Args:\n"
          "    gain: Gain of the tilt correction [1/s].")
      .def_prop_ro(
          "quaternion", [](const MahonyFilter& f) { return Wxyz(f.quaternion); },
          "Quaternion w x y z from IMU to world axes, shape (4,).")
      .def(
          "update",
          [](MahonyFilter& f, const Array3& gyro, const Array3& accel, double dt) {
            f.update(vector(gyro), vector(accel), dt);
          },
          "gyro"_a, "accel"_a, "dt"_a,
          "Advance by dt [s] with gyro (3,) [rad/s] and specific force (3,) [m/s^2], IMU\n"
          "axes.");
  nb::class_<Encoders>(m, "Encoders", "Simulated joint encoders.")
      .def(nb::init<double, double, double, nb::object>(), "quantum"_a, "share"_a, "noise"_a,
           "rng"_a.none(),
           "Args:\n"
           "    quantum: Step of the angles [rad]; 0: angles and velocities are exact.\n"
           "    share: Share by which the velocity filter approaches its input in a step.\n"
           "    noise: Standard deviation of the velocities [rad/s].\n"
           "    rng: numpy.random.Generator.")
      .def("step", &Encoders::step, "dq"_a,
           "Advance the velocity filter by one physics step with the true velocities (12,)\n"
           "[rad/s].")
      .def(
          "read",
          [](Encoders& e, const Array12& q, const Array12& dq) {
            return std::pair<Array12, Array12>(e.angles(q), e.velocities(dq));
          },
          "q"_a, "dq"_a, "Return the measured angles (12,) [rad] and velocities (12,) [rad/s].");
  nb::class_<FootSensors>(m, "FootSensors", "Simulated foot force sensors.")
      .def(nb::init<nb::object>(), "rng"_a.none(),
           "Args:\n"
           "    rng: numpy.random.Generator; None: exact newtons in both fields.")
      .def_rw("counts_enabled", &FootSensors::counts_enabled,
              "True if footForce has values, else zeros.")
      .def_rw("newtons_enabled", &FootSensors::newtons_enabled,
              "True if footForceEst has values, else zeros.")
      .def_rw("offset", &FootSensors::offset, "Offsets of footForce [counts], shape (4,).")
      .def_rw("gain", &FootSensors::gain, "Gains of footForce [counts/N], shape (4,).")
      .def_rw("offset_walk", &FootSensors::offset_walk,
              "Random walk of the offsets [counts per reading].")
      .def_rw("count_noise", &FootSensors::count_noise, "Standard deviation of footForce [counts].")
      .def_rw("force_noise", &FootSensors::force_noise, "Standard deviation of footForceEst [N].")
      .def_rw("fall_blend", &FootSensors::fall_blend,
              "Share by which the measured force approaches a smaller force in a physics step.")
      .def("start", &FootSensors::start, "normal_forces"_a,
           "Start with normal forces (4,) [N] that have been constant.")
      .def("step", &FootSensors::step, "normal_forces"_a,
           "Advance by one physics step with the normal forces (4,) [N] at its end.")
      .def("read", &FootSensors::read, "normal_forces"_a,
           "Return footForce [counts] and footForceEst [N], int16 (4,), of normal forces\n"
           "(4,) [N].");
  nb::class_<ImuErrorModel>(
      m, "ImuErrorModel", "Errors of a real IMU: constant biases, white noise and a sample period.")
      .def(
          "__init__",
          [](ImuErrorModel* self, const Vector3& gyro_bias, const Vector3& accelerometer_bias,
             double gyro_noise, double accelerometer_noise, int steps, double period,
             double filter_gain, double gyro_range, double accelerometer_range) {
            new (self)
                ImuErrorModel{gyro_bias, accelerometer_bias, gyro_noise, accelerometer_noise, steps,
                              period,    filter_gain,        gyro_range, accelerometer_range};
          },
          "gyro_bias"_a, "accelerometer_bias"_a, "gyro_noise"_a, "accelerometer_noise"_a, "steps"_a,
          "period"_a, "filter_gain"_a, "gyro_range"_a, "accelerometer_range"_a,
          "Args:\n"
          "    gyro_bias: Bias of the gyroscope [rad/s], IMU axes, shape (3,).\n"
          "    accelerometer_bias: Bias of the accelerometer [m/s^2], IMU axes, shape (3,).\n"
          "    gyro_noise: Standard deviation of a sample [rad/s].\n"
          "    accelerometer_noise: Standard deviation of a sample [m/s^2].\n"
          "    steps: Number of physics steps per sample.\n"
          "    period: Sample period [s].\n"
          "    filter_gain: Gain of the attitude filter [1/s].\n"
          "    gyro_range: Largest absolute value of a gyroscope axis [rad/s].\n"
          "    accelerometer_range: Largest absolute value of an accelerometer axis [m/s^2].");
}

void bind_vibration(nb::module_& m) {
  nb::class_<Vibration>(m, "Vibration", "Vibration of the trunk at the IMU, excited by the feet.")
      .def(nb::init<const Vibration::Array6&, double, const Vibration::Coupling&, double>(),
           "frequency"_a, "damping_ratio"_a, "coupling"_a, "dt"_a,
           "Args:\n"
           "    frequency: Natural frequencies [rad/s] of gyroscope x y z and accelerometer\n"
           "        x y z, shape (6,).\n"
           "    damping_ratio: Damping ratio, above 0 and below 1.\n"
           "    coupling: Change of the values by a change of the normal forces [rad/s/N],\n"
           "        [m/s^2/N], shape (6, 4).\n"
           "    dt: Physics step [s].")
      .def("start", &Vibration::start, "forces"_a, "Start at rest with normal forces (4,) [N].")
      .def("step", &Vibration::step, "forces"_a,
           "Advance by one physics step with the normal forces (4,) [N] at its end.")
      .def_prop_ro(
          "value", [](const Vibration& v) { return Vibration::Array6(v.value()); },
          "Vibration (6,) [rad/s], [m/s^2]: gyroscope x y z, accelerometer x y z, IMU axes.");
}

void bind_physics(nb::module_& m) {
  nb::class_<MujocoState>(m, "MujocoState",
                          "Views of MuJoCo's memory, and the indices of the motors in it.")
      .def(
          "__init__",
          [](MujocoState* self, Doubles qpos, Doubles qvel, Doubles qacc, Doubles applied,
             Doubles sensordata, const Indices& motor_q, const Indices& motor_v) {
            new (self) MujocoState{qpos, qvel, qacc, applied, sensordata, motor_q, motor_v};
          },
          "qpos"_a.noconvert(), "qvel"_a.noconvert(), "qacc"_a.noconvert(),
          "qfrc_applied"_a.noconvert(), "sensordata"_a.noconvert(), "motor_q"_a, "motor_v"_a,
          "Args:\n"
          "    motor_q: Index in qpos of each motor's joint, 12 integers.\n"
          "    motor_v: Index in qvel of each motor's joint, 12 integers.");
  nb::class_<Sensors>(m, "Sensors", "Simulated sensors. They read a LowState from a MuJoCo state.")
      .def(
          "__init__",
          [](Sensors* self, const MujocoState& state, const WireFormat& wire,
             const std::array<int, 3>& site, const std::optional<ImuErrorModel>& flaws,
             const nb::object& imu_rng, const std::optional<Vibration>& vibration,
             int accelerometer_readings, const Encoders& encoders, const FootSensors& feet,
             const Eigen::Array<int, surefoot::kLegs * 3, 1>& foot_forces,
             const Vector3& ground_normal, const surefoot::LowState& rest, std::uint32_t tick0,
             double rate) {
            const double* values = state.sensordata.data();
            const ImuSite at{values + site[0], values + site[1], values + site[2]};
            const Imu imu = flaws ? Imu(at, *flaws, imu_rng) : Imu(at);
            new (self) Sensors(state, wire, imu, vibration, accelerometer_readings, encoders, feet,
                               foot_forces, ground_normal, rest, tick0, rate);
          },
          "state"_a, "wire"_a, "site"_a, "flaws"_a.none(), "imu_rng"_a.none(), "vibration"_a.none(),
          "accelerometer_readings"_a, "encoders"_a, "feet"_a, "foot_forces"_a, "ground_normal"_a,
          "rest"_a, "tick0"_a, "rate"_a,
          nb::sig("def __init__(self, state: MujocoState, wire: WireFormat, "
                  "site: tuple[int, int, int], flaws: ImuErrorModel | None, imu_rng: object, "
                  "vibration: Vibration | None, accelerometer_readings: int, encoders: Encoders, "
                  "feet: FootSensors, foot_forces: object, "
                  "ground_normal: object, rest: object, tick0: int, rate: float) -> None"),
          "Args:\n"
          "    site: Indices in sensordata of the first entries of gyro, accelerometer and\n"
          "        quaternion.\n"
          "    vibration: Vibration of the IMU; None: it does not vibrate.\n"
          "    accelerometer_readings: Number of LowStates for each new accelerometer value.")
      .def("start", &Sensors::start,
           "Start the attitude filter and the memory of the foot forces, with the robot at rest.")
      .def("read", &Sensors::read, "motors"_a,
           nb::sig("def read(self, motors: Motors) -> typing.Any"),
           "Return the LowState of the present state; each call advances its tick by one\n"
           "period.");
  nb::class_<Physics>(m, "Physics",
                      "Physics loop: MuJoCo's two half steps, with motors and sensors.")
      .def(nb::init<std::uintptr_t, std::uintptr_t, nb::object, nb::object, MujocoState>(),
           "step1"_a, "step2"_a, "model"_a, "data"_a, "state"_a,
           "Args:\n"
           "    step1: Address of mj_step1.\n"
           "    step2: Address of mj_step2.\n"
           "    model: mujoco.MjModel.\n"
           "    data: mujoco.MjData.\n"
           "    state: Views of data.")
      .def_prop_rw(
          "external_torque", [](const Physics& p) { return Array12(p.external_torque); },
          [](Physics& p, const Array12& torque) { p.external_torque = torque; },
          "External joint torques [N.m], shape (12,), added to the torques of the motors.")
      .def("advance", &Physics::advance, "steps"_a, "motors"_a, "sensors"_a,
           "Advance by a number of physics steps.");
}

}  // namespace

NB_MODULE(_plant, m) {
  m.doc() = "Physics loop of surefoot.sim.Plant. Import surefoot._core first.";
  bind_motors(m);
  bind_vibration(m);
  bind_sensors(m);
  bind_physics(m);
}

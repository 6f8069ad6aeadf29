// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/stl/array.h>

#include "bindings.hpp"
#include "surefoot/state_estimator.hpp"
#include "value_class.hpp"

using namespace nb::literals;
using namespace surefoot;

namespace {

void bind_enums(nb::module_& m) {
  nb::enum_<SensorVerdict>(m, "SensorVerdict", "What the estimator concludes about a sensor.")
      .value("GOOD", SensorVerdict::kGood, "The estimator uses the sensor.")
      .value("UNJUDGED", SensorVerdict::kUnjudged,
             "Not judged yet, because there are too few samples.")
      .value("ZERO", SensorVerdict::kZero, "The sensor reads exactly zero.")
      .value("CONSTANT", SensorVerdict::kConstant,
             "The reading stays the same while other fields of the samples change.")
      .value("SATURATED", SensorVerdict::kSaturated,
             "The reading is at the end of the sensor's range.")
      .value("DISAGREES", SensorVerdict::kDisagrees, "The reading contradicts the other sensors.")
      .value("IMPLAUSIBLE", SensorVerdict::kImplausible,
             "The reading is beyond what the sensor can measure.");
  nb::enum_<ContactSource>(m, "ContactSource",
                           "Measurement that shows whether a foot is on the ground.")
      .value("FOOT_FORCE_EST", ContactSource::kFootForceEst, "LowState.footForceEst [N].")
      .value("FOOT_FORCE", ContactSource::kFootForce,
             "LowState.footForce, raw counts, calibrated against the other sources.")
      .value("TAU_EST", ContactSource::kTauEst,
             "Foot force computed from the joint torques of the leg.")
      .value("NO_SLIP", ContactSource::kFootMotion,
             "Foot motion. A foot that rises or moves fast is off the ground.");
}

void bind_report(nb::module_& m) {
  using R = EstimatorReport;
  ValueClass<R>(m, "EstimatorReport",
                "Uncertainty of the state estimate, and verdicts on the sensors.\n\n"
                "Arrays over feet are in leg order: FR FL RR RL.")
      .def_ro("gyroscope", &R::gyroscope, "Verdict on imu.gyroscope.")
      .def_ro("accelerometer", &R::accelerometer, "Verdict on imu.accelerometer.")
      .def_ro("quaternion", &R::quaternion, "Verdict on imu.quaternion.")
      .def_ro("contact_sources", &R::contact_sources,
              "Verdicts on the contact sources, indexed [ContactSource][foot].")
      .def_ro("contact_by_source", &R::contact_by_source,
              "Contact evidence of each source alone, shape (4, 4). Rows are ContactSources,\n"
              "columns feet.\n\n"
              "0: off the ground; 1: loaded; 0.5: no evidence, or evidence for both.")
      .def_ro("foot_forces_from_torques", &R::foot_forces_from_torques,
              "Ground force on each foot [N], computed from the joint torques, world axes,\n"
              "shape (3, 4).\n\n"
              "Method: generalised-momentum observer (De Luca, Mattone 2003).")
      .def_ro("slip", &R::slip,
              "How sure the estimator is that a loaded foot slips, 0 .. 1, shape (4,).")
      .def_ro("friction", &R::friction,
              "Friction coefficient of the ground, learnt from feet that slide and hold.\n\n"
              "0.1 .. RobotConfig.friction; initially RobotConfig.friction.")
      .def_ro("armature", &R::armature,
              "Rotor inertia of each joint, learnt from legs that swing [kg.m^2], shape (12,),\n"
              "SDK motor order.\n\n"
              "Initially RobotConfig.armature.")
      .def_ro("joint_damping", &R::joint_damping,
              "Viscous friction of each joint, learnt from legs that swing [N.m.s/rad], shape\n"
              "(12,), SDK motor order.\n\n"
              "Initially 0.")
      .def_ro("joint_friction", &R::joint_friction,
              "Coulomb friction of each joint, learnt from legs that swing [N.m], shape (12,),\n"
              "SDK motor order.\n\n"
              "Initially 0.")
      .def_ro("gyroscope_bias", &R::gyroscope_bias,
              "Bias of the gyroscope [rad/s], base axes, shape (3,).")
      .def_ro("accelerometer_bias", &R::accelerometer_bias,
              "Bias of the accelerometer [m/s^2], base axes, shape (3,).")
      .def_ro("covariance", &R::covariance,
              "Covariance of the errors (estimate minus truth), shape (15, 15).\n\n"
              "Order: rotation of the base [rad], velocity of the base [m/s], position of the\n"
              "base [m], all in world axes; then gyroscope_bias, accelerometer_bias.")
      .def_ro("nis", &R::nis,
              "Normalised innovation squared of the foot measurements in the last update.")
      .def_ro("nis_dimension", &R::nis_dimension,
              "Dimension of nis, 3 for each foot that was used.")
      .def_ro("rejected_feet", &R::rejected_feet,
              "For each foot, whether the innovation gate rejected it in the last update, 4\n"
              "booleans.")
      .def_ro("sole_compliance", &R::sole_compliance,
              "Depth [m] by which a sole would yield under the weight of the robot; 0 for\n"
              "rigid soles.")
      .def_ro("f_sustained", &R::f_sustained,
              "Sustained external force [N], world axes, shape (3,).")
      .def_ro("moment_external", &R::moment_external,
              "Sustained external moment about the centre of mass [N.m], world axes, shape\n"
              "(3,).")
      .def_ro("payload", &R::payload,
              "Mass of the robot minus mass of the model [kg]; may be negative.")
      .def_ro("com_shift", &R::com_shift,
              "Shift of the centre of mass against the model, caused by the payload [m], base\n"
              "axes, shape (3,).");
}

void bind_state_estimator(nb::module_& m) {
  nb::class_<StateEstimator>(
      m, "StateEstimator",
      "Estimator of base state, contacts and external wrench from the robot's own\n"
      "sensors: LowState in, RobotState out.\n\n"
      "A contact-aided invariant extended Kalman filter (Hartley, Ghaffari, Eustice,\n"
      "Grizzle, 2020) estimates orientation, velocity, position, contact points and IMU\n"
      "biases from the raw gyroscope and accelerometer and the leg kinematics. The\n"
      "filter uses the IMU quaternion at the start. Later the filter checks the\n"
      "quaternion, and uses it if the gyroscope is zero or constant. The contact\n"
      "confidence of each foot is fused from footForceEst, footForce, joint torques and\n"
      "foot motion. These contact sources are also checked against each other.\n\n"
      "The world frame has z up; at the first sample it has the heading of the base,\n"
      "and the mean height of the feet is zero. Position and yaw are not observable, so\n"
      "both drift; report has the covariance. Not thread-safe.")
      .def(nb::init<const Robot&>(), "robot"_a, "Create an estimator with robot.config.gains.")
      .def("update", &StateEstimator::update, "low_state"_a, "dt"_a,
           "Process one sample. Never raises. Real-time: yes.\n\n"
           "Args:\n"
           "    low_state: Sample. Fields read: imu, q, dq and tauEst of motors 0 .. 11,\n"
           "        footForce, footForceEst.\n"
           "    dt: Time since the last processed sample [s], 0 < dt <= 0.1.\n\n"
           "Returns:\n"
           "    OK if the sample was processed. STALE_TICK (dt out of range), NON_FINITE or\n"
           "    IMPLAUSIBLE if the state is unchanged. DIVERGED if no motion explains the\n"
           "    samples; the estimator then starts again with the next sample. A finite\n"
           "    quaternion that is not of unit length only changes its verdict in report.")
      .def("set_stepping", &StateEstimator::set_stepping, "stepping"_a,
           "Set whether a planner lets feet step; initially False. Real-time: yes.\n\n"
           "The estimator recognises a robot that steps from its contacts too, two touchdowns\n"
           "late. Then it assumes the noise of the IMU instead of measuring it, and the payload\n"
           "stays as it was. While the planner lets feet step, it estimates no push.")
      .def_prop_ro(
          "state", [](const StateEstimator& e) { return RobotState(e.state()); },
          "State after the last processed sample, a copy.")
      .def_prop_ro(
          "report", [](const StateEstimator& e) { return EstimatorReport(e.report()); },
          "Uncertainty of the state and verdicts on the sensors, a copy.")
      .def_prop_ro("ground_friction", &StateEstimator::ground_friction,
                   "EstimatorReport.friction without the cost of a report.")
      .def_prop_ro("normal_forces_from_torques", &StateEstimator::normal_forces_from_torques,
                   "Normal force on each foot [N], computed from the joint torques, FR FL RR RL,\n"
                   "shape (4,).")
      .def_prop_ro(
          "sole_sink", &StateEstimator::sole_sink,
          "Depth by which each sole yields under its load [m], FR FL RR RL, shape (4,), see\n"
          "EstimatorReport.sole_compliance.")
      .def_prop_ro(
          "has_foot_force_est", &StateEstimator::has_foot_force_est,
          "True if footForceEst works on this robot, because its sum has matched the load\n"
          "on the feet.")
      .def("set_gains", &StateEstimator::set_gains, "gains"_a,
           "Set the gains. Raises Error and changes nothing if a gain is invalid.")
      .def("reset", &StateEstimator::reset,
           "Discard the estimate and start again with the next sample. Real-time: yes.");
}

}  // namespace

void bind_estimator(nb::module_& m) {
  bind_enums(m);
  bind_report(m);
  bind_state_estimator(m);
}

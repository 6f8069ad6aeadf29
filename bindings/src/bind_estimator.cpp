// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/eigen/dense.h>
#include <nanobind/stl/array.h>

#include "bindings.hpp"
#include "surefoot/state_estimator.hpp"

namespace nb = nanobind;
using namespace nb::literals;
using namespace surefoot;

namespace {

void bind_enums(nb::module_& m) {
  nb::enum_<SensorVerdict>(m, "SensorVerdict", "What the estimator concludes about a sensor.")
      .value("GOOD", SensorVerdict::kGood, "Used.")
      .value("UNJUDGED", SensorVerdict::kUnjudged, "Not enough has happened yet to judge it.")
      .value("ZERO", SensorVerdict::kZero, "Reads exactly zero.")
      .value("CONSTANT", SensorVerdict::kConstant, "Does not change although the robot moves.")
      .value("SATURATED", SensorVerdict::kSaturated, "At the end of its range.")
      .value("DISAGREES", SensorVerdict::kDisagrees, "Contradicts the other sensors.")
      .value("IMPLAUSIBLE", SensorVerdict::kImplausible, "Beyond what it can measure.");
  nb::enum_<ContactSource>(m, "ContactSource",
                           "Measurement that shows whether a foot is on the ground.")
      .value("FOOT_FORCE_EST", ContactSource::kFootForceEst, "footForceEst [N].")
      .value("FOOT_FORCE", ContactSource::kFootForce,
             "footForce: raw counts, calibrated against the other sources.")
      .value("TAU_EST", ContactSource::kTauEst,
             "Foot force computed from the joint torques of the leg.")
      .value("NO_SLIP", ContactSource::kNoSlip,
             "Motion of the foot: one that rises or moves fast is off the ground.");
}

void bind_report(nb::module_& m) {
  using R = EstimatorReport;
  nb::class_<R>(m, "EstimatorReport",
                "Uncertainty of the state estimate, and the estimator's view of its sensors.\n\n"
                "Feet run FR FL RR RL.")
      .def_ro("gyroscope", &R::gyroscope, "Verdict on imu.gyroscope.")
      .def_ro("accelerometer", &R::accelerometer, "Verdict on imu.accelerometer.")
      .def_ro("quaternion", &R::quaternion, "Verdict on imu.quaternion.")
      .def_ro("contact_sources", &R::contact_sources,
              "Verdicts on the contact sources, [ContactSource][foot].")
      .def_ro("contact_by_source", &R::contact_by_source,
              "Evidence of each source alone, shape (4, 4): row ContactSource, column foot.\n\n"
              "0 off the ground, 1 loaded, 0.5 no evidence.")
      .def_ro("foot_forces_from_torques", &R::foot_forces_from_torques,
              "Force of the ground on each foot by the joint torques [N], world axes, shape (3,\n"
              "4).\n\n"
              "A generalised-momentum observer (De Luca, Mattone 2003).")
      .def_ro("slip", &R::slip,
              "How sure the estimator is that a loaded foot slips, 0 .. 1, shape (4,).")
      .def_ro("gyroscope_bias", &R::gyroscope_bias,
              "Bias of the gyroscope [rad/s], base axes, shape (3,).")
      .def_ro("accelerometer_bias", &R::accelerometer_bias,
              "Bias of the accelerometer [m/s^2], base axes, shape (3,).")
      .def_ro("covariance", &R::covariance,
              "Covariance of the errors (estimate minus truth), shape (15, 15).\n\n"
              "Order: rotation of the base (world axes) [rad], its velocity [m/s] and position\n"
              "[m] in the world, gyroscope_bias, accelerometer_bias.")
      .def_ro("nis", &R::nis,
              "Normalised innovation squared of the foot measurements in the last update.")
      .def_ro("nis_dimension", &R::nis_dimension, "Dimension of nis.")
      .def_ro("rejected_feet", &R::rejected_feet,
              "Feet that the innovation gate rejected in the last update, 4 booleans.")
      .def_ro("force_external", &R::force_external,
              "Sustained external force [N], world axes, shape (3,).")
      .def_ro("moment_external", &R::moment_external,
              "Sustained external moment about the centre of mass [N.m], world axes, shape\n"
              "(3,).")
      .def_ro("payload", &R::payload, "Mass beyond the model [kg]; may be negative.")
      .def_ro("com_shift", &R::com_shift,
              "Centre of mass, loaded minus model [m], base axes, shape (3,).");
}

void bind_state_estimator(nb::module_& m) {
  nb::class_<StateEstimator>(
      m, "StateEstimator",
      "Estimator of base state, contacts and external wrench from the robot's own\n"
      "sensors: LowState in, RobotState out.\n\n"
      "A contact-aided invariant extended Kalman filter (Hartley, Ghaffari, Eustice,\n"
      "Grizzle, 2020) estimates orientation, velocity, position, contact points and IMU\n"
      "biases from the raw gyroscope and accelerometer and the leg kinematics. The\n"
      "quaternion of the IMU only initialises it, is checked against it, and replaces a\n"
      "gyroscope that has stopped. The contact confidence of each foot is fused from\n"
      "footForceEst, footForce, joint torques and foot motion, which are also checked\n"
      "against each other.\n\n"
      "The world frame has z up; at the first sample it has the heading of the base,\n"
      "and the mean height of the feet is zero. Position and yaw are not observable, so\n"
      "they drift; report has their covariance. Not thread-safe.")
      .def(nb::init<const Robot&>(), "robot"_a)
      .def("update", &StateEstimator::update, "low_state"_a, "dt"_a,
           "Process one sample. Never raises. Real-time: yes.\n\n"
           "Args:\n"
           "    low_state: IMU, joint angles, velocities and torques of motors 0 .. 11,\n"
           "        footForce and footForceEst are read.\n"
           "    dt: Time since the last processed sample [s], 0 < dt <= 0.1.\n\n"
           "Returns:\n"
           "    Status OK; STALE_TICK (dt out of range), NON_FINITE or IMPLAUSIBLE, with the\n"
           "    state unchanged; DIVERGED if no motion explains the samples: the estimator\n"
           "    then starts again with the next sample. A finite quaternion that is not of\n"
           "    unit length only lowers its own verdict in report.")
      .def_prop_ro(
          "state", [](const StateEstimator& e) { return RobotState(e.state()); },
          "Estimated state, a copy.")
      .def_prop_ro(
          "report", [](const StateEstimator& e) { return EstimatorReport(e.report()); },
          "Uncertainty of the state and verdicts on the sensors, a copy.")
      .def_prop_ro("normal_forces_from_torques", &StateEstimator::normal_forces_from_torques,
                   "Normal force on each foot by the joint torques [N], FR FL RR RL, shape (4,).")
      .def_prop_ro("has_foot_force_est", &StateEstimator::has_foot_force_est,
                   "True if footForceEst works on this robot: its sum has matched the load on the\n"
                   "feet.")
      .def("set_gains", &StateEstimator::set_gains, "gains"_a,
           "Set the gains. Raises Error and changes nothing if a gain is invalid.")
      .def("reset", &StateEstimator::reset, "Start again with the next sample. Real-time: yes.");
}

}  // namespace

void bind_estimator(nb::module_& m) {
  bind_enums(m);
  bind_report(m);
  bind_state_estimator(m);
}

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
  nb::enum_<SensorVerdict>(m, "SensorVerdict", "What a sensor is worth at present.")
      .value("GOOD", SensorVerdict::kGood, "Believed.")
      .value("UNJUDGED", SensorVerdict::kUnjudged, "Nothing has happened yet that could tell.")
      .value("ZERO", SensorVerdict::kZero, "Reads exactly zero.")
      .value("CONSTANT", SensorVerdict::kConstant, "Stands still while the robot moves.")
      .value("SATURATED", SensorVerdict::kSaturated, "At the end of its range.")
      .value("DISAGREES", SensorVerdict::kDisagrees, "Contradicts the others.")
      .value("IMPLAUSIBLE", SensorVerdict::kImplausible, "Beyond what it can measure.");
  nb::enum_<ContactSource>(m, "ContactSource", "What tells of a foot's contact.")
      .value("FOOT_FORCE_EST", ContactSource::kFootForceEst, "footForceEst: newtons.")
      .value("FOOT_FORCE", ContactSource::kFootForce, "footForce: raw counts, by their change.")
      .value("TAU_EST", ContactSource::kTauEst, "tauEst: force from the leg's joint torques.")
      .value("NO_SLIP", ContactSource::kNoSlip, "A foot that moves does not stand.");
}

void bind_report(nb::module_& m) {
  using R = EstimatorReport;
  nb::class_<R>(m, "EstimatorReport",
                "How sure the estimator is, and what it thinks of its sensors.\n\n"
                "Feet run FR FL RR RL; SI units.")
      .def_ro("gyroscope", &R::gyroscope, "Verdict on imu.gyroscope.")
      .def_ro("accelerometer", &R::accelerometer, "Verdict on imu.accelerometer.")
      .def_ro("quaternion", &R::quaternion, "Verdict on imu.quaternion.")
      .def_ro("contact_sources", &R::contact_sources, "Verdicts [ContactSource][foot].")
      .def_ro("contact_by_source", &R::contact_by_source,
              "What each source alone says, shape (4, 4): row ContactSource, column foot; 0.5 is "
              "nothing.")
      .def_ro("foot_forces_from_torques", &R::foot_forces_from_torques,
              "Ground on foot from joint torques [N], world axes, shape (3, 4).")
      .def_ro("slip", &R::slip, "How surely a standing foot slips, 0 .. 1, shape (4,).")
      .def_ro("gyroscope_bias", &R::gyroscope_bias, "[rad/s], base axes.")
      .def_ro("accelerometer_bias", &R::accelerometer_bias, "[m/s^2], base axes.")
      .def_ro("covariance", &R::covariance,
              "Shape (15, 15): errors of rotation (world axes) [rad], v_world [m/s] and p_world "
              "[m]\nof the base, gyroscope_bias, accelerometer_bias.")
      .def_ro("nis", &R::nis, "Normalised innovation squared of the last update.")
      .def_ro("nis_dimension", &R::nis_dimension, "Its dimension.")
      .def_ro("rejected_feet", &R::rejected_feet, "Feet that the innovation gate refused.")
      .def_ro("force_external", &R::force_external, "Slow force from outside [N], world axes.")
      .def_ro("moment_external", &R::moment_external,
              "Slow moment from outside about the centre of mass [N.m], world axes.")
      .def_ro("payload", &R::payload, "[kg] more than the model has.")
      .def_ro("com_shift", &R::com_shift,
              "[m] of the centre of mass from the model's to the loaded one, base axes.");
}

void bind_state_estimator(nb::module_& m) {
  nb::class_<StateEstimator>(m, "StateEstimator", "LowState in, RobotState out.")
      .def(nb::init<const Robot&>(), "robot"_a)
      .def("update", &StateEstimator::update, "low_state"_a, "dt"_a,
           "Take in one report, dt seconds after the last: Status. Never raises.")
      .def_prop_ro(
          "state", [](const StateEstimator& e) { return RobotState(e.state()); }, "A copy.")
      .def_prop_ro(
          "report", [](const StateEstimator& e) { return EstimatorReport(e.report()); }, "A copy.")
      .def_prop_ro("normal_forces_from_torques", &StateEstimator::normal_forces_from_torques,
                   "Normal force per foot [N].")
      .def_prop_ro("has_foot_force_est", &StateEstimator::has_foot_force_est,
                   "Does footForceEst live?")
      .def("set_gains", &StateEstimator::set_gains, "gains"_a, "Raise Error if one is invalid.")
      .def("reset", &StateEstimator::reset, "Begin anew with the next report.");
}

}  // namespace

void bind_estimator(nb::module_& m) {
  bind_enums(m);
  bind_report(m);
  bind_state_estimator(m);
}

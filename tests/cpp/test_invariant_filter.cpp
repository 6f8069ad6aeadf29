// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <boost/test/unit_test.hpp>
#include <random>

#include "dynamics/dynamics.hpp"
#include "estimator/filter/foot_noise.hpp"
#include "estimator/filter/invariant_filter.hpp"
#include "robot_states.hpp"
#include "surefoot/state_estimator.hpp"

using namespace surefoot;
using namespace surefoot::error_index;

namespace {

constexpr double kPeriod = 0.002;
using Covariance = Eigen::Matrix<double, kSize, kSize>;
using Column = Eigen::Matrix<double, kSize, 1>;
using Rows = Eigen::Matrix<double, 3, kSize>;

Covariance to_dense(const ErrorCovariance& P) {
  Covariance out;
  for (int i = 0; i < kSize; ++i) {
    for (int j = 0; j < kSize; ++j) out(i, j) = P(i, j);
  }
  return out;
}

double max_relative_difference(const Covariance& a, const Covariance& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

struct Random {
  std::mt19937 generator{11};
  std::normal_distribution<double> normal;
  double operator()() { return normal(generator); }
  double positive() { return 0.1 + std::abs(normal(generator)); }
  Vector3 vector() { return {normal(generator), normal(generator), normal(generator)}; }
  Matrix3 rotation() { return exp_so3(vector()).toRotationMatrix(); }

  ErrorCovariance covariance() {
    ErrorCovariance P;
    for (int i = 0; i < kSize; ++i) P.set_variance(i, 1, positive());
    // correct() with W = 0, a measurement without information, adds K S K'.
    for (int k = 0; k < 10; ++k) {
      ErrorCovariance::Columns K{};
      for (auto& column : K) {
        for (int i = 0; i < kSize; ++i) column[i] = normal(generator);
      }
      const ErrorCovariance::Columns W{};
      P.correct(W, K, Matrix3::Identity());
    }
    return P;
  }
  ErrorPropagation motion() {
    ErrorPropagation m;
    m.dt = 0.002 * positive();
    const Matrix3 R = rotation();
    m.force_jacobian = m.dt * R;
    m.rate_jacobian.middleRows<3>(kRotation) = m.dt * R;
    for (int k = kVelocity; k < kGroupSize; k += 3) {
      m.rate_jacobian.middleRows<3>(k) = m.dt * skew(vector()) * R;
    }
    m.rate_variance = positive();
    m.force_variance = positive();
    for (int leg = 0; leg < kLegs; ++leg) m.foot_variance[leg] = positive();
    m.gyroscope_drift_variance = positive();
    m.accelerometer_drift_variance = positive();
    m.vertical_drift_variance = positive();
    m.sole_drift_variance = positive();
    m.up_base = R.row(2);
    m.accelerometer_bias_decay = 1.0 / (1.0 + positive());
    return m;
  }
};

// xi' = Phi xi + noise: one Euler step of Hartley et al. 2020, eq. 52.
Covariance transition(const ErrorPropagation& m) {
  Covariance Phi = Covariance::Identity();
  Phi.block<3, 3>(kVelocity, kRotation) = m.dt * skew(Vector3(0.0, 0.0, -kGravity));
  Phi.block<3, 3>(kPosition, kVelocity) = m.dt * Matrix3::Identity();
  Phi.block<kGroupSize, 3>(0, kGyroscopeBias) = -m.rate_jacobian;
  Phi.block<3, 3>(kVelocity, kAccelerometerBias) = -m.force_jacobian;
  Phi.block<3, 3>(kAccelerometerBias, kAccelerometerBias) *= m.accelerometer_bias_decay;
  return Phi;
}

Covariance process_noise(const ErrorPropagation& m) {
  Covariance Q = Covariance::Zero();
  Q.topLeftCorner<kGroupSize, kGroupSize>() =
      m.rate_variance * m.rate_jacobian * m.rate_jacobian.transpose();
  Q.block<3, 3>(kVelocity, kVelocity) +=
      m.force_variance * m.force_jacobian * m.force_jacobian.transpose();
  for (int leg = 0; leg < kLegs; ++leg) {
    const int foot = kFeet + 3 * leg;
    Q.block<3, 3>(foot, foot) += m.foot_variance[leg] * Matrix3::Identity();
  }
  Q.block<3, 3>(kGyroscopeBias, kGyroscopeBias) = m.gyroscope_drift_variance * Matrix3::Identity();
  Q(kSole, kSole) = m.sole_drift_variance;
  Q.block<3, 3>(kAccelerometerBias, kAccelerometerBias) =
      m.accelerometer_drift_variance * Matrix3::Identity() +
      m.vertical_drift_variance * m.up_base * m.up_base.transpose();
  return Q;
}

Rows measurement(int leg) {
  Rows H = Rows::Zero();
  H.block<3, 3>(0, kPosition).setIdentity();
  H.block<3, 3>(0, kFeet + 3 * leg) = -Matrix3::Identity();
  return H;
}

void copy(const Eigen::Matrix<double, kSize, 3>& from, ErrorCovariance::Columns& to) {
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < ErrorCovariance::kPaddedSize; ++i) to[k][i] = i < kSize ? from(i, k) : 0.0;
  }
}

// Information of P on absolute position and yaw. Foot measurements must not add to it.
Eigen::Vector4d unobservable_information(const Covariance& P) {
  const Covariance information = P.inverse();
  Eigen::Vector4d out;
  out[3] = information(kRotation + 2, kRotation + 2);
  for (int axis = 0; axis < 3; ++axis) {
    Column together = Column::Zero();
    for (int part = kPosition; part < kGyroscopeBias; part += 3) together[part + axis] = 1.0;
    out[axis] = together.dot(information * together);
  }
  return out;
}

FeetInput feet_input(const FeetMatrix& y, double variance, const Vector3& lever = Vector3::Zero()) {
  FeetInput out;
  out.y_base = y;
  out.variance.setConstant(variance);
  out.lever = lever;
  return out;
}

FeetMatrix square_feet() {
  FeetMatrix feet;
  feet << 0.2, 0.2, -0.2, -0.2, -0.15, 0.15, -0.15, 0.15, 0.0, 0.02, 0.0, -0.01;
  return feet;
}

// A base that sways over standing feet, and an IMU whose readings integrate exactly to this motion.
struct SwayingBase {
  double size = 1.0;  // 0: at rest
  Vector3 gyroscope_bias = Vector3::Zero(), accelerometer_bias = Vector3::Zero();
  double noise_w = 0.0, noise_f = 0.0, noise_foot = 0.0;
  Gains gains;
  FeetMatrix feet = square_feet();
  Vector3 lever = Vector3::Zero();
  double normal_noise = 0.0;  // [rad] noise of the ground normal per tick
  InvariantFilter filter;
  Random random;
  double t = 0.0;
  Eigen::Vector4d foot_variance = Eigen::Vector4d::Constant(1e-12);

  Quaternion R(double at) const {
    return exp_so3(size * Vector3(0.1 * std::sin(5.0 * at), 0.08 * std::sin(3.0 * at + 1.0),
                                  0.2 * std::sin(2.0 * at)));
  }
  Vector3 p(double at) const {
    return Vector3(0.0, 0.0, 0.3) + size * Vector3(0.03 * std::sin(4.0 * at),
                                                   0.02 * std::sin(6.0 * at + 0.5),
                                                   0.02 * std::sin(7.0 * at));
  }
  Vector3 v(double at) const {
    return size * Vector3(0.12 * std::cos(4.0 * at), 0.12 * std::cos(6.0 * at + 0.5),
                          0.14 * std::cos(7.0 * at));
  }
  void start(const InitialSigmas& sigmas, const Quaternion& wrong = Quaternion::Identity(),
             const Vector3& wrong_v = Vector3::Zero()) {
    InitialSigmas with_sole = sigmas;
    with_sole.sole = 1e-3;  // no variance is zero, so the covariance has an inverse
    filter.reset(wrong * R(0.0), v(0.0) + wrong_v, p(0.0), feet, with_sole);
  }
  FeetMatrix foot_measurements() {
    FeetMatrix y = R(t).conjugate().toRotationMatrix() * (feet.colwise() - p(t));
    for (int leg = 0; leg < kLegs; ++leg) y.col(leg) += noise_foot * random.vector();
    return y;
  }
  void predict() {
    const Vector3 turn = log_so3(R(t).conjugate() * R(t + kPeriod));
    const Vector3 a = (v(t + kPeriod) - v(t)) / kPeriod + kGravity * Vector3::UnitZ();
    const Matrix3 halfway = Matrix3::Identity() + 0.5 * skew(turn);
    ImuInput imu;
    imu.w_base = turn / kPeriod + gyroscope_bias + noise_w * random.vector();
    imu.f_base =
        halfway.inverse() * (R(t).conjugate() * a) + accelerometer_bias + noise_f * random.vector();
    imu.w_variance = gains.noise_gyroscope * gains.noise_gyroscope;
    imu.f_variance = gains.noise_accelerometer * gains.noise_accelerometer;
    imu.dt = kPeriod;
    filter.predict(gains, imu, foot_variance);
    t += kPeriod;
  }
  void correct(const FeetMatrix& y) {
    const double sigma = gains.noise_foot_position;
    filter.correct(feet_input(y, sigma * sigma, lever), gains.gate_foot);
  }
  // Change the ground normal: a round sole then touches the ground at another point.
  void tilt_ground() {
    constexpr double kRadius = 0.02;
    const Vector3 noise = normal_noise * random.vector();
    const Vector3 tilted = kRadius * (Vector3::UnitZ() + noise).normalized();
    const FeetMatrix way = (lever - tilted).replicate<1, kLegs>();
    feet += way;
    filter.move_feet(way);
    lever = tilted;
  }
  void run(double seconds) {
    for (const double end = t + seconds - 0.5 * kPeriod; t < end;) {
      if (normal_noise > 0.0) tilt_ground();
      predict();
      correct(foot_measurements());
    }
  }
  double variance(int i) const { return filter.covariance()(i, i); }
};

// A state on the group. perturbed() applies an error xi to it.
struct State {
  Quaternion R = exp_so3(Vector3(0.3, -0.2, 0.5));
  Vector3 v{0.4, -0.3, 0.2}, p{0.5, 0.7, 0.3};
  FeetMatrix feet = square_feet();

  // R becomes dR R, and a vector x becomes dR x + xi_x, with dR = exp(xi_R). To first order this is
  // exp(xi) X.
  State perturbed(const Column& xi) const {
    State out;
    const Quaternion dR = exp_so3(xi.segment<3>(kRotation));
    out.R = dR * R;
    out.v = dR * v + xi.segment<3>(kVelocity);
    out.p = dR * p + xi.segment<3>(kPosition);
    out.feet = dR.toRotationMatrix() * feet;
    for (int leg = 0; leg < kLegs; ++leg) out.feet.col(leg) += xi.segment<3>(kFeet + 3 * leg);
    return out;
  }
  InvariantFilter filter(const InitialSigmas& sigmas = {}) const {
    InvariantFilter out;
    out.reset(R, v, p, feet, sigmas);
    return out;
  }
};

// The error of one filter against another, X_estimate X^-1; the inverse of State::perturbed().
Column error_of(const InvariantFilter& estimate, const InvariantFilter& truth) {
  Column xi = Column::Zero();
  const Quaternion dR = estimate.quaternion() * truth.quaternion().conjugate();
  xi.segment<3>(kRotation) = log_so3(dR);
  xi.segment<3>(kVelocity) = estimate.v() - dR * truth.v();
  xi.segment<3>(kPosition) = estimate.p() - dR * truth.p();
  for (int leg = 0; leg < kLegs; ++leg) {
    xi.segment<3>(kFeet + 3 * leg) = estimate.feet().col(leg) - dR * truth.feet().col(leg);
  }
  return xi;
}

ImuInput example_imu_step() {
  ImuInput imu;
  imu.w_base = Vector3(0.5, -0.8, 0.3);
  imu.f_base = Vector3(1.0, -0.5, 9.0);
  imu.dt = kPeriod;
  return imu;
}

void move(InvariantFilter& filter, const ImuInput& imu) {
  Gains gains;
  gains.gyroscope_drift = gains.accelerometer_drift = 0.0;
  filter.predict(gains, imu, Eigen::Vector4d::Zero());
}

}  // namespace

BOOST_AUTO_TEST_SUITE(invariant_filter)

BOOST_AUTO_TEST_CASE(covariance_propagation_matches_dense_products) {
  Random random;
  for (int round = 0; round < 200; ++round) {
    ErrorCovariance P = random.covariance();
    const Covariance before = to_dense(P);
    BOOST_REQUIRE(before.isApprox(before.transpose()));
    const ErrorPropagation motion = random.motion();
    P.propagate(motion);
    const Covariance Phi = transition(motion);
    const Covariance expected = Phi * before * Phi.transpose() + process_noise(motion);
    BOOST_REQUIRE(max_relative_difference(to_dense(P), expected) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(covariance_correction_matches_the_dense_joseph_form) {
  Random random;
  for (int round = 0; round < 200; ++round) {
    ErrorCovariance P = random.covariance();
    const Covariance before = to_dense(P);
    Rows H = measurement(round % kLegs);
    const Vector3 lever = round % 2 ? Vector3(0.01, -0.02, 0.03) : Vector3(Vector3::Zero());
    H.leftCols<3>() -= skew(lever);
    const Vector3 load(0.1 * (round % 3), -0.2, 0.3);
    H.col(kSole) = load;
    const Matrix3 A = random.rotation();
    const Matrix3 R = A * Vector3(0.1, 0.2, 0.5).asDiagonal() * A.transpose();
    const Eigen::Matrix<double, kSize, 3> W = before * H.transpose();
    const Matrix3 S = H * W + R;
    Eigen::Matrix<double, kSize, 3> K = W * S.inverse();
    if (round % 2) K += 0.1 * Eigen::Matrix<double, kSize, 3>::Random();
    ErrorCovariance::Columns w, k;
    P.project(round % kLegs, lever, load, w);
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < kSize; ++i) BOOST_REQUIRE(std::abs(w[j][i] - W(i, j)) < 1e-12);
    }
    copy(K, k);
    P.correct(w, k, S);
    const Covariance left = Covariance::Identity() - K * H;
    const Covariance expected = left * before * left.transpose() + K * R * K.transpose();
    BOOST_REQUIRE(max_relative_difference(to_dense(P), expected) < 1e-12);
    if (round % 2 == 0) {  // no information on unobservable states was gained
      const Eigen::Vector4d was = unobservable_information(before),
                            is = unobservable_information(to_dense(P));
      BOOST_REQUIRE((is - was).norm() < 1e-8 * was.norm());
    }
  }
}

BOOST_AUTO_TEST_CASE(covariance_stays_symmetric_and_positive_definite_over_many_updates) {
  Random random;
  ErrorCovariance P = random.covariance();
  for (int round = 0; round < 100000; ++round) {
    ErrorPropagation motion = random.motion();
    motion.rate_variance *= 1e-4;
    motion.force_variance *= 1e-2;
    motion.foot_variance *= round % 7 ? 1e-9 : 1e-2;
    motion.gyroscope_drift_variance *= 1e-10;
    motion.accelerometer_drift_variance *= 1e-8;
    motion.vertical_drift_variance *= 1e-8;
    motion.sole_drift_variance *= 1e-8;
    P.propagate(motion);
    const int leg = round % kLegs;
    ErrorCovariance::Columns W, K;
    P.project(leg, Vector3::Zero(), Vector3::Zero(), W);
    Matrix3 S;
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) S(i, k) = W[k][kPosition + i] - W[k][kFeet + 3 * leg + i];
    }
    S.diagonal().array() += 1e-6 * random.positive();
    const Matrix3 inverse = S.inverse();
    for (int k = 0; k < 3; ++k) {
      for (int i = 0; i < ErrorCovariance::kPaddedSize; ++i) {
        K[k][i] = W[0][i] * inverse(0, k) + W[1][i] * inverse(1, k) + W[2][i] * inverse(2, k);
      }
    }
    P.correct(W, K, S);
    if (round % 1000) continue;
    const Covariance now = to_dense(P);
    BOOST_REQUIRE((now == now.transpose()));
    const Covariance scale = now.diagonal().cwiseSqrt().cwiseInverse().asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scale * now * scale);
    BOOST_REQUIRE(solver.eigenvalues()[0] > 0.0);
  }
}

// Only one part has variance at first, so the columns of the covariance equal those of Phi.
BOOST_AUTO_TEST_CASE(error_propagation_matches_finite_differences_of_the_group_error) {
  const State truth;
  const ImuInput imu = example_imu_step();
  InvariantFilter moved = truth.filter();
  move(moved, imu);
  const auto difference = [&](int column) {
    const double step = 1e-5;
    Column out = Column::Zero();
    for (const double h : {step, -step}) {
      Column xi = Column::Zero();
      xi[column] = h;
      InvariantFilter off = truth.perturbed(xi).filter();
      ImuInput read = imu;  // the filter subtracts its bias from the reading
      read.w_base -= xi.segment<3>(kGyroscopeBias);
      read.f_base -= xi.segment<3>(kAccelerometerBias);
      move(off, read);
      out += error_of(off, moved) / (2.0 * h);
    }
    if (column >= kGroupSize) out[column] = 1.0;
    return out;
  };
  const auto check = [&](const InitialSigmas& sigmas, int first, int count) {
    InvariantFilter filter = truth.filter(sigmas);
    move(filter, imu);
    for (int column = first; column < first + count; ++column) {
      const Column expected = difference(column);
      for (int i = 0; i < kSize; ++i) {
        // An Euler step omits terms of second order in dt.
        BOOST_TEST(std::abs(filter.covariance()(i, column) - expected[i]) < 3e-5,
                   "row " << i << ", column " << column);
      }
    }
  };
  check({1.0, 0.0, 0.0, 0.0, 0.0}, kRotation, 2);
  check({0.0, 1.0, 0.0, 0.0, 0.0}, kVelocity, 3);
  check({0.0, 0.0, 1.0, 0.0, 0.0}, kFeet, 3 * kLegs);
  check({0.0, 0.0, 0.0, 1.0, 0.0}, kGyroscopeBias, 3);
  check({0.0, 0.0, 0.0, 0.0, 1.0}, kAccelerometerBias, 3);
}

BOOST_AUTO_TEST_CASE(large_error_propagation_does_not_depend_on_the_state) {
  Column xi = Column::Zero();
  xi.head<kGroupSize>() = 0.6 * Column::Random().head<kGroupSize>();
  State here, there;
  there.R = exp_so3(Vector3(-1.0, 0.8, 2.0));
  there.v = Vector3(-3.0, 2.0, 1.0);
  there.p = Vector3(10.0, -20.0, 2.0);
  InvariantFilter a = here.filter(), a_off = here.perturbed(xi).filter();
  InvariantFilter b = there.filter(), b_off = there.perturbed(xi).filter();
  for (int tick = 0; tick < 200; ++tick) {
    ImuInput imu = example_imu_step();
    imu.w_base.x() += 0.01 * tick;
    for (InvariantFilter* one : {&a, &a_off, &b, &b_off}) move(*one, imu);
  }
  BOOST_TEST((error_of(a_off, a) - error_of(b_off, b)).norm() < 1e-10);
  BOOST_TEST((error_of(a_off, a) - xi).norm() > 0.5);
}

BOOST_AUTO_TEST_CASE(specific_force_is_rotated_by_half_of_the_ticks_rotation) {
  const State start;
  ImuInput imu = example_imu_step();
  imu.w_base *= 5.0;
  InvariantFilter filter = start.filter();
  move(filter, imu);
  const int parts = 1000;
  Vector3 v = start.v;
  for (int k = 0; k < parts; ++k) {
    const Quaternion R = start.R * exp_so3((k + 0.5) / parts * kPeriod * imu.w_base);
    v += kPeriod / parts * (R * imu.f_base - kGravity * Vector3::UnitZ());
  }
  BOOST_TEST((filter.v() - v).norm() < 2e-6);
  BOOST_TEST((filter.v() - start.v).norm() > 1e-3);
}

BOOST_FIXTURE_TEST_CASE(velocity_is_estimated_while_the_base_sways, SwayingBase) {
  const Quaternion wrong(Eigen::AngleAxisd(0.1, Vector3(1, 1, 0).normalized()));
  start({0.3, 0.5, 0.002, 0.0, 0.0}, wrong, Vector3(0.2, -0.1, 0.1));
  run(3.0);
  for (int k = 0; k < 20; ++k) {
    run(0.1);
    BOOST_TEST((filter.v() - v(t)).norm() < 1e-3);
    BOOST_TEST((filter.R_world_base().row(2) - R(t).toRotationMatrix().row(2)).norm() < 2e-3);
    BOOST_TEST(filter.nis_dimension() == 12);
  }
}

BOOST_FIXTURE_TEST_CASE(gyroscope_and_accelerometer_biases_are_estimated, SwayingBase) {
  gyroscope_bias = Vector3(0.015, -0.01, 0.02);
  accelerometer_bias = Vector3(0.0, 0.0, 0.1);
  size = 0.0;
  start({0.05, 0.5, 0.002, 0.02, 0.1});
  run(20.0);
  BOOST_TEST((filter.gyroscope_bias() - gyroscope_bias).norm() < 1e-3);
  BOOST_TEST(std::abs(filter.accelerometer_bias().z() - 0.1) < 5e-3);
  // The same with noise, while the base sways: now all three axes are observable.
  SwayingBase moving;
  moving.gyroscope_bias = gyroscope_bias;
  moving.accelerometer_bias = Vector3(0.08, -0.06, 0.1);
  moving.noise_w = 0.01;
  moving.noise_f = 0.1;
  moving.noise_foot = 0.002;
  moving.start({0.05, 0.5, 0.002, 0.02, 0.1});
  moving.run(60.0);
  BOOST_TEST((moving.filter.gyroscope_bias() - gyroscope_bias).norm() < 3e-3);
  for (int k = 0; k < 3; ++k) {
    const double off = moving.filter.accelerometer_bias()[k] - moving.accelerometer_bias[k];
    BOOST_TEST(std::abs(off) < 3.0 * std::sqrt(moving.variance(kAccelerometerBias + k)));
  }
}

BOOST_AUTO_TEST_CASE(unobservable_yaw_and_position_gain_no_information) {
  for (const double size : {0.0, 1.0}) {
    SwayingBase sway;
    sway.size = size;
    sway.noise_foot = 1e-3;
    sway.start({0.05, 0.5, 0.002, 0.02, 0.1});
    sway.run(0.1);
    Eigen::Vector4d known = unobservable_information(to_dense(sway.filter.covariance()));
    for (int k = 0; k < 100; ++k) {
      sway.run(0.1);
      const Eigen::Vector4d now = unobservable_information(to_dense(sway.filter.covariance()));
      BOOST_TEST((now.array() <= known.array() * (1.0 + 1e-6)).all());
      known = now;
    }
    // The variance of the position alone varies by up to 1 % with the sway.
    const double slack = size > 0.0 ? 0.99 : 1.0;
    double yaw = sway.variance(kRotation + 2), x = sway.variance(kPosition);
    const double start = x;
    for (int k = 0; k < 100; ++k) {
      sway.run(0.1);
      BOOST_TEST(sway.variance(kRotation + 2) >= yaw);
      BOOST_TEST(sway.variance(kPosition) >= slack * x);
      yaw = sway.variance(kRotation + 2);
      x = sway.variance(kPosition);
    }
    BOOST_TEST(x >= start);
    if (size > 0.0) continue;
    // At rest a tilt and a horizontal accelerometer bias cannot be told apart.
    BOOST_TEST(std::sqrt(sway.variance(kAccelerometerBias)) > 0.8 * 0.1);
    BOOST_TEST(std::sqrt(sway.variance(kAccelerometerBias + 1)) > 0.8 * 0.1);
    BOOST_TEST(std::sqrt(sway.variance(kAccelerometerBias + 2)) < 0.3 * 0.1);
  }
}

// At rest a tilt and a horizontal bias look the same. Noise must not change either of them.
BOOST_AUTO_TEST_CASE(noise_at_rest_does_not_change_the_accelerometer_bias) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    SwayingBase sway;
    sway.size = 0.0;
    sway.random.generator.seed(seed);
    sway.gains.noise_gyroscope = sway.noise_w = 0.01;
    sway.gains.noise_accelerometer = sway.noise_f = 0.1;
    sway.gains.noise_foot_position = sway.noise_foot = 3e-4;
    sway.gains.accelerometer_drift = 0.0;
    sway.start({0.05, 0.5, 0.002, 0.02, 0.3});
    sway.run(60.0);
    const Vector3 early = sway.filter.accelerometer_bias();
    sway.run(240.0);
    const Vector3 learnt = sway.filter.accelerometer_bias() - early;
    // Linearisation at each tick's attitude would give 26e-4 or more.
    BOOST_TEST(learnt.head<2>().norm() < 5e-4);
  }
}

// The ground normal is computed from the estimated feet, so its noise is no new information.
BOOST_AUTO_TEST_CASE(ground_normal_noise_gives_no_information_on_tilt_or_bias) {
  const auto bias_variance_after = [](double normal_noise) {
    SwayingBase sway;
    sway.size = 0.0;
    sway.normal_noise = normal_noise;
    sway.gains.noise_foot_position = 2e-6;
    sway.start({0.05, 0.5, 0.002, 0.02, 0.1});
    sway.run(30.0);
    return Eigen::Vector2d(sway.variance(kAccelerometerBias),
                           sway.variance(kAccelerometerBias + 1));
  };
  const Eigen::Vector2d share = bias_variance_after(1e-3).cwiseQuotient(bias_variance_after(1e-9));
  // Linearisation at each tick's lever would leave almost nothing.
  BOOST_TEST(share.minCoeff() > 0.99);
}

// Standing feet make a vertical bias observable, so a step of it must not change the tilt.
BOOST_AUTO_TEST_CASE(step_of_the_vertical_bias_is_estimated_within_1_to_6_s) {
  const auto check_bias_step = [](double jump, double noise, double seconds) {
    SwayingBase sway;
    sway.size = 0.0;
    sway.noise_foot = 3e-4;
    sway.gains.noise_accelerometer = std::max(noise, 0.05);
    sway.noise_f = noise;
    sway.start({0.05, 0.5, 0.002, 0.02, 0.1});
    sway.run(60.0);
    sway.accelerometer_bias.z() += jump;
    sway.run(seconds);
    const Vector3 off = sway.filter.accelerometer_bias() - sway.accelerometer_bias;
    BOOST_TEST(std::abs(off.z()) < 0.15 * std::abs(jump));
    BOOST_TEST(off.head<2>().norm() < 0.05);
    const double up = sway.filter.R_world_base()(2, 2);
    BOOST_TEST(up > std::cos(0.005));
  };
  for (const double jump : {0.7, -0.7}) {
    check_bias_step(jump, 0.05, 1.0);
    check_bias_step(jump, 0.45, 6.0);  // 6 s: three times sigma sqrt(dt) / drift
  }
}

// A smaller rotation may be noise of the estimate. After a larger one the error dynamics are
// linearised at the new attitude.
BOOST_AUTO_TEST_CASE(error_dynamics_are_recomputed_after_10_mrad_of_rotation) {
  Gains gains;
  gains.accelerometer_drift = gains.accelerometer_drift_vertical = 0.0;
  State level;
  level.R.setIdentity();
  // The covariance of (v_y, b_x) is -dt sigma^2 times the sum of R_yx over the ticks.
  const auto turned = [&](std::initializer_list<double> headings) {
    InvariantFilter filter = level.filter({0.0, 0.0, 0.0, 0.0, 1.0});
    ImuInput imu;
    imu.f_base = kGravity * Vector3::UnitZ();
    imu.dt = 0.002;
    double last = 0.0, before = 0.0, now = 0.0;
    for (const double heading : headings) {
      imu.w_base.z() = (heading - last) / imu.dt;
      last = heading;
      filter.predict(gains, imu, Eigen::Vector4d::Zero());
      imu.w_base.z() = 0.0;
      before = filter.covariance()(kVelocity + 1, kAccelerometerBias);
      filter.predict(gains, imu, Eigen::Vector4d::Zero());
      now = filter.covariance()(kVelocity + 1, kAccelerometerBias);
    }
    return (before - now) / imu.dt;
  };
  const auto near = boost::test_tools::tolerance(1e-3);
  BOOST_TEST(std::abs(turned({0.009})) < 1e-9);
  BOOST_TEST(turned({0.011}) == std::sin(0.011), near);
  BOOST_TEST(turned({0.011, 0.020}) == std::sin(0.011), near);
  BOOST_TEST(turned({0.011, 0.022}) == std::sin(0.022), near);
}

BOOST_AUTO_TEST_CASE(measurement_is_recomputed_after_10_mrad_of_lever_rotation) {
  State level;
  level.R.setIdentity();
  const Vector3 lever(0.0, 0.0, 1.0);  // long lever and accurate feet: the lever dominates
  const auto lean = [&](double angle) { return exp_so3(Vector3(angle, 0.0, 0.0)) * lever; };
  const auto after = [&](std::initializer_list<double> angles) {
    InvariantFilter filter = level.filter({0.3, 0.0, 0.001, 0.0, 0.0});
    const FeetMatrix y = filter.R_world_base().transpose() * (filter.feet().colwise() - filter.p());
    for (const double& angle : angles) {
      // All corrections but the last have almost no information; they only set the lever.
      const bool measures = &angle == std::prev(angles.end());
      filter.correct(feet_input(y, measures ? 1e-6 : 1e15, lean(angle)), 4.0);
    }
    return to_dense(filter.covariance());
  };
  BOOST_TEST(max_relative_difference(after({0.0, 0.009}), after({0.0})) < 1e-9);
  BOOST_TEST(max_relative_difference(after({0.0, 0.011}), after({0.011})) < 1e-9);
  BOOST_TEST(max_relative_difference(after({0.0, 0.011}), after({0.0})) > 1e-4);
  BOOST_TEST(max_relative_difference(after({0.0, 0.011, 0.020}), after({0.011})) < 1e-9);
}

BOOST_AUTO_TEST_CASE(accelerometer_bias_variance_converges_to_its_initial_value) {
  Gains gains;
  gains.accelerometer_drift = 0.02;
  gains.start_accelerometer_bias = 0.1;
  const double forgets = 50.0;  // [s] time constant of the bias, 2 (start / drift)^2
  ImuInput imu;
  imu.f_base = kGravity * Vector3::UnitZ();
  imu.dt = 0.01;
  const auto variance_after = [&](double sigma) {
    State level;
    level.R.setIdentity();  // level: only the z bias has the extra vertical drift
    InvariantFilter filter = level.filter({0.0, 0.0, 0.0, 0.0, sigma});
    for (int k = 0; k < 4.0 * forgets / imu.dt; ++k) {
      filter.predict(gains, imu, Eigen::Vector4d::Zero());
    }
    return filter.covariance()(kAccelerometerBias, kAccelerometerBias);
  };
  BOOST_TEST(variance_after(0.1) == 0.01, boost::test_tools::tolerance(1e-3));
  BOOST_TEST(variance_after(0.0) == 0.01, boost::test_tools::tolerance(1e-3));
  BOOST_TEST(variance_after(0.5) == 0.01, boost::test_tools::tolerance(2e-2));

  SwayingBase sway;  // at rest the vertical bias is observable
  sway.size = 0.0;
  sway.accelerometer_bias = Vector3(0.0, 0.0, 0.08);
  sway.start({0.05, 0.5, 0.002, 0.02, 0.1});
  sway.run(10.0);
  const double learnt = sway.filter.accelerometer_bias().z();
  BOOST_TEST(std::abs(learnt - 0.08) < 0.02);
  for (int k = 0; k < forgets / imu.dt; ++k) {
    sway.filter.predict(gains, imu, Eigen::Vector4d::Zero());
  }
  BOOST_TEST(sway.filter.accelerometer_bias().z() == learnt * std::exp(-1.0),
             boost::test_tools::tolerance(1e-3));
}

BOOST_FIXTURE_TEST_CASE(jumping_foot_measurement_is_rejected, SwayingBase) {
  size = 0.0;
  start({0.05, 0.5, 0.002, 0.02, 0.1});
  run(2.0);
  const Vector3 p_before = filter.p(), foot_before = filter.feet().col(FL_);
  feet.col(FL_).x() += 0.05;
  run(kPeriod);
  BOOST_TEST((filter.rejected_feet()[FL_] && !filter.rejected_feet()[FR_] &&
              !filter.rejected_feet()[RL_]));
  BOOST_TEST(filter.nis_dimension() == 9);
  BOOST_TEST((filter.p() - p_before).norm() < 1e-5);
  BOOST_TEST((filter.feet().col(FL_) - foot_before).norm() < 1e-5);
}

BOOST_FIXTURE_TEST_CASE(foot_innovation_between_one_and_five_gates_is_downweighted, SwayingBase) {
  size = 0.0;
  foot_variance.setConstant(1e-8);
  start({0.05, 0.5, 0.002, 0.02, 0.1});
  run(2.0);
  predict();
  const auto pull = [&](double jump, double gate) {
    InvariantFilter one = filter;
    FeetMatrix y = foot_measurements();
    y.col(FL_).x() += jump;
    one.correct(feet_input(y, 4e-6), gate);
    BOOST_TEST(!one.rejected_feet()[FL_]);
    return one.feet().col(FL_).x() - filter.feet().col(FL_).x();
  };
  BOOST_TEST(pull(0.02, 100.0) > 0.0);
  BOOST_TEST(pull(0.02, 4.0) > 0.0);
  BOOST_TEST(pull(0.02, 4.0) < 0.5 * pull(0.02, 100.0));
  BOOST_TEST(pull(0.02, 4.0) < pull(0.0081, 4.0) + 1e-9);  // no more than at the gate
  BOOST_TEST(std::abs(pull(0.004, 4.0) - pull(0.004, 100.0)) < 1e-12);
}

BOOST_AUTO_TEST_CASE(foot_noise_is_estimated_from_innovations) {
  SwayingBase sway;
  sway.size = 0.0;
  sway.noise_foot = 0.006;  // three times the initial value
  sway.start({0.05, 0.5, 0.002, 0.02, 0.1});
  FootNoise noise;
  noise.reset(sway.gains);
  const std::array<bool, kLegs> standing{true, true, true, false};
  const auto run = [&](double seconds) {
    for (int k = 0; k < seconds / kPeriod; ++k) {
      sway.predict();
      FeetInput feet = feet_input(sway.foot_measurements(), 0.0);
      feet.variance = noise.variance();
      sway.filter.correct(feet, sway.gains.gate_foot);
      noise.update(sway.filter.foot_nis(), sway.filter.predicted_variance(), standing, kPeriod);
    }
  };
  run(2.0);
  const Eigen::Vector4d sigma = noise.variance().cwiseSqrt();
  BOOST_TEST(((sigma.head<3>().array() / 0.006 - 1.0).abs() < 0.25).all());
  BOOST_TEST(sigma[RL_] == sway.gains.noise_foot_position);
  sway.noise_foot = 0.0006;
  run(3.0);
  BOOST_TEST(noise.variance()[FR_] < 0.0009 * 0.0009);
  BOOST_TEST(noise.variance()[FR_] > 0.0004 * 0.0004);
}

BOOST_AUTO_TEST_CASE(resting_robot_has_zero_velocity_and_feet_at_height_zero) {
  const Robot robot = quadruped();
  StateEstimator estimator(robot);
  for (std::uint32_t tick = 0; tick < 1000; ++tick) {
    BOOST_TEST((estimator.update(resting_sample(robot, 2 * tick), kPeriod) == Status::kOk));
  }
  BOOST_TEST(estimator.state().v.norm() < 1e-3);
  for (const LegDynamics& leg : estimator.dynamics().legs()) {
    BOOST_TEST(std::abs(leg.p_world_contact.z()) < 1e-4);
  }
  const EstimatorReport report = estimator.report();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(report.covariance);
  BOOST_TEST(solver.eigenvalues()[0] > -1e-12);
  BOOST_TEST(std::abs(report.payload) < 0.05);
  BOOST_TEST(report.nis_dimension == 12);
}

BOOST_AUTO_TEST_SUITE_END()

// SPDX-License-Identifier: BSD-3-Clause
// qpOASES through casadi::conic, because the casadi wheel has the library of qpOASES but not its
// headers. The wrapper copies the data and converts A from columns to rows. Both are timed.
#include <algorithm>
#include <casadi/casadi.hpp>
#include <limits>

#include "adapter.hpp"

namespace bench {

namespace {

namespace cs = casadi;

class Qpoases : public Adapter {
 public:
  explicit Qpoases(const Setup& s)
      : setup_(s),
        rows_(s.n_eq + s.n_in),
        H_(s.n * s.n),
        A_(rows_ * s.n),
        g_(s.n),
        lower_(rows_),
        upper_(rows_),
        no_lower_(s.n, -std::numeric_limits<double>::infinity()),
        no_upper_(s.n, std::numeric_limits<double>::infinity()),
        x_(s.n),
        multipliers_(rows_) {
    make();
  }

  Description describe() const override {
    return {"qpoases", "c++ (casadi::conic)", PEER_VERSION,
            "SQProblem, dense; the settings of setToMPC() (no ramping, far bounds, flipping or NZC "
            "tests; regularisation), equalities kept active, hessian posdef; nWSR 500",
            "hotstart() from the last tick with new matrices; after a failure, a new solver object "
            "(not timed) and a cold start (timed)"};
  }
  void clear_warm_start() override { make(); }
  void load_problem(const Problem& p) override {
    if (!succeeded_) make();  // qpOASES does not recover from a failure by itself
    std::copy_n(p.H, p.n * p.n, H_.begin());
    std::copy_n(p.g, p.n, g_.begin());
    for (int j = 0; j < p.n; ++j) {
      for (int i = 0; i < p.n_eq; ++i) A_[j * rows_ + i] = p.A[i * p.n + j];
      for (int i = 0; i < p.n_in; ++i) A_[j * rows_ + p.n_eq + i] = p.C[i * p.n + j];
    }
    std::copy_n(p.b, p.n_eq, lower_.begin());
    std::copy_n(p.b, p.n_eq, upper_.begin());
    std::copy_n(p.l, p.n_in, lower_.begin() + p.n_eq);
    std::copy_n(p.u, p.n_in, upper_.begin() + p.n_eq);
  }
  SolveStatus solve() override {
    succeeded_ = false;
    try {
      solver_(arg_.data(), res_.data(), iw_.data(), w_.data(), memory_);
      succeeded_ = solver_.stats(memory_).at("success");
    } catch (const std::exception&) {
      return SolveStatus::kFailed;
    }
    return succeeded_ ? SolveStatus::kSolved : SolveStatus::kFailed;
  }
  int iterations() const override { return -1; }  // -1: the wrapper does not report iterations
  void read_solution(Solution& a) const override {
    a.x = x_;
    std::copy_n(multipliers_.begin(), setup_.n_eq, a.y.begin());
    std::copy_n(multipliers_.begin() + setup_.n_eq, setup_.n_in, a.z.begin());
  }

 private:
  void make() {
    const cs::Dict options = {{"printLevel", "none"},          {"hessian_type", "posdef"},
                              {"enableRamping", false},        {"enableFarBounds", false},
                              {"enableFlippingBounds", false}, {"enableNZCTests", false},
                              {"enableRegularisation", true},  {"enableEqualities", true},
                              {"numRegularisationSteps", 1},   {"nWSR", 500},
                              {"error_on_fail", false}};
    solver_ = cs::conic("s", "qpoases",
                        {{"h", cs::Sparsity::dense(setup_.n, setup_.n)},
                         {"a", cs::Sparsity::dense(rows_, setup_.n)}},
                        options);
    arg_.assign(solver_.sz_arg(), nullptr);
    res_.assign(solver_.sz_res(), nullptr);
    iw_.resize(solver_.sz_iw());
    w_.resize(solver_.sz_w());
    arg_[cs::CONIC_H] = H_.data();
    arg_[cs::CONIC_G] = g_.data();
    arg_[cs::CONIC_A] = A_.data();
    arg_[cs::CONIC_LBA] = lower_.data();
    arg_[cs::CONIC_UBA] = upper_.data();
    arg_[cs::CONIC_LBX] = no_lower_.data();
    arg_[cs::CONIC_UBX] = no_upper_.data();
    res_[cs::CONIC_X] = x_.data();
    res_[cs::CONIC_LAM_A] = multipliers_.data();
    memory_ = solver_.checkout();
  }

  Setup setup_;
  int rows_;
  std::vector<double> H_, A_, g_, lower_, upper_, no_lower_, no_upper_, x_, multipliers_;
  cs::Function solver_;
  std::vector<const double*> arg_;
  std::vector<double*> res_;
  std::vector<casadi_int> iw_;
  std::vector<double> w_;
  int memory_ = 0;
  bool succeeded_ = true;
};

}  // namespace

std::unique_ptr<Adapter> make_adapter(const Setup& setup) {
  return std::make_unique<Qpoases>(setup);
}

}  // namespace bench

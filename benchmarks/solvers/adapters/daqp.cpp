// SPDX-License-Identifier: BSD-3-Clause
// DAQP through its C interface: dual active-set method on dense data.
#include <daqp/api.h>
#include <daqp/utils.h>

#include <algorithm>

#include "adapter.hpp"

namespace bench {

namespace {

constexpr int kEquality = ACTIVE | IMMUTABLE;
constexpr int kAllData = UPDATE_Rinv | UPDATE_M | UPDATE_v | UPDATE_d;

class Daqp : public Adapter {
 public:
  explicit Daqp(const Setup& s)
      : setup_(s),
        rows_(s.n_eq + s.n_in),
        H_(s.n * s.n),
        f_(s.n),
        A_(rows_ * s.n),
        upper_(rows_),
        lower_(rows_),
        sense_(rows_, 0),
        x_(s.n),
        multipliers_(rows_) {
    std::fill_n(sense_.begin(), s.n_eq, kEquality);
    problem_ = {s.n,           rows_,        0, H_.data(), f_.data(), A_.data(), upper_.data(),
                lower_.data(), sense_.data()};
    result_.x = x_.data();
    result_.lam = multipliers_.data();
  }
  ~Daqp() override { release(); }

  Description describe() const override {
    return {"daqp", "c", PEER_VERSION,
            "primal_tol as requested (DAQP's default is 1e-6), all else default; update_ldp() with "
            "all data, then daqp_solve()",
            "working set of the last tick, factorised again (activate_constraints)"};
  }
  void clear_warm_start() override { cold_ = true; }
  void load_problem(const Problem& p) override {
    std::copy_n(p.H, p.n * p.n, H_.begin());
    std::copy_n(p.g, p.n, f_.begin());
    std::copy_n(p.A, p.n_eq * p.n, A_.begin());
    std::copy_n(p.C, p.n_in * p.n, A_.begin() + p.n_eq * p.n);
    const auto bound = [](double v) { return std::clamp(v, -DAQP_INF, DAQP_INF); };
    std::copy_n(p.b, p.n_eq, upper_.begin());
    std::copy_n(p.b, p.n_eq, lower_.begin());
    std::transform(p.u, p.u + p.n_in, upper_.begin() + p.n_eq, bound);
    std::transform(p.l, p.l + p.n_in, lower_.begin() + p.n_eq, bound);
  }
  SolveStatus solve() override {
    if (!started_ && !start()) return SolveStatus::kFailed;
    // `sense` keeps the working set from tick to tick; UPDATE_sense discards it.
    bool ready = update(cold_ ? kAllData | UPDATE_sense : kAllData);
    if (!ready && !cold_) ready = update(kAllData | UPDATE_sense);
    cold_ = false;
    result_.iter = 0;
    if (!ready) return SolveStatus::kFailed;
    daqp_solve(&result_, &work_);
    return result_.exitflag == EXIT_OPTIMAL ? SolveStatus::kSolved : SolveStatus::kFailed;
  }
  int iterations() const override { return result_.iter; }
  void read_solution(Solution& a) const override {
    a.x = x_;
    std::copy_n(multipliers_.begin(), setup_.n_eq, a.y.begin());
    std::copy_n(multipliers_.begin() + setup_.n_eq, setup_.n_in, a.z.begin());
  }

 private:
  // setup_daqp() needs the data of the first QP. If setup_daqp() fails, it frees the workspace.
  bool start() {
    work_ = {};
    allocate_daqp_settings(&work_);
    work_.settings->primal_tol = setup_.tolerance;
    double time = 0.0;
    started_ = setup_daqp(&problem_, &work_, &time) >= 0;
    return started_;
  }
  bool update(int mask) {
    if (update_ldp(mask, &work_) < 0) return false;
    reset_daqp_workspace(&work_);
    return activate_constraints(&work_) >= 0;
  }
  void release() {
    if (!started_) return;
    free_daqp_workspace(&work_);
    free_daqp_ldp(&work_);
  }

  Setup setup_;
  int rows_;
  std::vector<double> H_, f_, A_, upper_, lower_;
  std::vector<int> sense_;
  std::vector<double> x_, multipliers_;
  DAQPProblem problem_{};
  DAQPWorkspace work_{};
  DAQPResult result_{};
  bool started_ = false, cold_ = true;
};

}  // namespace

std::unique_ptr<Adapter> make_adapter(const Setup& setup) { return std::make_unique<Daqp>(setup); }

}  // namespace bench

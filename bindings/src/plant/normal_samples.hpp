// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <utility>

namespace surefoot::plant {

namespace nb = nanobind;

/// Standard normal numbers of a numpy.random.Generator, in its own order, drawn in blocks: a call
/// to Python for every number would take longer than the physics.
class NormalSamples {
 public:
  explicit NormalSamples(nb::object rng) : rng_(std::move(rng)) {}

  double next() {
    if (index_ == kBlock) refill();
    return block_.data()[index_++];
  }

 private:
  using Block = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
  static constexpr int kBlock = 1020;  // whole readings of 6, 12

  void refill() {
    block_ = nb::cast<Block>(rng_.attr("standard_normal")(kBlock));
    index_ = 0;
  }

  nb::object rng_;
  Block block_;
  int index_ = kBlock;
};

}  // namespace surefoot::plant

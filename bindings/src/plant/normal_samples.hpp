// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <utility>

namespace surefoot::plant {

namespace nb = nanobind;

/// Standard normal samples, in the order of a numpy.random.Generator. The samples are drawn in
/// blocks, because one Python call per sample would take longer than the physics.
class NormalSamples {
 public:
  explicit NormalSamples(nb::object rng) : rng_(std::move(rng)) {}

  /// Return the next sample.
  double next() {
    if (index_ == kBlock) refill();
    return block_.data()[index_++];
  }

 private:
  using Block = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
  // Number of samples per block. Chosen: about 1000, so that Python calls are rare; a multiple of
  // 4, 6 and 12, the samples per reading. Another number changes the runs of a seed.
  static constexpr int kBlock = 1020;

  void refill() {
    block_ = nb::cast<Block>(rng_.attr("standard_normal")(kBlock));
    index_ = 0;
  }

  nb::object rng_;
  Block block_;
  int index_ = kBlock;
};

}  // namespace surefoot::plant

// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/friction_cone.hpp"

#include <array>
#include <cmath>

namespace surefoot {

namespace {

struct Directions {
  std::array<double, kFacets> cosine, sine;
  Directions() {
    for (int k = 0; k < kFacets; ++k) {
      const double angle = 2.0 * M_PI * (k + 0.5) / kFacets;
      cosine[k] = std::cos(angle);
      sine[k] = std::sin(angle);
    }
  }
};

const Directions kDirections;

}  // namespace

ConeRows friction_cone(const Vector3& normal, double friction) noexcept {
  const Vector3 lateral = normal.cross(Vector3::UnitX()).normalized();
  const Vector3 forward = lateral.cross(normal);
  // Seen along the normal, the facets are chords of the friction circle. So the edges of the
  // pyramid touch the cone from inside.
  const Vector3 inward = friction * std::cos(M_PI / kFacets) * normal;
  ConeRows rows;
  for (int k = 0; k < kFacets; ++k) {
    rows.row(k) = kDirections.cosine[k] * forward + kDirections.sine[k] * lateral - inward;
  }
  return rows;
}

}  // namespace surefoot

#pragma once
#include <cstdlib>
namespace surefoot {
struct TmpGains {
  static double env(const char* n, double d) { const char* s = std::getenv(n); return s ? std::atof(s) : d; }
  double walk_gait_period = env("WGP", 6.0), walk_gait_duty = env("WGD", 0.8), walk_gait_margin = env("WGM", 0.1),
         walk_gait_swing_height = env("WGH", 0.3), walk_gait_speed = env("WGS", 0.18), walk_gait_turn_speed = env("WGT", 0.12);
  double order = env("ORD", 0), gap = env("GAP", 0.0), fb = env("FB", 1.0), shift = env("SH", 1.0);
};
inline const TmpGains tmp_gains;
}

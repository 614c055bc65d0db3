// The two hypotheses of a sequential test, and its decision.
#pragma once

#include <string_view>

#include "base/text/enum_names.h"

namespace cls::league {

/// Hypotheses about the mean of independent samples, which are scaled to 0 to 1. H0: it is at most
/// `mean0`; H1: it is at least `mean1`, which is above `mean0`. `alpha` is the probability to
/// accept H1 when H0 is true, `beta` the probability to accept H0 when H1 is true.
struct Hypotheses {
  double mean0 = 0.5;
  double mean1 = 0.5;
  double alpha = 0.05;
  double beta = 0.05;
};

/// What a comparison of two teams asks unless told otherwise: H0 is a gain of `kUsualElo0` Elo at
/// most, H1 one of `kUsualElo1` at least.
inline constexpr double kUsualElo0 = 0.0;
inline constexpr double kUsualElo1 = 40.0;

enum class Decision { kOpen, kH0, kH1 };

inline constexpr auto kDecisions = base::enum_names<Decision>("open", "H0", "H1");

constexpr std::string_view name(Decision decision) { return kDecisions.name(decision); }

}  // namespace cls::league

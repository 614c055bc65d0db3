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

enum class Decision { kOpen, kH0, kH1 };

inline constexpr auto kDecisions = base::enum_names<Decision>("open", "H0", "H1");

constexpr std::string_view name(Decision decision) { return kDecisions.name(decision); }

}  // namespace cls::league

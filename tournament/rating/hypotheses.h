// The two hypotheses of a sequential test, and its decision.
#pragma once

#include <string_view>

namespace cls::tournament {

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

constexpr std::string_view name(Decision decision) {
  switch (decision) {
    case Decision::kOpen:
      return "open";
    case Decision::kH0:
      return "H0";
    case Decision::kH1:
      return "H1";
  }
  return "";
}

}  // namespace cls::tournament

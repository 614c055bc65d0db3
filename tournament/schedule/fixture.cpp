// Results as text.
#include "tournament/schedule/fixture.h"

#include <fmt/format.h>

namespace cls::tournament {
namespace {

// "2:1", or "1:2" when swapped.
std::string ratio(int left, int right, bool swapped) {
  return swapped ? fmt::format("{}:{}", right, left) : fmt::format("{}:{}", left, right);
}

}  // namespace

std::string result_text(const Outcome& outcome, bool swapped) {
  if (outcome.annulled) return "annulled";
  if (!outcome.counts()) return std::string(name(outcome.end_reason));
  std::string text = ratio(outcome.left_score, outcome.right_score, swapped);
  if (had_shoot_out(outcome)) {
    text +=
        fmt::format(" ({} pen)", ratio(*outcome.left_penalties, *outcome.right_penalties, swapped));
  }
  return text;
}

}  // namespace cls::tournament

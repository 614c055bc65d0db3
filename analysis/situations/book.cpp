// Names of classes, and the draw of a match's situations.
#include "analysis/situations/book.h"

#include <algorithm>
#include <span>

#include "soccer/random.h"

namespace cls::analysis {
namespace {

constexpr std::array<std::string_view, kSituationClasses> kClassNames = {"attack", "defense",
                                                                         "set_play", "turnover"};

}  // namespace

std::string_view name(SituationClass kind) { return kClassNames[static_cast<std::size_t>(kind)]; }

std::optional<SituationClass> parse_situation_class(std::string_view text) {
  const auto found = std::find(kClassNames.begin(), kClassNames.end(), text);
  if (found == kClassNames.end()) return std::nullopt;
  return static_cast<SituationClass>(found - kClassNames.begin());
}

std::vector<const Situation*> situations_of(const Book& book, std::uint64_t seed, int count) {
  if (book.situations.empty()) return {};
  soccer::RandomStream draw(seed, "book");
  // Each situation is equally likely to choose the log.
  const int chosen = draw.integer(static_cast<int>(book.situations.size()));
  const int log = book.situations[static_cast<std::size_t>(chosen)].log;
  std::array<std::vector<const Situation*>, kSituationClasses> by_class;
  for (const Situation& situation : book.situations) {
    if (situation.log != log) continue;
    by_class[static_cast<std::size_t>(situation.kind)].push_back(&situation);
  }
  for (auto& list : by_class) draw.shuffle(std::span<const Situation*>(list));
  std::vector<const Situation*> result;
  const auto wanted = static_cast<std::size_t>(std::max(count, 0));
  bool more = true;
  for (std::size_t round = 0; more && result.size() < wanted; ++round) {
    more = false;
    for (const auto& list : by_class) {
      if (round >= list.size() || result.size() >= wanted) continue;
      result.push_back(list[round]);
      more = true;
    }
  }
  return result;
}

}  // namespace cls::analysis

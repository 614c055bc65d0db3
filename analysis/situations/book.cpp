// Names of classes, and the draw of a match's situations.
#include "analysis/situations/book.h"

#include <algorithm>
#include <span>

#include "base/index.h"
#include "base/text/enum_names.h"
#include "soccer/random.h"

namespace cls::analysis {
namespace {

constexpr auto kClassNames =
    base::enum_names<SituationClass>("attack", "defense", "set_play", "turnover", "build_up");

}  // namespace

std::string_view name(SituationClass kind) { return kClassNames.name(kind); }

std::optional<SituationClass> parse_situation_class(std::string_view text) {
  return kClassNames.parse(text);
}

std::vector<const Situation*> situations_of(const Book& book, std::uint64_t seed, int count) {
  if (book.situations.empty()) return {};
  soccer::RandomStream draw(seed, "book");
  // Each situation is equally likely to choose the log.
  const int chosen = draw.integer(static_cast<int>(book.situations.size()));
  const int log = book.situations[base::index(chosen)].log;
  std::array<std::vector<const Situation*>, kSituationClasses> by_class;
  for (const Situation& situation : book.situations) {
    if (situation.log == log) by_class[base::index(situation.kind)].push_back(&situation);
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

const BookLog& log_of(const Book& book, std::uint64_t seed, int count) {
  return book.logs[base::index(situations_of(book, seed, count).front()->log)];
}

}  // namespace cls::analysis

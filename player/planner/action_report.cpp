// Sums of action counts.
#include "player/planner/action_report.h"

namespace cls::player {
namespace {

constexpr std::array kCounts{&ActionCounts::done, &ActionCounts::failed, &ActionCounts::skipped,
                             &ActionCounts::invalid, &ActionCounts::unimplemented};
constexpr std::array kSums{&ActionReport::preprocess, &ActionReport::sure_shot,
                           &ActionReport::intention,  &ActionReport::force_kick,
                           &ActionReport::heard_pass, &ActionReport::lists,
                           &ActionReport::empty,      &ActionReport::useless};

void add(ActionCounts& into, const ActionCounts& from) {
  for (const auto count : kCounts) into.*count += from.*count;
}

}  // namespace

void add(ActionReport& into, const ActionReport& from) {
  for (std::size_t i = 0; i < into.actions.size(); ++i) add(into.actions[i], from.actions[i]);
  for (std::size_t i = 0; i < into.say.size(); ++i) add(into.say[i], from.say[i]);
  for (const auto sum : kSums) into.*sum += from.*sum;
}

}  // namespace cls::player

// Sums of action counts.
#include "player/planner/action_report.h"

namespace cls::player {
namespace {

void add(ActionCounts& into, const ActionCounts& from) {
  into.done += from.done;
  into.failed += from.failed;
  into.skipped += from.skipped;
  into.invalid += from.invalid;
  into.unimplemented += from.unimplemented;
}

}  // namespace

void add(ActionReport& into, const ActionReport& from) {
  for (std::size_t i = 0; i < into.actions.size(); ++i) add(into.actions[i], from.actions[i]);
  for (std::size_t i = 0; i < into.say.size(); ++i) add(into.say[i], from.say[i]);

  into.preprocess += from.preprocess;
  into.sure_shot += from.sure_shot;
  into.intention += from.intention;
  into.force_kick += from.force_kick;
  into.heard_pass += from.heard_pass;
  into.lists += from.lists;
  into.empty += from.empty;
  into.useless += from.useless;
}

}  // namespace cls::player

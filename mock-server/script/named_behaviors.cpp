// The table of bundled behaviors.
#include "mock-server/script/named_behaviors.h"

#include <fmt/format.h>

#include "base/text/suggestion.h"
#include "base/text/value_text.h"
#include "mock-server/behavior/bundled.h"
#include "mock-server/behavior/example_team.h"
#include "mock-server/behavior/simple_team.h"

namespace cls::mock_server {
namespace {

base::Result<std::unique_ptr<Behavior>> make_random(std::string_view seed_text) {
  const auto seed = base::value_of<std::uint64_t>(seed_text);
  if (!seed) return base::Error{fmt::format("mock behavior 'random:{}': invalid seed", seed_text)};
  return make_random_behavior(*seed);
}

}  // namespace

std::vector<std::string_view> behavior_names() {
  return {kDefaultBehavior, "simple", "example", "planner", "hold", "random"};
}

base::Result<std::unique_ptr<Behavior>> make_behavior(std::string_view name) {
  using Defense = ExampleTeam::Defense;
  if (name.empty() || name == kDefaultBehavior) {
    return std::unique_ptr<Behavior>(new ExampleTeam(Defense::kOneMarks));
  }
  if (name == "example") return std::unique_ptr<Behavior>(new ExampleTeam(Defense::kAllMark));
  if (name == "simple") return std::unique_ptr<Behavior>(new SimpleTeam);
  if (name == "planner") return make_planner_behavior();
  if (name == "hold") return std::unique_ptr<Behavior>(new Hold);
  if (name == "random" || name == "random:") return make_random_behavior(1);
  if (name.starts_with("random:")) return make_random(name.substr(7));
  if (name.starts_with("replay:")) return read_replay_behavior(std::string(name.substr(7)));

  const std::string_view near = base::nearest_name(name, behavior_names());
  return base::Error{
      fmt::format("unknown mock behavior '{}'{}", name,
                  near.empty() ? fmt::format(" (known: {})", fmt::join(behavior_names(), ", "))
                               : fmt::format("; did you mean '{}'?", near))};
}

}  // namespace cls::mock_server

// The list of bundled brains.
#include "mock-server/behaviour.h"

#include <fmt/format.h>

#include <charconv>

#include "base/text/suggestion.h"
#include "mock-server/hold.h"
#include "mock-server/planner_team.h"
#include "mock-server/random_brain.h"
#include "mock-server/replay_brain.h"
#include "mock-server/simple_team/simple_team.h"

namespace cls::mock_server {

namespace {

base::Result<std::unique_ptr<Behaviour>> make_random(std::string_view seed_text) {
  std::uint64_t seed = 1;
  if (!seed_text.empty()) {
    const char* end = seed_text.data() + seed_text.size();
    const auto [stop, code] = std::from_chars(seed_text.data(), end, seed);
    if (code != std::errc{} || stop != end) {
      return base::Error{fmt::format("mock behaviour 'random:{}': no seed", seed_text)};
    }
  }
  return std::unique_ptr<Behaviour>(new RandomBrain(seed));
}

}  // namespace

std::vector<std::string_view> behaviour_names() { return {"simple", "planner", "hold", "random"}; }

base::Result<std::unique_ptr<Behaviour>> make_behaviour(std::string_view name) {
  if (name.empty() || name == "simple") return std::unique_ptr<Behaviour>(new SimpleTeam);
  if (name == "planner") return std::unique_ptr<Behaviour>(new PlannerTeam);
  if (name == "hold") return std::unique_ptr<Behaviour>(new Hold);
  if (name == "random") return make_random("");
  if (name.starts_with("random:")) return make_random(name.substr(7));
  if (name.starts_with("replay:")) return ReplayBrain::read(std::string(name.substr(7)));
  std::string message = fmt::format("unknown mock behaviour '{}'", name);
  const std::string_view near = base::nearest_name(name, behaviour_names());
  if (near.empty()) {
    message += fmt::format(" (known: {})", fmt::join(behaviour_names(), ", "));
  } else {
    message += fmt::format("; did you mean '{}'?", near);
  }
  return base::Error{std::move(message)};
}

}  // namespace cls::mock_server

// The list of bundled brains.
#include "mock-server/behaviour.h"

#include <fmt/format.h>

#include "mock-server/hold.h"
#include "mock-server/simple_team/simple_team.h"
#include "soccer/parameter.h"

namespace cls::mock_server {

std::vector<std::string_view> behaviour_names() { return {"simple", "hold"}; }

soccer::Result<std::unique_ptr<Behaviour>> make_behaviour(std::string_view name) {
  if (name.empty() || name == "simple") return std::unique_ptr<Behaviour>(new SimpleTeam);
  if (name == "hold") return std::unique_ptr<Behaviour>(new Hold);
  std::string message = fmt::format("unknown mock behaviour '{}'", name);
  const std::string_view near = soccer::nearest_name(name, behaviour_names());
  if (near.empty()) {
    message += fmt::format(" (known: {})", fmt::join(behaviour_names(), ", "));
  } else {
    message += fmt::format("; did you mean '{}'?", near);
  }
  return soccer::Error{std::move(message)};
}

}  // namespace cls::mock_server

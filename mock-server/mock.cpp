// From a name to a mock.
#include "mock-server/mock.h"

namespace cls::mock_server {

Mock::Mock(std::shared_ptr<const Script> script)
    : behaviour(std::make_unique<ScriptedBehaviour>(script)),
      expectations(script->expectations),
      faults(script->faults) {}

bool names_script(std::string_view name) { return name.ends_with(".json"); }

base::Result<Mock> make_mock(std::string_view name) {
  if (names_script(name)) {
    auto script = read_script(name);
    if (!script) return script.error();
    return Mock(*std::move(script));
  }
  auto behaviour = make_behaviour(name);
  if (!behaviour) return behaviour.error();
  return Mock(*std::move(behaviour));
}

}  // namespace cls::mock_server

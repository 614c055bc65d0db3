// Mocks from scripts and from names.
#include "mock-server/mock.h"

#include "mock-server/script/named_behaviors.h"

namespace cls::mock_server {

Mock::Mock(std::shared_ptr<const Script> script)
    : behavior(std::make_unique<ScriptedBehavior>(script)),
      expectations(script->expectations),
      faults(script->faults) {}

bool is_script_name(std::string_view name) { return name.ends_with(".json"); }

base::Result<Mock> make_mock(std::string_view name) {
  if (is_script_name(name)) {
    TRY_INIT(auto script, read_script(name));
    return Mock(std::move(script));
  }
  TRY_INIT(auto behavior, make_behavior(name));
  return Mock(std::move(behavior));
}

}  // namespace cls::mock_server

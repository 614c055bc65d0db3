// A mock Playmaker before it serves: what it answers, expects and does wrong.
#pragma once

#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "mock-server/behaviour.h"
#include "mock-server/faults.h"
#include "mock-server/script/expectations.h"
#include "mock-server/script/script.h"

namespace cls::mock_server {

struct Mock {
  Mock() = default;
  /// Without faults and expectations.
  template <typename Brain>
  Mock(std::unique_ptr<Brain> brain) : behaviour(std::move(brain)) {}
  explicit Mock(std::shared_ptr<const Script> script);

  std::unique_ptr<const Behaviour> behaviour;
  std::vector<Expectation> expectations;
  Faults faults;
  /// What a crash does; empty: the calls fail from then on as if the process were dead.
  std::function<void()> die;
};

/// True for what names a script file: it ends in ".json".
bool names_script(std::string_view name);

/// The behaviour of that name, or the script in that file; empty: the simple team. Errors of
/// scripts name file and line.
base::Result<Mock> make_mock(std::string_view name);

}  // namespace cls::mock_server

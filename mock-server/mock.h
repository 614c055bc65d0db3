// Description of a mock Playmaker: behavior, expectations and faults.
#pragma once

#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "mock-server/behavior/behavior.h"
#include "mock-server/script/expectations.h"
#include "mock-server/script/faults.h"
#include "mock-server/script/script.h"

namespace cls::mock_server {

struct Mock {
  Mock() = default;
  /// Without faults and expectations.
  template <typename B>
  Mock(std::unique_ptr<B> b) : behavior(std::move(b)) {}
  explicit Mock(std::shared_ptr<const Script> script);

  std::unique_ptr<const Behavior> behavior;
  std::vector<Expectation> expectations;
  Faults faults;
  /// Called at an injected crash; empty: all later calls fail with UNAVAILABLE.
  std::function<void()> die;
};

/// True for names of script files: those that end in ".json".
bool is_script_name(std::string_view name);

/// The behavior with that name, or the script in that file; empty: the default team. Errors in
/// scripts name file and line.
base::Result<Mock> make_mock(std::string_view name);

}  // namespace cls::mock_server

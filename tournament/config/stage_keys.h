// The table of all keys of [[stages]]: name, help, parser and formatter.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "league/competition/stage.h"
#include "tournament/config/config_values.h"

namespace cls::tournament {

using league::Stage;

struct StageKey {
  std::string_view name;
  /// Stores the value. The error names the accepted values.
  std::function<base::Result<void>(Stage&, const ConfigValue&)> parse;
  /// The value as TOML; empty when it is the default.
  std::function<std::string(const Stage&)> format;
};

/// In the order of the written file.
const std::vector<StageKey>& stage_keys();

}  // namespace cls::tournament

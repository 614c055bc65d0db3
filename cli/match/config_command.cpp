// `cls config`: the settings of a match, and where each comes from.
#include "cli/support/commands.h"

#include <fmt/format.h>

#include <vector>

#include "base/text/json.h"
#include "cli/match/match_arguments.h"
#include "cli/support/print_error.h"
#include "cli/terminal/exit_code.h"
#include "cli/terminal/json_stdout.h"

namespace cls::cli {
namespace {

constexpr const char* kConfigDescription =
    "print every setting of a match and where its value comes from\n"
    "\n"
    "  cls config                          the defaults\n"
    "  cls config RED BLUE                 of a match between teams in cls.toml\n"
    "  cls config --config cup/cls.toml --seed 7 --json\n"
    "\n"
    "Takes the arguments of cls match. An option overrides cls.toml, and that\n"
    "overrides the default.";

void print_settings(const std::vector<SettingRow>& rows) {
  base::Json settings = base::Json::array();
  for (const SettingRow& row : rows) {
    settings.push_back({{"name", row.name},
                        {"value", row.value.empty() ? base::Json(nullptr) : base::Json(row.value)},
                        {"origin", row.origin}});
  }

  print_json({{"schema", "cls.config/1"}, {"settings", settings}});
}

int run_config_command(const Command& command, MatchArguments& arguments) {
  if (arguments.left.empty()) arguments.left = "mock";
  if (arguments.right.empty()) arguments.right = "mock";
  TRY_STEP(resolve_match(command, arguments));

  const std::vector<SettingRow> rows = setting_rows(arguments);
  if (arguments.json) {
    print_settings(rows);
    return kOk;
  }

  for (const SettingRow& row : rows) {
    fmt::print("{} = {}  ({})\n", row.name, row.value.empty() ? "none" : row.value, row.origin);
  }
  return kOk;
}

}  // namespace

void add_config_command(Command& app) {
  auto [command, arguments] = app.command("config", kConfigDescription, run_config_command);

  command.option("LEFT", arguments.left, "SIDE on the left (default: mock)");
  command.option("RIGHT", arguments.right, "SIDE on the right (default: mock)");
  add_match_options(command, arguments);
}

}  // namespace cls::cli

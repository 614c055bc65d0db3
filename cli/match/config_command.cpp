// `cls config`: the settings of a match, and where each comes from.
#include "cli/support/commands.h"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/text/json_text.h"
#include "cli/match/match_arguments.h"
#include "cli/support/exit_code.h"

namespace cls::cli {
namespace {

constexpr const char* kDescription =
    "print every setting of a match and where its value comes from\n"
    "\n"
    "  cls config                          the defaults\n"
    "  cls config RED BLUE                 of a match between teams in cls.toml\n"
    "  cls config --config cup/cls.toml --seed 7 --json\n"
    "\n"
    "Takes the arguments of cls match. An option overrides cls.toml, and that\n"
    "overrides the default.";

void print_json(const std::vector<SettingRow>& rows) {
  nlohmann::ordered_json settings = nlohmann::ordered_json::array();
  for (const SettingRow& row : rows) {
    settings.push_back({{"name", row.name},
                        {"value", row.value.empty() ? nlohmann::ordered_json(nullptr)
                                                    : nlohmann::ordered_json(row.value)},
                        {"origin", row.origin}});
  }

  const nlohmann::ordered_json document = {{"schema", "cls.config/1"}, {"settings", settings}};
  fmt::print("{}", base::json_document(document));
}

int run_config_command(const Command& command, MatchArguments& arguments) {
  if (arguments.left.empty()) arguments.left = "mock";
  if (arguments.right.empty()) arguments.right = "mock";
  if (const int resolved = resolve_match(command, arguments); resolved != kOk) return resolved;

  const std::vector<SettingRow> rows = setting_rows(arguments);
  if (arguments.json) {
    print_json(rows);
    return kOk;
  }

  for (const SettingRow& row : rows) {
    fmt::print("{} = {}  ({})\n", row.name, row.value.empty() ? "none" : row.value, row.origin);
  }
  return kOk;
}

}  // namespace

void add_config_command(Command& app) {
  const auto arguments = std::make_shared<MatchArguments>();
  Command& command = app.command("config", kDescription);

  command.option("LEFT", arguments->left, "SIDE on the left (default: mock)");
  command.option("RIGHT", arguments->right, "SIDE on the right (default: mock)");
  add_match_options(command, *arguments);
  command.run = [arguments, &command] { return run_config_command(command, *arguments); };
}

}  // namespace cls::cli

// `cls init`: writes cls.toml or planner.toml, never over an existing one.
#include "cli/support/commands.h"

#include <fmt/format.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "base/io/occupied_path.h"
#include "base/io/whole_file.h"
#include "base/text/json.h"
#include "cli/support/print_error.h"
#include "cli/terminal/json_stdout.h"
#include "match/terms/planner_file.h"
#include "tournament/config/config_file.h"
#include "tournament/config/preset.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kInitDescription =
    "write a commented cls.toml with teams and tournament\n"
    "\n"
    "  cls init            into the working directory\n"
    "  cls init cup        into cup, which is created\n"
    "  cls init cup --preset robocup --teams RED,BLUE,GREEN,GOLD\n"
    "                      the stages of the RoboCup league, of teams in cup/RED, ...\n"
    "  cls init --planner  planner.toml: all parameters of the planner (docs/mock.md)";

constexpr const char* kPlannerFile = "planner.toml";

struct InitArguments {
  std::string folder = ".";
  bool planner = false;
  std::string preset;
  std::string teams;
  bool force = false;
  bool json = false;
};

// The text of the file, or an error of usage.
base::Result<std::string> file_text(const InitArguments& arguments) {
  if (arguments.planner && !arguments.preset.empty()) {
    return base::Error{"--preset is for cls.toml, --planner for planner.toml; give one of them"};
  }
  if (arguments.preset.empty()) {
    if (!arguments.teams.empty()) return base::Error{"--teams requires --preset"};
    return arguments.planner ? match::commented_planner_file() : tournament::commented_config();
  }
  std::vector<std::string> teams;
  std::istringstream stream(arguments.teams);
  for (std::string team; std::getline(stream, team, ',');) teams.push_back(team);
  return tournament::preset_config(arguments.preset, teams);
}

int run_init(const InitArguments& arguments) {
  TRY_INIT_OR(kUsage, const auto text, file_text(arguments));
  const fs::path folder = arguments.folder;
  const fs::path file = folder / (arguments.planner ? kPlannerFile : tournament::kConfigFile);
  std::error_code code;
  if (fs::exists(file, code) && !arguments.force) {
    return print_error(kCannotCreate, "{}: exists; --force renames it to {}.old", file.string(),
                       file.filename().string());
  }
  if (fs::exists(file, code)) {
    TRY_OR(kCannotCreate, base::set_aside(file));
  }

  TRY_OR(kCannotCreate, base::create_folders(folder));

  TRY_OR(kCannotCreate, base::write_file(file, text));

  if (arguments.json) return print_json({{"schema", "cls.init/1"}, {"file", file.string()}});

  fmt::print("{}\n", file.string());

  return kOk;
}

}  // namespace

void add_init_command(Command& app) {
  auto [command, arguments] = app.command("init", kInitDescription, run_init);
  command.option("DIR", arguments.folder, "folder of the file (default: working directory)");
  command.flag("--planner", arguments.planner,
               "write planner.toml, parameters of the planner, instead of cls.toml");
  command
      .option("--preset", arguments.preset,
              fmt::format("a cls.toml with the format of a competition: {}",
                          fmt::join(tournament::preset_names(), ", ")))
      .placeholder("NAME");
  command
      .option("--teams", arguments.teams,
              "of the preset: names of team folders in DIR (default: eight mocks)")
      .placeholder("A,B,...");
  command.flag("--force", arguments.force, "rename an existing file to NAME.old");
  command.flag("--json", arguments.json, "print one JSON document").of_group(kOutputGroup);
}

}  // namespace cls::cli

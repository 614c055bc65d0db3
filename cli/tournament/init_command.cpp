// `cls init`: writes cls.toml or planner.toml, never over an existing one.
#include "cli/support/commands.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "base/io/occupied_path.h"
#include "base/io/whole_file.h"
#include "base/text/json_text.h"
#include "cli/support/exit_code.h"
#include "cli/support/print_error.h"
#include "match/terms/planner_file.h"
#include "tournament/config/config_file.h"
#include "tournament/config/preset.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDescription =
    "write a commented cls.toml with teams and tournament\n"
    "\n"
    "  cls init            into the working directory\n"
    "  cls init cup        into cup, which is created\n"
    "  cls init cup --preset robocup --teams RED,BLUE,GREEN,GOLD\n"
    "                      the stages of the RoboCup league, of teams in cup/RED, ...\n"
    "  cls init --planner  planner.toml: all parameters of the planner (docs/mock.md)";

constexpr const char* kPlannerFile = "planner.toml";

struct Arguments {
  std::string folder = ".";
  bool planner = false;
  std::string preset;
  std::string teams;
  bool force = false;
  bool json = false;
};

// The text of the file, or an error of usage.
base::Result<std::string> file_text(const Arguments& arguments) {
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

int run(const Arguments& arguments) {
  const auto text = file_text(arguments);
  if (!text) return print_error(kUsage, text.error().message);
  const fs::path folder = arguments.folder;
  const fs::path file = folder / (arguments.planner ? kPlannerFile : tournament::kConfigFile);
  std::error_code code;
  if (fs::exists(file, code) && !arguments.force) {
    return print_error(kCannotCreate, fmt::format("{}: exists; --force renames it to {}.old",
                                                  file.string(), file.filename().string()));
  }
  if (fs::exists(file, code)) {
    const auto old = base::set_aside(file);
    if (!old) return print_error(kCannotCreate, old.error().message);
  }

  if (const auto created = base::create_folders(folder); !created) {
    return print_error(kCannotCreate, created.error().message);
  }

  const auto written = base::write_file(file, *text);
  if (!written) return print_error(kCannotCreate, written.error().message);

  if (arguments.json) {
    const nlohmann::ordered_json document = {{"schema", "cls.init/1"}, {"file", file.string()}};
    fmt::print("{}", base::json_document(document));
  } else {
    fmt::print("{}\n", file.string());
  }
  return kOk;
}

}  // namespace

void add_init_command(Command& app) {
  const auto arguments = std::make_shared<Arguments>();
  Command& command = app.command("init", kDescription);
  command.option("DIR", arguments->folder, "folder of the file (default: working directory)");
  command.flag("--planner", arguments->planner,
               "write planner.toml, parameters of the planner, instead of cls.toml");
  command
      .option("--preset", arguments->preset,
              fmt::format("a cls.toml with the format of a competition: {}",
                          fmt::join(tournament::preset_names(), ", ")))
      .placeholder("NAME");
  command
      .option("--teams", arguments->teams,
              "of the preset: names of team folders in DIR (default: eight mocks)")
      .placeholder("A,B,...");
  command.flag("--force", arguments->force, "rename an existing file to NAME.old");
  command.flag("--json", arguments->json, "print one JSON document");
  command.run = [arguments] { return run(*arguments); };
}

}  // namespace cls::cli

// `cls package-team`: a team of cls.toml as a folder that the machines of a competition start.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/io/occupied_path.h"
#include "base/io/whole_file.h"
#include "base/text/json_text.h"
#include "base/text/suggestion.h"
#include "cli/project/team_package.h"
#include "cli/support/commands.h"
#include "cli/support/exit_code.h"
#include "cli/support/print_error.h"
#include "orchestration/tournament/config/config_file.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using namespace orchestration::tournament;

constexpr const char* kDescription =
    "write a team of cls.toml as a folder for a competition\n"
    "It holds start HOST DIR NUM, kill, this cls, the project of the Playmaker, and\n"
    "the virtual environment of Python that is active, or .venv of the project.\n"
    "Matches, logs and pages are left out.\n"
    "\n"
    "  cls package-team ada                       writes ada-team/\n"
    "  cls match team:ada-team mock               plays it as a competition does";

constexpr std::string_view kRunForm = "run:";

struct Arguments {
  std::string name;
  std::string dir;
  std::string config;
  bool force = false;
  bool json = false;
};

int report_unknown_team(const Arguments& arguments, const fs::path& file,
                        const TournamentConfig& config) {
  std::vector<std::string_view> teams;
  for (const TeamEntry& team : config.teams) teams.push_back(team.name);

  return print_error(kUsage, fmt::format("{} has no team '{}'{}", file.string(), arguments.name,
                                         base::did_you_mean(arguments.name, teams)));
}

std::string megabytes(std::uintmax_t bytes) {
  return fmt::format("{:.1f} MB", static_cast<double>(bytes) / 1e6);
}

void print_text(const std::string& dir, const WrittenPackage& written) {
  fmt::print("{}/: {}: cls {}", dir, megabytes(written.bytes()), megabytes(written.program_bytes));
  if (written.environment_bytes > 0) {
    fmt::print(", env/ with Python's packages {}", megabytes(written.environment_bytes));
  }
  fmt::print(", team/ with the Playmaker {}\n", megabytes(written.project_bytes));
  if (!written.left_out.empty()) fmt::print("left out: {}\n", fmt::join(written.left_out, ", "));
  fmt::print(
      "try it as a competition does; its output is in {0}/playmaker.log:\n"
      "  cls match team:{0} mock --cycles 300\n",
      dir);
}

void print_json(const std::string& dir, const TeamPackage& package, const WrittenPackage& written) {
  const nlohmann::ordered_json document = {{"schema", "cls.package-team/1"},
                                           {"dir", dir},
                                           {"command", package.command},
                                           {"bytes", written.bytes()},
                                           {"environment", package.environment.string()},
                                           {"left_out", written.left_out}};
  fmt::print("{}", base::json_document(document));
}

int write(const Arguments& arguments, const TeamPackage& package) {
  const std::string dir = arguments.dir.empty() ? arguments.name + "-team" : arguments.dir;
  if (const std::string contents = base::contents_of(dir); !contents.empty()) {
    if (!arguments.force) {
      return print_error(
          kCannotCreate,
          fmt::format("{}: has {}; --force renames it to {}.old, --dir selects a new "
                      "folder",
                      dir, contents, dir));
    }
    const auto aside = base::set_aside(dir);
    if (!aside) return print_error(kCannotCreate, aside.error().message);
    fmt::print(stderr, "cls: old package moved to {}\n", aside->string());
  }
  const auto written = write_package(package, dir);
  if (!written) return print_error(kCannotCreate, written.error().message);

  if (!package.environment.empty()) {
    if (const std::string program = foreign_interpreter(package.environment); !program.empty()) {
      print_error(0,
                  fmt::format("warning: the environment needs {}, which other machines and the "
                              "sandbox of team: do not have; make it with /usr/bin/python3 -m venv",
                              program));
    }
  }
  if (arguments.json) {
    print_json(dir, package, *written);
  } else {
    print_text(dir, *written);
  }
  return kOk;
}

int run(const Arguments& arguments) {
  std::error_code code;
  const auto found = find_config(fs::current_path(code));
  const std::optional<fs::path> file =
      arguments.config.empty() ? found : std::optional<fs::path>(arguments.config);
  if (!file) {
    return print_error(kNoInput,
                       "no cls.toml in or above the working directory; cls init writes one");
  }

  if (const auto why = base::why_no_file(*file)) {
    return print_error(kNoInput, fmt::format("{}: {}", file->string(), *why));
  }

  const ParsedConfig parsed = read_config(*file);
  if (!parsed.errors.empty()) return print_errors(kBadConfig, parsed.errors);
  const int team = team_index(parsed.config, arguments.name);
  if (team < 0) return report_unknown_team(arguments, *file, parsed.config);

  const std::string& endpoint = parsed.config.teams[static_cast<std::size_t>(team)].endpoint;
  if (!endpoint.starts_with(kRunForm)) {
    return print_error(kUsage,
                       fmt::format("team '{}' is '{}'; a package needs run:COMMAND, which starts "
                                   "the Playmaker",
                                   arguments.name, endpoint));
  }

  return write(arguments, {arguments.name, endpoint.substr(kRunForm.size()), parsed.config.folder,
                           "/proc/self/exe", environment_of(parsed.config.folder)});
}

}  // namespace

void add_package_team_command(Command& app) {
  const auto arguments = std::make_shared<Arguments>();
  Command& command = app.command("package-team", kDescription);
  command.option("NAME", arguments->name, "a team of cls.toml").required();

  command.option("--dir", arguments->dir, "folder of the package (default: NAME-team)");
  command.option("--config", arguments->config,
                 "cls.toml with the team (default: in or above the working directory)");

  command.flag("--force", arguments->force, "rename an older package to NAME.old first");
  command.flag("--json", arguments->json, "print one JSON document");
  command.run = [arguments] { return run(*arguments); };
}

}  // namespace cls::cli

// `cls package-team`: a team of cls.toml as a folder that the machines of a competition start.
#include <fmt/format.h>

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/index.h"
#include "base/io/occupied_path.h"
#include "base/system/own_program.h"
#include "base/text/byte_size.h"
#include "base/text/json.h"
#include "base/text/suggestion.h"
#include "cli/project/elf_file.h"
#include "cli/project/package_check.h"
#include "cli/project/team_package.h"
#include "cli/support/commands.h"
#include "cli/support/interrupt.h"
#include "cli/support/print_error.h"
#include "cli/support/side_arguments.h"
#include "cli/terminal/json_stdout.h"
#include "cli/terminal/terminal.h"
#include "process/scratch_folder.h"
#include "tournament/config/config_file.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using namespace tournament;

constexpr const char* kPackageTeamDescription =
    "write a team of cls.toml as a folder for a competition\n"
    "\n"
    "  cls package-team ada                       writes ada-team/\n"
    "  cls match team:ada-team mock               plays it on this host\n"
    "  cls package-team ada --check --root DIR    plays it on twelve machines, whose\n"
    "                                             files are those of DIR, at 10 Hz\n"
    "\n"
    "It holds start HOST DIR NUM, kill, this cls and the project of the Playmaker,\n"
    "with their loader and libraries: any Linux with glibc 2.31 or later starts it.\n"
    "For a project in Python it has the interpreter and the packages that the project\n"
    "imports or its virtual environment has, for package.json node, and what --with\n"
    "names. Matches, logs, pages, private files (.env, keys, ...) and files that\n"
    ".gitignore names are left out and listed.";

constexpr std::string_view kRunForm = "run:";

struct PackageTeamArguments {
  std::string name;
  std::string dir;
  std::string config;
  std::vector<std::string> with;
  std::vector<std::string> include;
  bool force = false;
  bool check = false;
  std::string root = "/";
  int cycles = 6000;
  std::string memory = "1G";
  int cpus = 1;
  bool json = false;
};

int report_unknown_team(const PackageTeamArguments& arguments, const fs::path& file,
                        const TournamentConfig& config) {
  std::vector<std::string_view> teams;
  for (const TeamEntry& team : config.competition.teams) teams.push_back(team.name);

  return print_error(kUsage, "{} has no team '{}'{}", file.string(), arguments.name,
                     base::did_you_mean(arguments.name, teams));
}

std::string megabytes(std::uintmax_t bytes) {
  return fmt::format("{:.1f} MB", static_cast<double>(bytes) / 1e6);
}

std::string named(const BroughtInterpreter& interpreter) {
  if (interpreter.packages.empty()) return interpreter.name;
  return fmt::format("{} with {}", interpreter.name, fmt::join(interpreter.packages, ", "));
}

void print_package_text(const std::string& dir, const WrittenPackage& written) {
  fmt::print("{}/: {}, {} compressed: cls and libraries {}", dir, megabytes(written.bytes()),
             megabytes(written.packed_bytes), megabytes(written.program_bytes));
  if (written.environment_bytes > 0) {
    fmt::print(", env/ with interpreters {}", megabytes(written.environment_bytes));
  }
  fmt::print(", team/ with the Playmaker {}\n", megabytes(written.project_bytes));
  for (const BroughtInterpreter& one : written.interpreters) {
    fmt::print("env/ has {}\n", named(one));
  }
  if (!written.left_out.empty()) fmt::print("left out: {}\n", fmt::join(written.left_out, ", "));
  fmt::print(
      "try it as a competition does; its output is in {0}/playmaker.log:\n"
      "  cls match team:{0} mock --cycles 300\n",
      dir);
}

void print_package_json(const std::string& dir, const TeamPackage& package,
                        const WrittenPackage& written) {
  base::Json interpreters = base::Json::array();
  for (const BroughtInterpreter& one : written.interpreters) {
    interpreters.push_back(
        {{"name", one.name}, {"program", one.program.string()}, {"packages", one.packages}});
  }
  print_json({{"schema", "cls.package-team/1"},
              {"dir", dir},
              {"command", package.command},
              {"bytes", written.bytes()},
              {"compressed_bytes", written.packed_bytes},
              {"environment", package.environment.string()},
              {"interpreters", interpreters},
              {"missing", written.missing},
              {"links_outside", written.links_outside},
              {"left_out", written.left_out}});
}

std::string folder_of(const PackageTeamArguments& arguments) {
  return arguments.dir.empty() ? arguments.name + "-team" : arguments.dir;
}

int write(const PackageTeamArguments& arguments, const TeamPackage& package) {
  const std::string dir = folder_of(arguments);
  if (const std::string contents = base::contents_of(dir); !contents.empty()) {
    if (!arguments.force) {
      return print_error(kCannotCreate,
                         "{}: has {}; --force renames it to {}.old, --dir selects a new "
                         "folder",
                         dir, contents, dir);
    }
    TRY_INIT_OR(kCannotCreate, const auto aside, base::set_aside(dir));
    fmt::print(stderr, "cls: old package moved to {}\n", aside.string());
  }
  const auto written = write_package(package, dir, [](std::string_view step) {
    if (stderr_is_terminal()) fmt::print(stderr, "cls: {}\n", step);
  });
  if (!written) return print_error(kCannotCreate, written.error().message);

  for (const std::string& one : written->missing) {
    print_error(0, "warning: {} is not on this host, and so not in the package", one);
  }
  for (const std::string& one : written->links_outside) {
    print_error(0, "warning: {}: a link that leads out of the project; other hosts lack its target",
                one);
  }

  if (arguments.json) {
    print_package_json(dir, package, *written);
  } else {
    print_package_text(dir, *written);
  }

  return kOk;
}

int check(const PackageTeamArguments& arguments) {
  PackageCheckOptions options;
  options.package = folder_of(arguments);
  options.root = arguments.root;
  options.cycles = arguments.cycles;
  options.cpus = arguments.cpus;
  const auto memory = base::parse_byte_size(arguments.memory);
  if (!memory) {
    return print_error(kUsage, "--memory '{}': must be a size such as 512M or 2G",
                       arguments.memory);
  }
  options.memory = *memory;
  TRY_INIT_OR(kUnavailable, const auto program, base::own_program());
  options.program = program;

  TRY_INIT_OR(kCannotCreate, const auto scratch, process::ScratchFolder::create());
  options.folder = scratch.path();

  const std::atomic<int>& signal = watch_interrupts();
  TRY_INIT_OR(kNoInput, const auto found, check_package(options, signal));
  fmt::print("{}", arguments.json ? to_json(options, found) : to_text(options, found));
  if (signal != 0) return signal_exit_code(signal);
  if (!found.skipped.empty()) return kUnavailable;
  return found.passed() ? kOk : kFailed;
}

int run_package_team(const PackageTeamArguments& arguments) {
  if (arguments.check) return check(arguments);
  std::error_code code;
  const auto found = find_config(fs::current_path(code));
  const std::optional<fs::path> file =
      arguments.config.empty() ? found : std::optional<fs::path>(arguments.config);
  if (!file) {
    return print_error(kNoInput,
                       "no cls.toml in or above the working directory; cls init writes one");
  }

  ParsedConfig parsed;
  TRY_STEP(read_project(*file, parsed));
  const int team = team_index(parsed.config.competition, arguments.name);
  if (team < 0) return report_unknown_team(arguments, *file, parsed.config);

  const std::string& endpoint = parsed.config.competition.teams[base::index(team)].endpoint;
  if (!endpoint.starts_with(kRunForm)) {
    return print_error(kUsage,
                       "team '{}' is '{}'; a package needs run:COMMAND, which starts "
                       "the Playmaker",
                       arguments.name, endpoint);
  }

  TRY_INIT_OR(kUnavailable, const auto program, base::own_program());
  if (!read_elf_file(program)) {
    return print_error(kUsage, "{}: the cls of a package cannot make another one",
                       program.string());
  }
  return write(
      arguments,
      {arguments.name, endpoint.substr(kRunForm.size()), parsed.config.execution.folder, program,
       environment_of(parsed.config.execution.folder), arguments.with, arguments.include});
}

}  // namespace

void add_package_team_command(Command& app) {
  auto [command, arguments] =
      app.command("package-team", kPackageTeamDescription, run_package_team);
  command.starts_programs = true;
  command.option("NAME", arguments.name, "a team of cls.toml").required();

  command.option("--dir DIR", arguments.dir, "folder of the package (default: NAME-team)");
  command.option("--config FILE", arguments.config,
                 "cls.toml with the team (default: in or above the working directory)");

  command
      .option("--with", arguments.with,
              "also bring PROGRAM of PATH and its libraries (may be repeated)")
      .placeholder("PROGRAM")
      .repeatable();

  command
      .option("--include", arguments.include,
              "pack PATH of the project although it looks private or .gitignore\n"
              "names it (may be repeated)")
      .placeholder("PATH")
      .repeatable();

  command.flag("--check", arguments.check,
               "play the package that is there: each agent on a machine of its own, 10 Hz");
  command
      .setting("--root", arguments.root,
               "--check: folder with the files of the machines, such as those of an older Linux")
      .placeholder("DIR");

  command.setting("--cycles", arguments.cycles, "--check: length of the match").range(1, 100000);
  command.setting("--memory", arguments.memory, "--check: memory of each agent with its Playmaker")
      .placeholder("SIZE");
  command.setting("--cpus", arguments.cpus, "--check: processors of each of them").range(1, 64);
  command.flag("--force", arguments.force, "rename an older package to NAME.old first");
  command.flag("--json", arguments.json, "print one JSON document").of_group(kOutputGroup);
}

}  // namespace cls::cli

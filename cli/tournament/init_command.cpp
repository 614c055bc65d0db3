// Writing the file, never over another.
#include "cli/tournament/init_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>

#include "base/io/whole_file.h"
#include "cli/support/exit_code.h"
#include "orchestration/tournament/config/config_file.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDescription =
    "Writes a commented cls.toml: teams and tournament.\n"
    "\n"
    "  cls init            into this folder\n"
    "  cls init cup        into cup, which is made";

int run(const std::string& folder, bool force) {
  const fs::path file = fs::path(folder) / orchestration::tournament::kConfigFile;
  std::error_code code;
  if (fs::exists(file, code) && !force) {
    fmt::print(stderr, "cls: {} exists already (--force replaces it)\n", file.string());
    return kCannotCreate;
  }
  fs::create_directories(folder, code);
  const auto written = base::write_file(file, orchestration::tournament::commented_config());
  if (!written) {
    fmt::print(stderr, "cls: {}\n", written.error().message);
    return kCannotCreate;
  }
  fmt::print("{}\n", file.string());
  return kDone;
}

}  // namespace

void add_init_command(CLI::App& app, int& exit_code) {
  const auto folder = std::make_shared<std::string>(".");
  const auto force = std::make_shared<bool>(false);
  CLI::App* command = app.add_subcommand("init", kDescription);
  command->add_option("DIR", *folder, "folder of the file (this one)");
  command->add_flag("--force", *force, "replace an existing file");
  command->callback([folder, force, &exit_code] { exit_code = run(*folder, *force); });
}

}  // namespace cls::cli

// `cls init`: writes cls.toml, never over an existing one.
#include "cli/support/commands.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "base/io/occupied_path.h"
#include "base/io/whole_file.h"
#include "base/text/json_text.h"
#include "cli/support/exit_code.h"
#include "cli/support/print_error.h"
#include "orchestration/tournament/config/config_file.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDescription =
    "write a commented cls.toml with teams and tournament\n"
    "\n"
    "  cls init            into the working directory\n"
    "  cls init cup        into cup, which is created";

int run(const std::string& folder, bool force, bool json) {
  const fs::path file = fs::path(folder) / orchestration::tournament::kConfigFile;
  std::error_code code;
  if (fs::exists(file, code) && !force) {
    return print_error(kCannotCreate, fmt::format("{}: exists; --force renames it to cls.toml.old",
                                                  file.string()));
  }
  if (fs::exists(file, code)) {
    const auto old = base::set_aside(file);
    if (!old) return print_error(kCannotCreate, old.error().message);
  }
  if (const auto created = base::create_folders(folder); !created) {
    return print_error(kCannotCreate, created.error().message);
  }
  const auto written = base::write_file(file, orchestration::tournament::commented_config());
  if (!written) return print_error(kCannotCreate, written.error().message);
  if (json) {
    const nlohmann::ordered_json document = {{"schema", "cls.init/1"}, {"file", file.string()}};
    fmt::print("{}", base::json_document(document));
  } else {
    fmt::print("{}\n", file.string());
  }
  return kOk;
}

}  // namespace

void add_init_command(CLI::App& app, int& exit_code) {
  const auto folder = std::make_shared<std::string>(".");
  const auto force = std::make_shared<bool>(false);
  const auto json = std::make_shared<bool>(false);
  CLI::App* command = app.add_subcommand("init", kDescription);
  command->add_option("DIR", *folder, "folder of the file (default: working directory)");
  command->add_flag("--force", *force, "rename an existing file to cls.toml.old");
  command->add_flag("--json", *json, "print one JSON document");
  command->callback([folder, force, json, &exit_code] { exit_code = run(*folder, *force, *json); });
}

}  // namespace cls::cli

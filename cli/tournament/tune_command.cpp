// `cls tune`: the list of its sub-commands, and `cls tune init`.
#include "cli/support/commands.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "base/io/occupied_path.h"
#include "base/io/whole_file.h"
#include "base/text/json_text.h"
#include "cli/support/exit_code.h"
#include "cli/support/print_error.h"
#include "tournament/tuning/tune_config.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDescription =
    "search for better parameters of a Playmaker by playing\n"
    "\n"
    "  cls tune init DIR          write a commented tune.toml: team, parameters\n"
    "  cls tune run DIR           search; run again to resume\n"
    "  cls tune status DIR        print the last generation\n"
    "  cls tune report DIR        print values, their difference, the verdict\n"
    "\n"
    "docs/tuning.md is a tutorial.";

constexpr const char* kInitDescription =
    "write a commented tune.toml with a small search\n"
    "\n"
    "  cls tune init          into the working directory\n"
    "  cls tune init search   into search, which is created\n"
    "\n"
    "The example tunes where a striker of the mock shoots; striker.json.in is its\n"
    "script.";

constexpr const char* kTemplateName = "striker.json.in";
constexpr const char* kTemplate =
    R"({
  "note": "shoots at {y} m beside the middle of the goal",
  "rules": [
    {"when": {"mode": "PlayOn", "state": {"self.is_kickable": true}},
     "reply": [{"body_smart_kick": {"target_point": {"x": 56, "y": {y}}, "first_speed": {speed},
                                    "first_speed_threshold": 0.1, "max_steps": 2}}]}
  ],
  "otherwise": "simple"
}
)";

int write_new(const fs::path& file, const std::string& text, bool force) {
  std::error_code code;
  if (fs::exists(file, code)) {
    if (!force) {
      return print_error(kCannotCreate, fmt::format("{}: exists; --force renames it to {}.old",
                                                    file.string(), file.filename().string()));
    }
    if (const auto old = base::set_aside(file); !old) {
      return print_error(kCannotCreate, old.error().message);
    }
  }

  const auto written = base::write_file(file, text);
  return written ? kOk : print_error(kCannotCreate, written.error().message);
}

int init(const std::string& folder, bool force, bool json) {
  using namespace tournament;
  if (const auto created = base::create_folders(folder); !created) {
    return print_error(kCannotCreate, created.error().message);
  }

  const fs::path file = fs::path(folder) / kTuneFile;
  if (const int code = write_new(file, commented_tune_config(), force); code != kOk) return code;
  const fs::path script = fs::path(folder) / kTemplateName;
  if (const int code = write_new(script, kTemplate, force); code != kOk) return code;

  if (json) {
    const nlohmann::ordered_json document = {
        {"schema", "cls.init/1"}, {"file", file.string()}, {"template", script.string()}};
    fmt::print("{}", base::json_document(document));
  } else {
    fmt::print("{}\n{}\n", file.string(), script.string());
  }
  return kOk;
}

void add_init(Command& app) {
  const auto folder = std::make_shared<std::string>(".");
  const auto force = std::make_shared<bool>(false);
  const auto json = std::make_shared<bool>(false);

  Command& command = app.command("init", kInitDescription);
  command.option("DIR", *folder, "folder of the files (default: working directory)");
  command.flag("--force", *force, "rename existing files to NAME.old");
  command.flag("--json", *json, "print one JSON document");
  command.run = [folder, force, json] { return init(*folder, *force, *json); };
}

}  // namespace

void add_tune_command(Command& app) {
  Command& command = app.command("tune", kDescription);
  command.group = kPlayCommands;
  command.starts_programs = true;
  add_init(command);
  add_tune_run_command(command);
  add_tune_status_command(command);
  add_tune_report_command(command);
}

}  // namespace cls::cli

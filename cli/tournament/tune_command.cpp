// `cls tune`: the list of its sub-commands, and `cls tune init`.
#include "cli/support/commands.h"

#include <fmt/format.h>

#include <filesystem>
#include <string>

#include "base/io/occupied_path.h"
#include "base/io/whole_file.h"
#include "base/text/json.h"
#include "cli/support/print_error.h"
#include "cli/terminal/json_stdout.h"
#include "tournament/tuning/tune_config.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTuneDescription =
    "search for better parameters of a Playmaker by playing\n"
    "\n"
    "  cls tune init DIR          write a commented tune.toml: team, parameters\n"
    "  cls tune run DIR           search; run again to resume\n"
    "  cls tune status DIR        print the last generation\n"
    "  cls tune report DIR        print values, their difference, the verdict\n"
    "\n"
    "docs/tuning.md is a tutorial.";

constexpr const char* kTuneInitDescription =
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

struct TuneInitArguments {
  std::string folder = ".";
  bool force = false;
  bool json = false;
};

int write_new(const fs::path& file, const std::string& text, bool force) {
  std::error_code code;
  if (fs::exists(file, code)) {
    if (!force) {
      return print_error(kCannotCreate, "{}: exists; --force renames it to {}.old", file.string(),
                         file.filename().string());
    }
    TRY_OR(kCannotCreate, base::set_aside(file));
  }

  const auto written = base::write_file(file, text);
  return written ? kOk : print_error(kCannotCreate, written.error().message);
}

int run_tune_init(const TuneInitArguments& arguments) {
  using namespace tournament;
  const fs::path folder = arguments.folder;
  TRY_OR(kCannotCreate, base::create_folders(folder));

  const fs::path file = folder / kTuneFile;
  const fs::path script = folder / kTemplateName;
  for (const auto& [path, text] :
       {std::pair(file, commented_tune_config()), std::pair(script, std::string(kTemplate))}) {
    TRY_STEP(write_new(path, text, arguments.force));
  }

  if (arguments.json)
    return print_json(
        {{"schema", "cls.init/1"}, {"file", file.string()}, {"template", script.string()}});

  fmt::print("{}\n{}\n", file.string(), script.string());

  return kOk;
}

}  // namespace

void add_tune_init_command(Command& tune) {
  auto [command, arguments] = tune.command("init", kTuneInitDescription, run_tune_init);
  command.option("DIR", arguments.folder, "folder of the files (default: working directory)");
  command.flag("--force", arguments.force, "rename existing files to NAME.old");
  command.flag("--json", arguments.json, "print one JSON document").of_group(kOutputGroup);
}

void add_tune_command(Command& app) {
  Command& parent = app.command("tune", kTuneDescription);
  parent.group = kPlayCommands;
  parent.starts_programs = true;
  CLS_TUNE_COMMANDS(CLS_ADD_COMMAND)
}

}  // namespace cls::cli

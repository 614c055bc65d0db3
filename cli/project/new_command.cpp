// `cls new`: writes a project for an own team, never over existing files.
#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <vector>

#include "base/io/occupied_path.h"
#include "base/io/whole_file.h"
#include "base/text/json.h"
#include "cli/project/project_files.h"
#include "cli/support/commands.h"
#include "cli/support/print_error.h"
#include "cli/terminal/json_stdout.h"
#include "match/terms/endpoint.h"
#include "process/command_plan.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNewDescription =
    "write a project for a team of your own\n"
    "A folder NAME with a Playmaker, cls.toml, tests, and files for editor and CI.\n"
    "\n"
    "  cls new python ada                     the example team in Python\n"
    "  cls new rust ada --template minimal    a few lines to begin with\n"
    "  cls new go ada --template high-level   on behaviors and planner of the proxy\n"
    "  cls new java ada --template rl         a policy with weights to train";

struct NewArguments {
  std::string language;
  std::string name;
  std::string team_template = "team";
  std::string dir;
  bool json = false;
};

base::Result<void> write_project(const fs::path& folder, const std::vector<ProjectFile>& files) {
  for (const ProjectFile& file : files) {
    const fs::path path = folder / file.path;
    if (auto created = base::create_folders(path.parent_path()); !created) return created;
    if (auto written = base::write_file(path, file.text); !written) return written;
  }

  std::error_code code;
  fs::permissions(folder / "run",
                  fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec,
                  fs::perm_options::add, code);
  if (code) return base::Error{fmt::format("{}: {}", (folder / "run").string(), code.message())};
  return {};
}

void print(const NewArguments& arguments, const std::string& dir,
           const std::vector<ProjectFile>& files) {
  if (arguments.json) {
    base::Json document = {{"schema", "cls.new/1"}, {"dir", dir}};
    document["files"] = base::Json::array();
    for (const ProjectFile& file : files) document["files"].push_back(file.path);
    print_json(document);
    return;
  }

  fmt::print(
      "{}/: {} files; README.md has the next steps:\n"
      "  cd {}\n"
      "  ./run build\n"
      "  cls match {} mock --cycles 1000\n",
      dir, files.size(), process::shell_quoted(dir), arguments.name);
}

int run_new(const NewArguments& arguments) {
  TRY_INIT_OR(kUsage, const auto name, match::check_team_name(arguments.name));

  TRY_INIT_OR(kUsage, const auto files,
              project_files(arguments.language, arguments.name, arguments.team_template));

  const std::string dir = arguments.dir.empty() ? arguments.name : arguments.dir;
  if (const std::string contents = base::contents_of(dir); !contents.empty()) {
    return print_error(kCannotCreate,
                       "{}: has {}; it stays as it is, and --dir selects another folder", dir,
                       contents);
  }

  if (const auto written = write_project(dir, files); !written) {
    return print_error(
        kCannotCreate,
        written.error().message + (arguments.dir.empty() ? "; --dir selects another folder" : ""));
  }

  print(arguments, dir, files);
  return kOk;
}

}  // namespace

void add_new_command(Command& app) {
  auto [command, arguments] = app.command("new", kNewDescription, run_new);
  command
      .option("LANGUAGE", arguments.language,
              "python, javascript, typescript, go, java, rust or csharp")
      .required();

  command.option("NAME", arguments.name, "name of the team").required();
  command.option("--template", arguments.team_template,
                 "team, minimal, high-level or rl (default: team)");
  command.option("--dir DIR", arguments.dir, "folder of the project (default: NAME)");

  command.flag("--json", arguments.json, "print one JSON document").of_group(kOutputGroup);
}

}  // namespace cls::cli

// Fills in the embedded scripts and copies files.
#include "cli/project/team_package.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/io/whole_file.h"
#include "base/text/replace_all.h"
#include "cli/project/project_files.h"
#include "orchestration/match/options/run_command.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using base::Result;

std::string embedded(std::string_view name) {
  const auto& files = embedded_files();
  const auto found = std::find_if(files.begin(), files.end(),
                                  [name](const EmbeddedFile& file) { return file.name == name; });
  return found == files.end() ? std::string() : std::string(found->text);
}

Result<void> write_program(const fs::path& path, std::string_view text) {
  if (auto written = base::write_file(path, text); !written) return written;
  fs::permissions(path, fs::perms(0755));
  return {};
}

// Version control and results are not part of a team.
bool is_left_out(const fs::path& path, const fs::path& package) {
  const fs::path name = path.filename();
  std::error_code code;
  return name == ".git" || name == "runs" || fs::equivalent(path, package, code);
}

void copy_project(const fs::path& from, const fs::path& to, const fs::path& package) {
  fs::create_directories(to);
  for (const fs::directory_entry& entry : fs::directory_iterator(from)) {
    if (is_left_out(entry.path(), package)) continue;

    const fs::path target = to / entry.path().filename();
    if (entry.is_directory() && !entry.is_symlink()) {
      copy_project(entry.path(), target, package);
    } else {
      fs::copy(entry.path(), target, fs::copy_options::copy_symlinks);
    }
  }
}

}  // namespace

std::string start_script(const TeamPackage& package) {
  std::string command = package.command;
  base::replace_all(command, "{port}", "\"$port\"");

  orchestration::match::RunValues values;
  values.team_name = package.name;

  std::string script = embedded("cli/project/league/start");
  base::replace_all(script, "@NAME@", package.name);
  base::replace_all(script, "@COMMAND@", orchestration::match::fill_in(command, values));
  return script;
}

Result<void> write_package(const TeamPackage& package, const fs::path& folder) try {
  if (auto created = base::create_folders(folder); !created) return created;
  if (auto done = write_program(folder / "start", start_script(package)); !done) return done;
  const std::string kill = embedded("cli/project/league/kill");
  if (auto done = write_program(folder / "kill", kill); !done) return done;
  fs::copy_file(package.program, folder / "cls");
  copy_project(package.project, folder / "team", folder);
  return {};
} catch (const fs::filesystem_error& error) {
  return base::Error{fmt::format("{}: {}", error.path1().string(), error.code().message())};
}

}  // namespace cls::cli

// Fills in the embedded scripts and copies files.
#include "cli/project/team_package.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "base/io/whole_file.h"
#include "base/text/replace_all.h"
#include "cli/project/project_files.h"
#include "orchestration/match/options/run_command.h"
#include "orchestration/match/result/match_folder.h"
#include "orchestration/tournament/store/folder.h"
#include "viewer/page/page.h"

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

std::uintmax_t size_of(const fs::path& file) {
  std::error_code code;
  const std::uintmax_t size = fs::is_regular_file(file, code) ? fs::file_size(file, code) : 0;
  return code ? 0 : size;
}

bool is_page(const fs::path& file) {
  std::string start(4096, '\0');
  std::ifstream(file, std::ios::binary).read(start.data(), std::ssize(start));
  return file.extension() == ".html" && viewer::looks_like_page(start) &&
         start.find("\"generator\" content=\"cls ") != std::string::npos;
}

bool is_log(const fs::path& file) {
  std::string name = file.filename().string();
  if (name.ends_with(".gz")) name.resize(name.size() - 3);
  const std::string ending = fs::path(name).extension().string();
  return ending == ".rcg" || ending == ".rcl" || ending == ".rpc";
}

// An earlier package, such as ada-team.old.
bool is_package(const fs::path& folder) {
  std::error_code code;
  const auto has = [&](const char* name) { return fs::is_regular_file(folder / name, code); };
  return has("start") && has("kill") && has("cls") && fs::is_directory(folder / "team", code);
}

// Copies a project, and notes what is not part of a team.
class ProjectCopy {
 public:
  ProjectCopy(const TeamPackage& package, const fs::path& folder, WrittenPackage& written)
      : package_(package), folder_(folder), written_(written) {}

  void copy(const fs::path& from, const fs::path& to) {
    fs::create_directories(to);
    for (const fs::directory_entry& entry : fs::directory_iterator(from)) {
      if (const char* why = why_left_out(entry)) {
        note(entry, why);
        continue;
      }
      const fs::path target = to / entry.path().filename();
      if (entry.is_directory() && !entry.is_symlink()) {
        copy(entry.path(), target);
      } else {
        fs::copy(entry.path(), target, fs::copy_options::copy_symlinks);
        written_.project_bytes += size_of(target);
      }
    }
  }

 private:
  // Null: it is part of the team.
  const char* why_left_out(const fs::directory_entry& entry) const {
    const fs::path& path = entry.path();
    std::error_code code;
    const std::string name = path.filename().string();
    if (fs::equivalent(path, folder_, code)) return "";
    if (name == ".git" || name == "__pycache__") return "";
    if (!package_.environment.empty() && fs::equivalent(path, package_.environment, code)) {
      return "";
    }
    if (!entry.is_directory()) return is_log(path) ? "log" : is_page(path) ? "page" : nullptr;
    if (name == "runs") return "matches";
    if (orchestration::tournament::holds_plan(path)) return "tournament";
    if (is_package(path)) return "package";
    return orchestration::match::is_match_folder(path) ? "match" : nullptr;
  }

  void note(const fs::directory_entry& entry, const char* why) {
    if (*why == '\0') return;
    const fs::path name = entry.path().lexically_relative(package_.project);
    written_.left_out.push_back(
        fmt::format("{}{} ({})", name.string(), entry.is_directory() ? "/" : "", why));
  }

  const TeamPackage& package_;
  const fs::path& folder_;
  WrittenPackage& written_;
};

// A copy works wherever its interpreter is: Python finds pyvenv.cfg beside its own folder.
void copy_environment(const fs::path& from, const fs::path& to, WrittenPackage& written) {
  fs::create_directories(to);
  for (const fs::directory_entry& entry : fs::directory_iterator(from)) {
    const fs::path target = to / entry.path().filename();
    if (entry.path().filename() == "__pycache__") continue;
    if (entry.is_directory() && !entry.is_symlink()) {
      copy_environment(entry.path(), target, written);
    } else {
      fs::copy(entry.path(), target, fs::copy_options::copy_symlinks);
      written.environment_bytes += size_of(target);
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

fs::path environment_of(const fs::path& project) {
  const char* active = std::getenv("VIRTUAL_ENV");
  std::error_code code;
  for (const fs::path& one : {fs::path(active == nullptr ? "" : active), project / ".venv"}) {
    if (!one.empty() && fs::is_regular_file(one / "pyvenv.cfg", code)) return one;
  }
  return {};
}

std::string foreign_interpreter(const fs::path& environment) {
  std::error_code code;
  const fs::path interpreter = fs::weakly_canonical(environment / "bin/python", code);
  for (const char* folder : {"/usr", "/opt", "/bin"}) {
    if (interpreter.string().starts_with(std::string(folder) + "/")) return {};
  }
  return interpreter.string();
}

Result<WrittenPackage> write_package(const TeamPackage& package, const fs::path& folder) try {
  WrittenPackage written;
  TRY(base::create_folders(folder));
  TRY(write_program(folder / "start", start_script(package)));
  TRY(write_program(folder / "kill", embedded("cli/project/league/kill")));

  fs::copy_file(package.program, folder / "cls");
  written.program_bytes = size_of(folder / "cls");
  ProjectCopy(package, folder, written).copy(package.project, folder / "team");
  if (!package.environment.empty()) {
    copy_environment(package.environment, folder / "env", written);
  }
  std::sort(written.left_out.begin(), written.left_out.end());
  return written;
} catch (const fs::filesystem_error& error) {
  return base::Error{fmt::format("{}: {}", error.path1().string(), error.code().message())};
}

}  // namespace cls::cli

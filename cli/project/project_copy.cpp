// Walks a project.
#include "cli/project/project_copy.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>

#include "cli/project/git_ignore.h"
#include "cli/project/private_files.h"
#include "gamelog/files/log_files.h"
#include "match/result/match_folder.h"
#include "tournament/store/folder.h"
#include "viewer/page/page.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;

bool is_page(const fs::path& file) {
  std::string start(4096, '\0');
  std::ifstream(file, std::ios::binary).read(start.data(), std::ssize(start));
  return file.extension() == ".html" && viewer::looks_like_page(start) &&
         start.find("\"generator\" content=\"cls ") != std::string::npos;
}

bool is_log(const fs::path& file) {
  const fs::path ending = fs::path(gamelog::unpacked_name(file.native())).extension();
  return ending == ".rcg" || ending == ".rcl" || ending == ".rpc";
}

// Intermediate files of Rust, often gigabytes.
bool is_cache_of_cargo(const fs::path& folder) {
  static constexpr std::array<std::string_view, 4> kNames = {"deps", "build", "incremental",
                                                             ".fingerprint"};
  const fs::path profile = folder.parent_path();
  return fs::exists(profile.parent_path() / "CACHEDIR.TAG") &&
         std::ranges::find(kNames, folder.filename().string()) != kNames.end();
}

// Intermediate files of the .NET SDK: obj/, and bin/ where the Playmaker is the
// published program next to it. More than ten times its size, with libraries that no host has.
bool is_cache_of_dotnet(const fs::path& folder, const std::string& command) {
  const fs::path objects = folder.parent_path() / "obj";
  const bool published = fs::is_directory(folder.parent_path() / "publish") &&
                         command.find("publish/") != std::string::npos;
  if (folder != objects && !(folder.filename() == "bin" && published)) return false;
  if (!fs::is_directory(objects)) return false;

  const auto is_restored = [](const fs::path& path) {
    return fs::exists(path / "project.assets.json");
  };
  return is_restored(objects) ||
         std::any_of(fs::directory_iterator(objects), {},
                     [&](const fs::directory_entry& entry) { return is_restored(entry.path()); });
}

// An earlier package, such as ada-team.old.
bool is_package(const fs::path& folder) {
  std::error_code code;
  const auto has = [&](const char* name) { return fs::is_regular_file(folder / name, code); };
  return has("start") && has("kill") && has("cls") && fs::is_directory(folder / "team", code);
}

// Folders where builds put their programs and package managers their packages: version control
// ignores them, and a team cannot play without.
constexpr std::array<std::string_view, 13> kBuiltFolders = {
    ".build", ".venv", "bin",    "build",  "dist",   "lib", "node_modules",
    "out",    "pb",    "target", "teampb", "vendor", "wire"};

// Files that are built, too.
constexpr std::array<std::string_view, 6> kBuiltFiles = {".class", ".dll", ".jar",
                                                         ".node",  ".so",  ".wasm"};

bool is_built(const fs::path& path, bool is_folder) {
  if (!is_folder) return std::ranges::find(kBuiltFiles, path.extension()) != kBuiltFiles.end();
  return std::ranges::find(kBuiltFolders, path.filename()) != kBuiltFolders.end();
}

// Why a package cannot have `entry`; null: it is a folder, a link or a readable file.
const char* why_no_copy(const fs::directory_entry& entry) {
  switch (entry.symlink_status().type()) {
    case fs::file_type::fifo:
      return "pipe";
    case fs::file_type::socket:
      return "socket";
    case fs::file_type::block:
    case fs::file_type::character:
      return "device";
    case fs::file_type::symlink:
      return nullptr;
    case fs::file_type::directory:
      return ::access(entry.path().c_str(), R_OK | X_OK) == 0 ? nullptr : "unreadable";
    default:
      return ::access(entry.path().c_str(), R_OK) == 0 ? nullptr : "unreadable";
  }
}

class ProjectCopy {
 public:
  ProjectCopy(const TeamPackage& package, const fs::path& folder)
      : package_(package), folder_(folder) {}

  /// `built`: below a folder of built programs, whose files .gitignore does not leave out.
  void copy(const fs::path& from, const fs::path& to, bool built = false) {
    if (!built) ignored_.read(from);
    fs::create_directories(to);
    for (const fs::directory_entry& entry : fs::directory_iterator(from)) {
      if (const char* why = why_left_out(entry, built)) {
        note(entry, why);
        continue;
      }
      const fs::path target = to / entry.path().filename();
      if (entry.is_directory() && !entry.is_symlink()) {
        copy(entry.path(), target, built || is_built(entry.path(), true));
      } else {
        copy_file(entry, target);
      }
    }
  }

  CopiedProject result() {
    std::ranges::sort(copied_.left_out);
    std::ranges::sort(copied_.links_outside);
    return std::move(copied_);
  }

 private:
  void copy_file(const fs::directory_entry& entry, const fs::path& target) {
    fs::copy(entry.path(), target, fs::copy_options::copy_symlinks);
    if (entry.is_symlink()) return note_link(entry);
    // Scripts compare the dates of programs with those of their sources.
    fs::last_write_time(target, entry.last_write_time());
  }

  // Null: it is part of the team.
  const char* why_left_out(const fs::directory_entry& entry, bool built) const {
    const fs::path& path = entry.path();
    std::error_code code;
    const std::string name = path.filename().string();
    if (const char* why = why_no_copy(entry)) return why;
    if (fs::equivalent(path, folder_, code)) return "";
    if (name == ".git" || name == "__pycache__") return "";
    if (is_cache_of_cargo(path) || is_cache_of_dotnet(path, package_.command)) return "";
    if (!package_.environment.empty() && fs::equivalent(path, package_.environment, code)) {
      return "";
    }
    if (const char* why = why_hidden(path, entry.is_directory(code), built)) {
      const bool enters = entry.is_directory(code) && leads_to_asked(path);
      if (!is_asked_for(path) && !enters) return why;
    }

    if (!entry.is_directory(code)) {
      if (!entry.is_regular_file(code)) return nullptr;  // a link to nothing
      return is_log(path) ? "log" : is_page(path) ? "page" : nullptr;
    }
    if (name == "runs") return "matches";
    if (tournament::holds_plan(path)) return "tournament";
    if (is_package(path)) return "package";
    return match::is_match_folder(path) ? "match" : nullptr;
  }

  std::string in_project(const fs::path& path) const {
    return path.lexically_relative(package_.project).generic_string();
  }

  // True for what --include names, and for all below it.
  bool is_asked_for(const fs::path& path) const {
    return std::ranges::any_of(package_.include, [&](const std::string& wanted) {
      return (in_project(path) + "/").starts_with(folder_text(wanted));
    });
  }

  // True for folders above what --include names.
  bool leads_to_asked(const fs::path& path) const {
    return std::ranges::any_of(package_.include, [&](const std::string& wanted) {
      return folder_text(wanted).starts_with(in_project(path) + "/");
    });
  }

  static std::string folder_text(const std::string& path) {
    return fs::path(path + "/").lexically_normal().generic_string();
  }

  // Null: neither private nor ignored. Folders that --include leads through hide their other files.
  const char* why_hidden(const fs::path& path, bool is_folder, bool built) const {
    if (is_private(path)) return "private";
    if (!built && is_ignored(path, is_folder)) return ".gitignore";
    const fs::path parent = path.parent_path();
    if (package_.include.empty() || parent == package_.project) return nullptr;
    return why_hidden(parent, true, built);
  }

  // False for what the command of the team needs.
  bool is_ignored(const fs::path& path, bool is_folder) const {
    if (!ignored_.ignores(path, is_folder) || is_built(path, is_folder)) return false;
    return package_.command.find(in_project(path)) == std::string::npos;
  }

  void note(const fs::directory_entry& entry, const char* why) {
    if (*why == '\0') return;
    std::error_code code;
    copied_.left_out.push_back(fmt::format("{}{} ({})", in_project(entry.path()),
                                           entry.is_directory(code) ? "/" : "", why));
  }

  void note_link(const fs::directory_entry& entry) {
    const fs::path target = fs::read_symlink(entry.path());
    const fs::path whole = (entry.path().parent_path() / target).lexically_normal();
    if (target.is_relative() && !in_project(whole).starts_with("..")) return;
    copied_.links_outside.push_back(
        fmt::format("{} -> {}", in_project(entry.path()), target.string()));
  }

  const TeamPackage& package_;
  const fs::path& folder_;
  GitIgnore ignored_;
  CopiedProject copied_;
};

}  // namespace

CopiedProject copy_project(const TeamPackage& package, const fs::path& to) {
  const fs::path folder = to.parent_path();
  ProjectCopy copy(package, folder);
  copy.copy(package.project, to);
  return copy.result();
}

}  // namespace cls::cli

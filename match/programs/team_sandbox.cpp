// Lists of folders; warnings.
#include "match/programs/team_sandbox.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>
#include <system_error>

#include "match/programs/team_folder.h"
#include "process/confinement.h"
#include "process/landlock.h"

namespace cls::match {
namespace {

namespace fs = std::filesystem;

constexpr std::array kSystemFolders = {
    "/usr", "/bin", "/sbin", "/lib", "/lib32", "/lib64", "/libx32",
    "/etc", "/opt", "/proc", "/sys", "/nix",   "/gnu",   "/run/current-system"};
// Semaphores and shared memory of the C library, and of Python's multiprocessing, are in /dev/shm.
constexpr std::array kDevices = {"/dev/null",   "/dev/zero",    "/dev/full", "/dev/tty",
                                 "/dev/random", "/dev/urandom", "/dev/shm"};
constexpr std::array kFolderLists = {"PATH", "LD_LIBRARY_PATH"};

// None of them holds a secret. Names that end with '_' stand for all that begin so.
constexpr std::string_view kVariables[] = {
    "PATH", "LD_LIBRARY_PATH", "HOME", "USER", "LOGNAME", "SHELL",
    "LANG", "LANGUAGE",        "LC_",  "TZ",   "TERM"};

bool is_passed(std::string_view name) {
  return std::ranges::any_of(kVariables, [&](std::string_view one) {
    return one.ends_with('_') ? name.starts_with(one) : name == one;
  });
}

fs::path real(const fs::path& path) {
  std::error_code code;
  const fs::path found = fs::weakly_canonical(fs::absolute(path, code), code);
  return found.has_filename() ? found : found.parent_path();
}

bool encloses(const fs::path& folder, const fs::path& path) {
  return std::ranges::mismatch(folder, path).in1 == folder.end();
}

// Adds the folder or, if it contains a hidden one, the rest of it. The kernel knows no
// exceptions from what it allows.
void add_folder(const fs::path& folder, const std::vector<fs::path>& hidden,
                std::vector<fs::path>& folders) {
  const auto is_hidden = [&](const fs::path& one) { return encloses(one, folder); };
  const auto has_hidden = [&](const fs::path& one) { return encloses(folder, one); };
  if (std::ranges::any_of(hidden, is_hidden)) return;
  if (std::ranges::none_of(hidden, has_hidden)) {
    folders.push_back(folder);
    return;
  }

  std::error_code code;
  for (const auto& entry : fs::directory_iterator(folder, code)) {
    // The target of a link has an entry of its own, or is hidden.
    if (!entry.is_symlink(code)) add_folder(entry.path(), hidden, folders);
  }
}

// The absolute folders of a variable like PATH, without those above the home folder, which are not
// folders of programs.
std::vector<fs::path> listed_folders(const char* variable) {
  const char* value = std::getenv(variable);
  std::string_view rest = value == nullptr ? "" : value;
  const char* home_variable = std::getenv("HOME");
  const fs::path home = home_variable == nullptr ? fs::path("/") : real(home_variable);
  std::vector<fs::path> folders;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(':'), rest.size());
    const fs::path folder(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));

    if (folder.is_absolute() && !encloses(real(folder), home)) folders.push_back(real(folder));
  }
  return folders;
}

}  // namespace

process::FileAccess team_files(const fs::path& folder, const std::vector<fs::path>& hidden) {
  std::vector<fs::path> closed;
  for (const fs::path& one : hidden) closed.push_back(real(one));

  process::FileAccess files;
  for (const char* one : kSystemFolders) add_folder(real(one), closed, files.readable);
  for (const char* variable : kFolderLists) {
    for (const fs::path& one : listed_folders(variable)) add_folder(one, closed, files.readable);
  }
  for (const char* one : kDevices) add_folder(real(one), closed, files.writable);
  files.writable.push_back(real(folder));
  return files;
}

std::vector<process::EnvironmentChange> team_environment() {
  std::vector<process::EnvironmentChange> variables;
  for (char** line = environ; *line != nullptr; ++line) {
    const std::string_view text(*line);
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos || !is_passed(text.substr(0, equals))) continue;
    variables.push_back(
        {std::string(text.substr(0, equals)), std::string(text.substr(equals + 1))});
  }
  std::ranges::sort(variables, {}, &process::EnvironmentChange::name);
  return variables;
}

std::string missing_sandbox() {
  if (process::landlock_version() == 0) {
    return "this kernel has no Landlock: the programs of team:DIR can use all your files; run them "
           "as another user or in a container, or accept that with --no-sandbox";
  }
  if (process::can_confine()) return {};
  return "this kernel has no seccomp: the programs of team:DIR can slow down or end all your "
         "processes; run them as another user or in a container, or accept that with --no-sandbox";
}

std::vector<std::string> sandbox_warnings(const MatchOptions& options,
                                          const fs::path& match_folder) {
  std::vector<std::string> lines;
  if (!options.sandbox || !has_external_team(options)) return lines;
  if (std::string missing = missing_sandbox(); !missing.empty()) return {std::move(missing)};

  for (const soccer::Side side : soccer::kBothSides) {
    const Endpoint& own = endpoint_of(options, side);
    const Endpoint& opponent = endpoint_of(options, soccer::opponent(side));
    for (const fs::path& folder : team_folders(own)) {
      const fs::path team = real(folder);
      if (!match_folder.empty() && encloses(team, real(match_folder))) {
        lines.push_back(fmt::format(
            "the folder of {} contains the match folder: the team can change the results; "
            "choose another --dir",
            own.text));
      }

      for (const fs::path& other : team_folders(opponent)) {
        if (real(other) == team || !encloses(team, real(other))) continue;
        lines.push_back(fmt::format(
            "the folder of {} contains that of {}: it can change the other team; move one of them",
            own.text, opponent.text));
      }
    }
  }
  return lines;
}

}  // namespace cls::match

// Lists of folders; warnings.
#include "match/programs/team_sandbox.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>
#include <system_error>
#include <utility>

#include "match/programs/team_folder.h"
#include "match/terms/run_command.h"
#include "process/confinement.h"
#include "process/landlock.h"
#include "process/namespaces.h"

namespace cls::match {
namespace {

namespace fs = std::filesystem;

constexpr std::array kSystemFolders = {
    "/usr", "/bin", "/sbin", "/lib", "/lib32", "/lib64", "/libx32",
    "/etc", "/opt", "/proc", "/sys", "/nix",   "/gnu",   "/run/current-system"};
constexpr std::array kDevices = {"/dev/null", "/dev/zero",   "/dev/full",
                                 "/dev/tty",  "/dev/random", "/dev/urandom"};
// Of semaphores and shared memory of the C library, and of Python's multiprocessing.
constexpr const char* kSharedMemory = "/dev/shm";
constexpr const char* kTemporary = "/tmp";
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

// The absolute folders of a variable like PATH, as it names them, without those above the home
// folder, which are not folders of programs.
std::vector<fs::path> absolute_folders(const char* variable) {
  const char* value = std::getenv(variable);
  std::string_view rest = value == nullptr ? "" : value;
  const char* home_variable = std::getenv("HOME");
  const fs::path home = home_variable == nullptr ? fs::path("/") : real(home_variable);
  std::vector<fs::path> folders;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(':'), rest.size());
    const fs::path folder(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));

    if (folder.is_absolute() && !encloses(real(folder), home)) folders.push_back(folder);
  }
  return folders;
}

// Why the host cannot give `wanted` its namespaces; empty: it can.
std::string missing_namespaces_for(std::string_view wanted) {
  const std::string& missing = process::missing_namespaces();
  return missing.empty() ? std::string()
                         : fmt::format("{}: this host cannot make them: {}", wanted, missing);
}

}  // namespace

process::FileAccess team_files(const fs::path& folder, const std::vector<fs::path>& hidden,
                               bool namespaces) {
  std::vector<fs::path> closed;
  for (const fs::path& one : hidden) closed.push_back(real(one));
  std::vector<fs::path> known(kSystemFolders.begin(), kSystemFolders.end());
  for (const char* variable : kFolderLists) {
    for (fs::path& one : absolute_folders(variable)) known.push_back(std::move(one));
  }

  process::FileAccess files;
  for (const fs::path& one : known) add_folder(real(one), closed, files.readable);
  for (const char* one : kDevices) files.writable.push_back(real(one));
  if (!namespaces) add_folder(real(kSharedMemory), closed, files.writable);
  files.writable.push_back(real(folder));
  if (!namespaces) return files;

  files.own = {kTemporary, kSharedMemory};
  for (const fs::path& one : closed) {
    if (one != real(folder) && encloses(real(folder), one)) files.covered.push_back(one);
  }
  for (const fs::path& one : known) {
    if (real(one) != one) files.links.push_back({one, real(one)});
  }
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

void put_in_sandbox(process::CommandPlan& plan, const fs::path& folder,
                    const std::vector<fs::path>& hidden, bool namespaces) {
  plan.empty_environment = true;
  const std::vector<process::EnvironmentChange> own = std::exchange(plan.environment, {});
  plan.environment = team_environment();
  plan.environment.insert(plan.environment.end(), own.begin(), own.end());
  plan.confined = process::can_confine();
  if (process::landlock_version() > 0) plan.files = team_files(folder, hidden, namespaces);
}

fs::path playmaker_folder(std::string_view command) { return real(folder_in(command)); }

void put_playmaker_in_sandbox(process::CommandPlan& plan, std::string_view command,
                              const std::vector<fs::path>& hidden) {
  const fs::path folder = playmaker_folder(command);
  put_in_sandbox(plan, folder, hidden, true);
  plan.folder = real(".");
  if (plan.files && plan.folder != folder) plan.files->own.push_back(plan.folder);
}

std::vector<std::string> playmaker_commands(const Endpoint& side) {
  std::vector<std::string> commands;
  if (side.kind == Endpoint::Kind::kRun) commands.push_back(side.command);
  if (side.kind != Endpoint::Kind::kMixed) return commands;
  for (const Endpoint& part : side.parts) {
    for (std::string& one : playmaker_commands(part)) commands.push_back(std::move(one));
  }
  return commands;
}

bool has_sandboxed_playmakers(const MatchOptions& options, soccer::Side side) {
  return options.sandbox_playmakers && side != soccer::Side::kNeutral &&
         !playmaker_commands(endpoint_of(options, side)).empty();
}

std::vector<fs::path> hidden_from_playmakers(const MatchOptions& options, soccer::Side side,
                                             const fs::path& folder) {
  const Endpoint& other = endpoint_of(options, soccer::opponent(side));
  std::vector<fs::path> hidden = team_folders(other);
  for (const std::string& command : playmaker_commands(other)) {
    hidden.push_back(playmaker_folder(command));
  }
  hidden.push_back(folder);
  return hidden;
}

bool has_namespaces(const MatchOptions& options, soccer::Side side) {
  const bool wanted = options.sandbox == Sandbox::kOn || options.sandbox == Sandbox::kNamespaces;
  return wanted && options.bind_clients &&
         endpoint_of(options, side).kind == Endpoint::Kind::kTeam &&
         process::missing_namespaces().empty();
}

std::string refused_without_namespaces(const MatchOptions& options) {
  const auto has_playmakers = [&](soccer::Side side) {
    return has_sandboxed_playmakers(options, side);
  };
  if (std::ranges::any_of(soccer::kBothSides, has_playmakers)) {
    std::string why = missing_namespaces_for("--sandbox-playmakers needs namespaces");
    if (!why.empty()) return why;
  }

  if (options.sandbox != Sandbox::kNamespaces || !has_external_team(options)) return {};
  constexpr std::string_view kWanted = "--sandbox=namespaces";
  if (!options.bind_clients) {
    return fmt::format("{}: with --no-bind-clients programs of any place take part", kWanted);
  }
  return missing_namespaces_for(kWanted);
}

std::string missing_sandbox(const MatchOptions& options) {
  if (options.sandbox == Sandbox::kOff) return {};
  if (process::landlock_version() == 0) {
    return "this kernel has no Landlock: the programs of team:DIR can use all your files; run them "
           "as another user or in a container, or accept that with --no-sandbox";
  }
  if (!process::can_confine()) {
    return "this kernel has no seccomp: the programs of team:DIR can slow down or end all your "
           "processes; run them as another user or in a container, or accept that with "
           "--no-sandbox";
  }

  const std::string& missing = process::missing_namespaces();
  if (options.sandbox != Sandbox::kOn || !options.bind_clients || missing.empty()) return {};
  return fmt::format(
      "this host cannot make namespaces ({}): the programs of team:DIR share its network, shared "
      "memory and sockets with each other (docs/security.md); accept that with --sandbox=files",
      missing);
}

std::vector<std::string> sandbox_warnings(const MatchOptions& options,
                                          const fs::path& match_folder) {
  std::vector<std::string> lines;
  if (options.sandbox == Sandbox::kOff || !has_external_team(options)) return lines;
  if (std::string missing = missing_sandbox(options); !missing.empty()) return {std::move(missing)};

  for (const soccer::Side side : soccer::kBothSides) {
    if (has_namespaces(options, side)) continue;
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

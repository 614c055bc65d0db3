// Settings from arguments and files.
#include "match/terms/server_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "base/io/home_path.h"
#include "base/io/whole_file.h"
#include "base/text/number_text.h"
#include "base/text/split.h"
#include "match/terms/endpoint.h"
#include "soccer/parameters/configuration.h"
#include "soccer/parameters/parameter.h"
#include "soccer/parameters/server_setting.h"

namespace cls::match {
namespace {

using base::Error;
using base::Result;
using soccer::ConfigurationItem;

constexpr int kMaxIncludeDepth = 16;

// Parameters without a table in rcssserver, in the same form.
using OtherTable = soccer::ParameterTable<ServerSettings>;

const OtherTable& csv_table() {
  static const OtherTable table = {
      {"save", &ServerSettings::save_csv, 0, "", "append a result line at the end"},
      {"filename", &ServerSettings::csv_file, 0, "", "to this file"}};
  return table;
}

const OtherTable& sync_table() {
  static const OtherTable table = {
      {"max_wait_ms", &ServerSettings::max_wait_ms, 0, "ms", "longest wait for (done)"},
      {"max_missed", &ServerSettings::max_missed, 0, "cyc",
       "cycles in a row with an answer missing"}};
  return table;
}

Result<void> set_other(ServerSettings& settings, const OtherTable& table,
                       const ConfigurationItem& item) {
  ServerSettings changed = settings;
  TRY(set_parameter(changed, table, item.name, item.value));
  if (changed.max_wait_ms <= 0 || changed.max_missed < 0) {
    return Error{fmt::format("parameter '{}': {} is too small", item.name, item.value)};
  }

  changed.csv_file = base::expand_home(changed.csv_file);
  settings = std::move(changed);
  return {};
}

constexpr std::string_view kTeam = "team";
constexpr char kName = ':';
constexpr char kDoor = '@';
constexpr std::string_view kAgents = "cls";
constexpr std::string_view kTrainer = "trainer";

struct BoundSide {
  bool external = false;
  std::string name;
  int door = 0;
};

// "cls", "team", "team:A+B", "team@100:A+B".
std::optional<BoundSide> parse_side(std::string_view word) {
  if (word == kAgents) return BoundSide{};
  if (!word.starts_with(kTeam)) return std::nullopt;
  word.remove_prefix(kTeam.size());
  BoundSide side{true, {}, 0};
  if (word.starts_with(kDoor)) {
    const std::size_t end = std::min(word.find(kName), word.size());
    const auto door = base::parse_int(word.substr(1, end - 1));
    if (!door || *door <= 0) return std::nullopt;
    side.door = *door;
    word.remove_prefix(end);
  }

  if (word.empty()) return side;
  if (!word.starts_with(kName) || !check_team_name(word.substr(1))) return std::nullopt;
  side.name = word.substr(1);
  return side;
}

std::string side_text(const BoundSides& sides, soccer::Side side) {
  if (!sides.external[side]) return std::string(kAgents);
  std::string text(kTeam);
  if (sides.doors[side] != 0) text += fmt::format("{}{}", kDoor, sides.doors[side]);
  if (!sides.names[side].empty()) text += fmt::format("{}{}", kName, sides.names[side]);
  return text;
}

// "team,cls" or "team:A+B,cls,trainer": left side, right side.
Result<void> set_match(ServerSettings& settings, const ConfigurationItem& item) {
  const std::vector<std::string_view> words = base::split(item.value, ',');
  const bool trainer = words.size() == 3 && words[2] == kTrainer;
  const bool complete = item.name == "sides" && (words.size() == 2 || trainer);
  const auto left = complete ? parse_side(words[0]) : std::nullopt;
  const auto right = complete ? parse_side(words[1]) : std::nullopt;
  if (!left || !right) {
    return Error{
        fmt::format("match::{}: only a match sets this, as match::sides=team,cls", item.name)};
  }
  settings.bound = BoundSides{{left->external, right->external},
                              trainer,
                              {left->name, right->name},
                              {left->door, right->door}};
  return {};
}

Result<void> apply_file(ServerSettings& settings, const std::filesystem::path& file, int depth);

// "sync.max_missed" is the same as "sync::max_missed".
ConfigurationItem with_module(ConfigurationItem item) {
  constexpr std::string_view kSync = "sync.";
  if (item.module.empty() && item.name.starts_with(kSync)) {
    item.module = "sync";
    item.name.erase(0, kSync.size());
  }
  return item;
}

Result<void> apply_item(ServerSettings& settings, const ConfigurationItem& written,
                        const std::filesystem::path& folder, int depth) {
  const ConfigurationItem item = with_module(written);
  if (item.name == "help") {
    settings.help = true;
    return {};
  }
  if (item.module.empty() && item.name == "include") {
    return apply_file(settings, folder / base::expand_home(item.value), depth + 1);
  }
  if (item.name == "version") {
    if (item.value == kConfigurationVersion) return {};
    return Error{fmt::format(
        "a configuration of version {0}, not {1}; compare its values with docs/server.md and set "
        "the version to '{1}', or delete the file for the defaults",
        item.value, kConfigurationVersion)};
  }

  if (item.module == "server") {
    return soccer::set_server_parameter(settings.server, item.name, item.value);
  }
  if (item.module == "player") {
    return set_parameter(settings.player, soccer::player_param_table(), item.name, item.value);
  }
  if (item.module == "CSVSaver") return set_other(settings, csv_table(), item);
  if (item.module == "sync") return set_other(settings, sync_table(), item);
  if (item.module == "match") return set_match(settings, item);
  return Error{fmt::format("'{}': must begin with server, player, CSVSaver or sync, not '{}'",
                           item.name, item.module)};
}

Result<void> apply_file(ServerSettings& settings, const std::filesystem::path& file, int depth) {
  if (depth > kMaxIncludeDepth) return Error{fmt::format("{}: circular include", file.string())};

  // A pipe would be waited for, and some devices have no end.
  std::error_code code;
  if (std::filesystem::exists(file, code) && !std::filesystem::is_regular_file(file, code)) {
    return Error{
        fmt::format("cannot read {}: {}", file.string(), base::why_no_file(file).value_or(""))};
  }

  const auto text = base::read_text(file);
  if (!text) return Error{fmt::format("cannot read {}", file.string())};
  const auto items = soccer::parse_configuration(*text);
  if (!items) return Error{fmt::format("{}: {}", file.string(), items.error().message)};
  for (const ConfigurationItem& item : *items) {
    const auto done = apply_item(settings, item, file.parent_path(), depth);
    if (!done) {
      return Error{fmt::format("{}:{}: {}", file.string(), item.line, done.error().message)};
    }
  }
  return {};
}

}  // namespace

std::string bound_sides_argument(const BoundSides& sides) {
  return fmt::format("match::sides='{},{}{}'", side_text(sides, soccer::Side::kLeft),
                     side_text(sides, soccer::Side::kRight), sides.trainer ? ",trainer" : "");
}

Result<void> apply_arguments(ServerSettings& settings, const std::vector<std::string>& arguments) {
  const auto items = soccer::parse_configuration(soccer::join_arguments(arguments));
  if (!items) {
    // A command line has no line numbers.
    const std::string& message = items.error().message;
    return Error{message.substr(message.find(": ") + 2)};
  }
  for (const ConfigurationItem& item : *items) TRY(apply_item(settings, item, {}, 0));
  return {};
}

Result<void> apply_file(ServerSettings& settings, const std::filesystem::path& file) {
  return apply_file(settings, file, 0);
}

Result<std::vector<std::filesystem::path>> apply_folder(ServerSettings& settings,
                                                        const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> found;
  if (folder.empty()) return found;
  for (const char* name : {"server.conf", "player.conf", "CSVSaver.conf"}) {
    const std::filesystem::path file = folder / name;
    std::error_code error;
    if (!std::filesystem::exists(file, error)) continue;

    TRY(apply_file(settings, file));
    found.push_back(file);
  }
  return found;
}

std::filesystem::path configuration_folder() {
  if (const char* named = std::getenv("RCSS_CONF_DIR")) return base::expand_home(named);
  const char* home = std::getenv("HOME");
  return home == nullptr ? std::filesystem::path() : std::filesystem::path(home) / ".rcssserver";
}

}  // namespace cls::match

// Looking a team up.
#include "cli/support/named_side.h"

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "base/text/suggestion.h"
#include "cli/support/exit_code.h"
#include "orchestration/tournament/config/config_file.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using namespace orchestration::tournament;

bool is_side_form(const std::string& side) {
  return side == "mock" || side.find(':') != std::string::npos;
}

std::string unknown(const std::string& side, const std::string& near, const fs::path& file) {
  return fmt::format("unknown side '{}'; did you mean '{}'? (a team of {})", side, near,
                     file.string());
}

}  // namespace

int resolve_named_side(std::string& side, std::string& team_name, const std::string& config_file) {
  if (is_side_form(side)) return kDone;
  std::error_code code;
  const std::optional<fs::path> file = config_file.empty() ? find_config(fs::current_path(code))
                                                           : std::optional<fs::path>(config_file);
  if (!file) return kDone;
  if (!fs::is_regular_file(*file, code)) {
    fmt::print(stderr, "cls: no such file: {}\n", file->string());
    return kNoInput;
  }
  const ConfigReading reading = read_config(*file);
  for (const std::string& mistake : reading.mistakes) fmt::print(stderr, "cls: {}\n", mistake);
  if (!reading.mistakes.empty()) return kBadConfig;
  if (const int team = team_index(reading.config, side); team >= 0) {
    if (team_name.empty()) team_name = side;
    side = endpoint_from(reading.config.folder,
                         reading.config.teams[static_cast<std::size_t>(team)].endpoint);
    return kDone;
  }
  std::vector<std::string_view> known = {"mock"};
  for (const TeamEntry& team : reading.config.teams) known.push_back(team.name);
  const std::string near(base::nearest_name(side, known));
  if (near.empty() || near == "mock") return kDone;  // the list of side forms says it better
  fmt::print(stderr, "cls: {}\n", unknown(side, near, *file));
  return kUsage;
}

}  // namespace cls::cli

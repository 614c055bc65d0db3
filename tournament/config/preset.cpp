// Presets differ in stages and conditions; head and teams are the same.
#include "tournament/config/preset.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "base/text/suggestion.h"
#include "match/terms/endpoint.h"

namespace cls::tournament {
namespace {

using base::Error;
using base::Result;

constexpr std::size_t kMockTeams = 8;

constexpr const char* kHead =
    "# {0}. `cls tournament plan DIR` lists its matches, `cls tournament run DIR`\n"
    "# plays them. docs/tournaments.md describes stages and their keys.\n"
    "\n"
    "schema = 1  # version of the format of this file\n"
    "\n"
    "[tournament]\n"
    "format = \"stages\"\n"
    "seed = 1             # all seeds and draws follow from it\n"
    "draw = true          # the first groups are drawn; false: in the order of the teams below\n"
    "mode = \"realtime\"    # ten cycles a second, as the league plays; \"lockstep\" is faster\n";

// {0}: sizes of the divisions.
constexpr const char* kLeagueStages =
    "\n"
    "[[stages]]\n"
    "name = \"seeding round\"\n"
    "groups = 2\n"
    "\n"
    "[[stages]]           # groups are drawn again by the ranks of the stage before\n"
    "name = \"first round\"\n"
    "groups = 2\n"
    "\n"
    "[[stages]]\n"
    "name = \"second round\"\n"
    "groups = 2\n"
    "\n"
    "[[stages]]\n"
    "name = \"third round\"\n"
    "groups = 2\n"
    "\n"
    "[[stages]]           # home and away; divisions by average points of three rounds\n"
    "name = \"main round\"\n"
    "ranked_by = [\"first round\", \"second round\", \"third round\"]\n"
    "divisions = [{0}]\n"
    "legs = 2\n"
    "\n"
    "[[stages]]           # rank N plays rank N-1, and the winner climbs\n"
    "name = \"final day\"\n"
    "format = \"stepladder\"\n"
    "\n"
    "[server]\n"
    "game_log_version = 5\n";

constexpr const char* kStarterStages =
    "coach = false        # no online coaches\n"
    "\n"
    "[[stages]]\n"
    "name = \"round\"\n"
    "\n"
    "[[stages]]           # rank N plays rank N-1, and the winner climbs\n"
    "name = \"final day\"\n"
    "format = \"stepladder\"\n"
    "\n"
    "[server]\n"
    "half_time = 300\n"
    "nr_extra_halfs = 0   # a level final goes to penalties directly\n"
    "fullstate_l = true\n"
    "fullstate_r = true\n"
    "game_log_version = 5\n"
    "\n"
    "[player]\n"
    "player_types = 1     # no heterogeneous types\n";

constexpr const char* kMixedStages =
    "bind_clients = true  # so that the parts of a team may have names of their own\n"
    "\n"
    "[[stages]]\n"
    "name = \"challenge\"\n"
    "\n"
    "[server]\n"
    "game_log_version = 5\n";

struct Preset {
  std::string_view name;
  const char* title;
  std::size_t min_teams;  // two in each group and division
  const char* stages;
  bool mixed = false;  // each two teams are one
};
constexpr Preset kPresets[] = {
    {"robocup", "The format of the RoboCup 2D league", 4, kLeagueStages},
    {"starter", "The conditions of a starter league", 2, kStarterStages},
    {"mixed", "A challenge of mixed teams, each of two teams", 4, kMixedStages, true},
};

std::string teams_text(const std::vector<std::string>& teams) {
  std::string text =
      "\n"
      "# The teams: any side of `cls match`. team:DIR is a folder with a start script.\n";
  if (teams.empty()) {
    for (std::size_t i = 1; i <= kMockTeams; ++i) {
      text += fmt::format("[teams.T{}]\nendpoint = \"mock\"\n", i);
    }
  }
  // Quoted, because a name may contain '+'.
  for (const std::string& team : teams) {
    text += fmt::format("[teams.\"{0}\"]\nendpoint = \"team:{0}\"\n", team);
  }
  return text;
}

// The first of two teams has the goalie, the defenders and the coach.
std::string mixed_teams_text(std::vector<std::string> teams) {
  std::string text =
      "\n"
      "# Two teams play as one: mix:AGENTS=SIDE;AGENTS=SIDE (docs/matches.md). Change pairs and "
      "players\n"
      "# as they were drawn.\n";
  if (teams.empty()) {
    for (std::size_t i = 1; i <= kMockTeams / 2; ++i) {
      text += fmt::format(
          "[teams.M{}]\nendpoint = \"mix:goalie,defenders,coach=mock;others=mock:simple\"\n", i);
    }
  }

  std::set<std::string> names;
  for (std::size_t i = 0; i + 1 < teams.size(); i += 2) {
    // As long as a name of a team may be. Equal names get a number.
    const std::string first = teams[i].substr(0, 7);
    std::string name = fmt::format("{}+{}", first, teams[i + 1].substr(0, 7));
    for (int number = 2; !names.insert(name).second; ++number) {
      name = fmt::format("{}+{}{}", first, teams[i + 1].substr(0, 5), number);
    }
    text += fmt::format(
        "[teams.\"{}\"]\nendpoint = \"mix:goalie,defenders,coach=team:{};others=team:{}\"\n", name,
        teams[i], teams[i + 1]);
  }
  return text;
}

}  // namespace

std::vector<std::string_view> preset_names() {
  std::vector<std::string_view> names;
  std::ranges::transform(kPresets, std::back_inserter(names), &Preset::name);
  return names;
}

Result<std::string> preset_config(std::string_view name, const std::vector<std::string>& teams) {
  const auto* chosen = std::ranges::find(kPresets, name, &Preset::name);
  if (chosen == std::end(kPresets)) {
    const std::string_view near = base::nearest_name(name, preset_names());
    return Error{fmt::format("unknown preset '{}'; {}", name,
                             near.empty()
                                 ? fmt::format("presets: {}", fmt::join(preset_names(), ", "))
                                 : fmt::format("did you mean '{}'?", near))};
  }
  for (const std::string& team : teams) {
    TRY(match::check_team_name(team));
  }

  const std::size_t count = teams.empty() ? kMockTeams : teams.size();
  if (count < chosen->min_teams) {
    return Error{fmt::format("preset '{}' requires at least {} teams, there are {}", name,
                             chosen->min_teams, count)};
  }
  if (chosen->mixed && count % 2 != 0) {
    return Error{
        fmt::format("preset '{}' requires an even number of teams, there are {}", name, count)};
  }

  const std::size_t upper = (count + 1) / 2;
  return fmt::format(fmt::runtime(kHead), chosen->title) +
         fmt::format(fmt::runtime(chosen->stages), fmt::format("{}, {}", upper, count - upper)) +
         (chosen->mixed ? mixed_teams_text(teams) : teams_text(teams));
}

}  // namespace cls::tournament

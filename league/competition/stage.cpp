// Checks stages one after the other, with the number of teams that each of them leaves.
#include "league/competition/stage.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "base/text/suggestion.h"

namespace cls::league {
namespace {

bool contains(const std::vector<std::string>& names, std::string_view wanted) {
  return std::ranges::find(names, wanted) != names.end();
}

std::string unknown(std::string_view what, std::string_view name,
                    const std::vector<std::string>& known) {
  const std::vector<std::string_view> names(known.begin(), known.end());
  return fmt::format("unknown {} '{}'{}", what, name, base::did_you_mean(name, names));
}

class StageCheck {
 public:
  StageCheck(const std::vector<Stage>& stages, const std::vector<std::string>& teams)
      : stages_(stages), teams_(teams) {}

  std::vector<std::string> errors() {
    std::set<std::string> joined;
    for (const Stage& stage : stages_) joined.insert(stage.join.begin(), stage.join.end());
    for (const std::string& team : teams_) present_ += !joined.contains(team);
    for (const Stage& stage : stages_) {
      stage_ = &stage;
      check();
      before_.push_back(stage.name);
    }
    return std::move(errors_);
  }

 private:
  void require(bool condition, const std::string& message) {
    if (!condition) errors_.push_back(fmt::format("stage '{}': {}", stage_->name, message));
  }

  void check() {
    check_name();
    check_earlier("ranked_by", stage_->ranked_by);
    check_earlier("carry", stage_->carry);
    check_joining();

    require(stage_->teams <= present_,
            fmt::format("teams = {}: only {} are left", stage_->teams, present_));
    const int entrants =
        (stage_->teams > 0 ? stage_->teams : present_) + static_cast<int>(stage_->join.size());
    require(entrants >= 2, fmt::format("{} of at least two teams", entrants));
    present_ += static_cast<int>(stage_->join.size());

    if (stage_->format == StageFormat::kGroups) {
      check_groups(entrants);
    } else {
      require(stage_->groups == 1 && stage_->drawn.empty() && stage_->divisions.empty() &&
                  stage_->carry.empty(),
              fmt::format("groups, divisions and carry are keys of format 'groups', not of '{}'",
                          name(stage_->format)));
    }
  }

  // A comma separates the stage from the group or tie in the names of matches.
  void check_name() {
    const std::string& name = stage_->name;
    require(!name.empty(), "a stage needs a name");
    require(name.find_first_of(",[]\n\r\t") == std::string::npos && name.size() <= 60,
            "a name has at most 60 characters, and no comma, bracket or line break");
    require(!contains(before_, name), "another stage has this name");
  }

  void check_earlier(std::string_view key, const std::vector<std::string>& names) {
    for (const std::string& name : names) {
      require(contains(before_, name),
              fmt::format("{}: {}", key, unknown("earlier stage", name, before_)));
    }
  }

  void check_joining() {
    require(stage_->join.empty() || !before_.empty(),
            "join: all teams take part in the first stage unless a later one has them in join");
    for (const std::string& team : stage_->join) {
      require(contains(teams_, team), "join: " + unknown("team", team, teams_));
      require(joined_.insert(team).second, fmt::format("join: '{}' has joined already", team));
    }
  }

  void check_groups(int entrants) {
    const bool drawn = !stage_->drawn.empty();
    const bool by_rank = !stage_->divisions.empty();
    require(!(by_rank && (drawn || stage_->groups != 1)),
            "groups are drawn, divisions follow the ranks; set one of these keys");
    if (drawn) check_drawn();
    require(drawn || by_rank || entrants >= 2 * stage_->groups,
            fmt::format("groups = {} require at least {} teams, there are {}", stage_->groups,
                        2 * stage_->groups, entrants));
    if (!by_rank) return;
    const int sum = std::accumulate(stage_->divisions.begin(), stage_->divisions.end(), 0);
    require(sum == entrants, fmt::format("divisions = [{}] are for {} teams, there are {}",
                                         fmt::join(stage_->divisions, ", "), sum, entrants));
  }

  void check_drawn() {
    require(before_.empty(), "groups by name: possible in the first stage only");
    require(stage_->teams == 0, "groups by name: teams would leave out some of them");

    std::set<std::string> seen;
    for (const auto& group : stage_->drawn) {
      require(group.size() >= 2,
              fmt::format("groups: [{}] has less than two teams", fmt::join(group, ", ")));
      for (const std::string& team : group) {
        require(contains(teams_, team), "groups: " + unknown("team", team, teams_));
        require(seen.insert(team).second, fmt::format("groups: '{}' is there twice", team));
      }
    }

    for (const Stage& stage : stages_) {
      for (const std::string& team : stage.join) {
        require(seen.insert(team).second,
                fmt::format("groups: '{}' joins in stage '{}'", team, stage.name));
      }
    }
    for (const std::string& team : teams_) {
      require(seen.contains(team), fmt::format("groups: '{}' is in none of them", team));
    }
  }

  const std::vector<Stage>& stages_;
  const std::vector<std::string>& teams_;
  const Stage* stage_ = nullptr;
  std::vector<std::string> before_;
  std::set<std::string> joined_;
  int present_ = 0;  // teams that take part so far
  std::vector<std::string> errors_;
};

}  // namespace

std::vector<std::string> stage_errors(const std::vector<Stage>& stages,
                                      const std::vector<std::string>& teams) {
  return StageCheck(stages, teams).errors();
}

}  // namespace cls::league

// Reads the recorded decisions of a match folder and prints some of them.
#include "cli/explain/decision_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "base/io/whole_file.h"
#include "base/text/decimal_text.h"
#include "base/text/json.h"
#include "base/text/printable.h"
#include "base/text/table.h"
#include "base/text/wrap_text.h"
#include "cli/support/print_error.h"
#include "cli/terminal/json_stdout.h"
#include "cli/terminal/terminal.h"
#include "soccer/side.h"
#include "viewer/decisions/decision_files.h"
#include "viewer/decisions/decision_plan.h"
#include "viewer/page/page_decisions.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using base::Json;
using base::Table;
using viewer::ConsideredAction;

struct Decision {
  soccer::Side side = soccer::Side::kLeft;
  int unum = 0;
  const viewer::DecisionSample* sample = nullptr;
  std::vector<ConsideredAction> considered;
};

// The recordings of the sides that are asked for.
int read_teams(const DecisionQuestion& question, std::vector<viewer::TeamDecisions>& teams) {
  if (const auto why = base::why_no_folder(question.folder)) {
    return print_error(kNoInput, "{}: {}", question.folder, *why);
  }
  for (const auto& [side, name] : {std::pair("left", viewer::kLeftWorldModelsFile),
                                   std::pair("right", viewer::kRightWorldModelsFile)}) {
    if (!question.side.empty() && question.side != side) continue;
    const fs::path file = fs::path(question.folder) / name;
    std::error_code code;
    if (!fs::exists(file, code) && !code) continue;
    TRY_INIT_OR(kBadData, auto team, viewer::read_recorded_decisions(file));
    teams.push_back(std::move(team));
  }
  if (!teams.empty()) return kOk;
  return print_error(
      kNoInput, "{}: has no recorded decisions{}; play the match with --record-world-models",
      question.folder, question.side.empty() ? "" : " of the " + question.side + " side");
}

/// One decision is asked for, whether or not there was something to consider.
bool names_one(const DecisionQuestion& question) {
  return !question.side.empty() && question.unum && question.cycle;
}

std::vector<Decision> find_decisions(const DecisionQuestion& question,
                                     const std::vector<viewer::TeamDecisions>& teams) {
  std::vector<Decision> found;

  for (const viewer::TeamDecisions& team : teams) {
    int unum = 0;
    for (const auto& samples : team.players) {
      ++unum;
      if (question.unum && *question.unum != unum) continue;
      for (const viewer::DecisionSample& sample : samples) {
        if (question.cycle && *question.cycle != sample.cycle) continue;
        if (sample.plan.empty() && !names_one(question)) continue;
        found.push_back({team.side, unum, &sample, viewer::considered_actions(sample.plan)});
      }
    }
  }

  std::ranges::stable_sort(found, {}, [](const Decision& decision) {
    return std::pair(decision.sample->cycle, decision.sample->stopped);
  });
  return found;
}

// "371", or with a stopped clock "371+2"
std::string clock_text(const viewer::DecisionSample& sample) {
  return sample.stopped == 0 ? std::to_string(sample.cycle)
                             : fmt::format("{}+{}", sample.cycle, sample.stopped);
}

std::string player_text(const Decision& decision) {
  return fmt::format("{} {}", soccer::side_name(decision.side), decision.unum);
}

std::string value_text(const ConsideredAction& action) {
  return action.is_share ? fmt::format("{:.1f} %", action.value)
                         : base::decimal_text(action.value, 2);
}

std::string name_text(const Decision& decision, const ConsideredAction& action) {
  const bool passes = action.unum != 0 && action.unum != decision.unum;
  return passes ? fmt::format("{} to {}", action.name, action.unum) : action.name;
}

std::string place_text(const ConsideredAction& action) {
  return action.target ? fmt::format("{:.1f}, {:.1f}", action.target->x, action.target->y) : "";
}

std::string candidates_text(const Decision& decision) {
  Table table;
  table.add_columns({"", "considered", "target"});
  table.add_column(decision.considered.front().is_share ? "probability" : "value",
                   Table::Align::kRight);
  table.add_column("room", Table::Align::kRight);
  for (const ConsideredAction& action : decision.considered) {
    table.add_row({action.chosen ? "*" : "", name_text(decision, action), place_text(action),
                   value_text(action), action.room ? fmt::format("{:.1f} m", *action.room) : ""});
  }
  return table.format_text({2, stdout_width(), 2});
}

void print(const Decision& decision) {
  const viewer::DecisionSample& sample = *decision.sample;
  fmt::print("{}, cycle {}, decided by {}\n", player_text(decision), clock_text(sample),
             viewer::kDecisionMakerNames.name(sample.maker));
  const std::string sent =
      sample.commands.empty() ? std::string("nothing") : base::printable(sample.commands);
  fmt::print("  sent {}\n", base::wrap_text(sent, stdout_width(), 7));
  if (!decision.considered.empty()) fmt::print("{}", candidates_text(decision));
}

// A line for each decision: what was chosen, and what else was best.
std::string list_text(const std::vector<Decision>& decisions) {
  Table table;
  table.add_column("cycle", Table::Align::kRight);
  table.add_columns({"player", "chosen"});
  table.add_column("", Table::Align::kRight);
  table.add_column("best of the others");
  table.add_column("", Table::Align::kRight);

  for (const Decision& decision : decisions) {
    std::vector<std::string> row = {clock_text(*decision.sample), player_text(decision)};
    for (const bool chosen : {true, false}) {
      const ConsideredAction* best = nullptr;
      for (const ConsideredAction& action : decision.considered) {
        if (best == nullptr && action.chosen == chosen) best = &action;
      }
      row.push_back(best == nullptr ? "" : name_text(decision, *best));
      row.push_back(best == nullptr ? "" : value_text(*best));
    }
    table.add_row(std::move(row));
  }
  return table.format_text({0, stdout_width(), 2});
}

Json json_of(const ConsideredAction& action) {
  Json json = {{"chosen", action.chosen}, {"name", action.name}};
  json["unum"] = action.unum == 0 ? Json(nullptr) : Json(action.unum);
  json["target"] = action.target ? Json({action.target->x, action.target->y}) : Json(nullptr);
  json["probability"] = action.is_share ? Json(action.value / 100.0) : Json(nullptr);
  json["value"] = action.is_share ? Json(nullptr) : Json(action.value);
  json["room"] = action.room ? Json(*action.room) : Json(nullptr);
  return json;
}

Json json_of(const std::vector<Decision>& decisions) {
  Json list = Json::array();
  for (const Decision& decision : decisions) {
    const viewer::DecisionSample& sample = *decision.sample;
    Json considered = Json::array();
    for (const ConsideredAction& action : decision.considered)
      considered.push_back(json_of(action));
    list.push_back({{"cycle", sample.cycle},
                    {"stopped", sample.stopped},
                    {"side", soccer::side_name(decision.side)},
                    {"unum", decision.unum},
                    {"maker", viewer::kDecisionMakerNames.name(sample.maker)},
                    {"commands", sample.commands},
                    {"considered", std::move(considered)}});
  }
  return list;
}

std::string what_is_missing(const DecisionQuestion& question) {
  std::string text = "no decision";
  const std::string side = question.side.empty() ? "player" : question.side;
  if (question.unum) {
    text += fmt::format(" of {} {}", side, *question.unum);
  } else if (!question.side.empty()) {
    text += " of the " + side + " side";
  }
  if (question.cycle) text += fmt::format(" in cycle {}", *question.cycle);
  return text + (names_one(question) ? " is recorded" : " has something to choose from");
}

}  // namespace

int explain_decision(const DecisionQuestion& question, bool json) {
  std::vector<viewer::TeamDecisions> teams;
  TRY_STEP(read_teams(question, teams));

  const std::vector<Decision> found = find_decisions(question, teams);
  if (found.empty()) {
    return print_error(kNoInput, "{}: {}", question.folder, what_is_missing(question));
  }
  if (json) return print_json({{"schema", "cls.explain/1"}, {"decisions", json_of(found)}});

  if (!question.cycle) {
    fmt::print("{}", list_text(found));
    return kOk;
  }
  for (const Decision& decision : found) {
    if (&decision != &found.front()) fmt::print("\n");
    print(decision);
  }
  return kOk;
}

}  // namespace cls::cli

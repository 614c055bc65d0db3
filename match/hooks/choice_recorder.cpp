// Collects choices, and writes them as an array of NumPy.
#include "match/hooks/choice_recorder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <string_view>
#include <tuple>

#include "base/index.h"
#include "base/io/whole_file.h"
#include "match/hooks/played_option.h"
#include "proxy/agent/player_agent.h"
#include "training/features/feature_set.h"

namespace cls::match {
namespace {

/// What a policy would do there without being asked, such as a shot that nobody can hold.
constexpr int kNotAsked = -2;

bool is_recorded(const player::WorldModel& world) {
  return world.self.kickable && !world.goalie && world.game.mode == soccer::PlayMode::kPlayOn;
}

void append(const void* bytes, std::size_t size, std::string& out) {
  out.append(static_cast<const char*>(bytes), size);
}

/// The header of version 1.0 of the format: padded so that the array begins at a multiple of 64.
std::string npy_header(const std::string& type, std::size_t rows) {
  constexpr std::size_t kAlignment = 64;
  constexpr std::string_view kMagic("\x93NUMPY\x01\x00", 8);
  std::string text =
      fmt::format("{{'descr': [{}], 'fortran_order': False, 'shape': ({},), }}", type, rows);
  const std::size_t before = kMagic.size() + 2 + text.size() + 1;
  text.append((kAlignment - before % kAlignment) % kAlignment, ' ');
  text += '\n';

  std::string header(kMagic);
  header += static_cast<char>(text.size() & 0xff);
  header += static_cast<char>(text.size() >> 8);
  return header + text;
}

std::string npy_text(const std::vector<RecordedChoice>& choices, std::size_t features) {
  std::string bytes = npy_header(
      fmt::format("('cycle', '<i4'), ('unum', '<i4'), ('option', '<i4'), ('action', '|S{}'), "
                  "('legal', '|b1', ({},)), ('observed', '<f4', ({},))",
                  RecordedChoice{}.action.size(), player::kOptionCount, features),
      choices.size());
  for (const RecordedChoice& one : choices) {
    for (const std::int32_t number : {one.cycle, one.unum, one.option}) {
      append(&number, sizeof number, bytes);
    }
    append(one.action.data(), one.action.size(), bytes);
    append(one.legal.data(), one.legal.size(), bytes);
    append(one.observed.data(), one.observed.size() * sizeof(float), bytes);
  }
  return bytes;
}

}  // namespace

ChoicesOfSide::ChoicesOfSide(std::filesystem::path file)
    : file_(std::move(file)), features_(training::kTeamFeatures) {}

void ChoicesOfSide::before_decision(const proxy::PlayerAgent& agent) {
  heard_ = true;
  const player::WorldModel& world = agent.decision_world();
  if (!is_recorded(world)) return;
  find_options(world, agent.memory(), tables_.at(base::index(agent.unum() - 1)));
}

void ChoicesOfSide::on_decision(const proxy::Decision& decision) {
  const proxy::PlayerAgent& agent = decision.agent;
  const player::WorldModel& world = agent.decision_world();
  const player::DecidedBy by = agent.trace().by;
  const bool chosen = by == player::DecidedBy::kActions || by == player::DecidedBy::kOwnPlay;
  if (!is_recorded(world) || !chosen) return;

  const player::OptionTable& table = tables_.at(base::index(agent.unum() - 1));
  const bool asked = table.choice == player::OptionTable::Choice::kWithBall;
  if (!asked && by == player::DecidedBy::kOwnPlay) return;

  const PlayedOption played = played_option(decision, table);
  RecordedChoice& choice = choices_.emplace_back();
  choice.cycle = world.game.time.cycle;
  choice.unum = agent.unum();
  choice.option = asked ? played.id : kNotAsked;
  std::memcpy(choice.action.data(), played.action.data(),
              std::min(played.action.size(), choice.action.size()));
  std::ranges::copy(table.legal, choice.legal.begin());
  choice.observed = features_.of(world, table);
}

std::string ChoicesOfSide::close() {
  if (!heard_) return {};
  // Replies arrive in any order.
  std::ranges::stable_sort(choices_, {}, [](const RecordedChoice& choice) {
    return std::tuple(choice.cycle, choice.unum);
  });
  const auto written = base::write_file(file_, npy_text(choices_, features_.count()));
  return written ? std::string() : written.error().message;
}

ChoiceRecorder::ChoiceRecorder(const std::filesystem::path& folder)
    : SideHooks({ChoicesOfSide(folder / "left-choices.npy"),
                 ChoicesOfSide(folder / "right-choices.npy")}) {}

}  // namespace cls::match

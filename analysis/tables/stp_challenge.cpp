// Follows the scripts of 2025 (docs/data.md) where they decide what is a test and what is an error.
#include "analysis/tables/stp_challenge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <unordered_map>

#include "base/index.h"
#include "base/io/input_buffer.h"
#include "base/text/csv_line.h"
#include "base/text/number_text.h"
#include "soccer/pitch.h"
#include "soccer/side.h"

namespace cls::analysis {
namespace {

using base::Error;
using base::InputBuffer;
using base::Result;
using soccer::Vec2;

constexpr int kPlayFrames = 50;
constexpr std::size_t kMaxRows = 10'000;
constexpr std::size_t kLeftPlayers = soccer::kPlayersPerTeam;

// The cycle of a line of a log: digits at the start, or after the first space.
std::optional<int> cycle_of_log_line(std::string_view line, StpFile file) {
  if (file == StpFile::kGameLog) {
    const std::size_t space = line.find(' ');
    if (space == std::string_view::npos) return std::nullopt;
    line.remove_prefix(space + 1);
    return base::parse_int(line.substr(0, line.find(' ')));
  }
  return base::parse_int(line.substr(0, line.find(',')));
}

// Time2 of events, cycle of frames.
Result<std::optional<int>> cycle_of_row(std::string_view line, StpFile file) {
  const std::size_t column = file == StpFile::kTracking ? 1 : 9;
  std::vector<std::string_view> cells;
  base::split_csv_line(line, cells);
  const auto cycle = column < cells.size() ? base::parse_int(cells[column]) : std::nullopt;
  if (!cycle) return Error{fmt::format("column {} must be a cycle", column + 1)};
  return cycle;
}

Result<std::optional<int>> cycle_of_line(std::string_view line, StpFile file, bool is_first) {
  const bool is_table = file == StpFile::kTracking || file == StpFile::kEvents;
  if (!is_table) return cycle_of_log_line(line, file);
  if (is_first) return std::optional<int>();
  return cycle_of_row(line, file);
}

bool counts(std::size_t agent) { return agent < kLeftPlayers || agent == kStpBall; }

// Sums of distances.
struct Distances {
  double all = 0.0;
  double last = 0.0;
};

Distances distances_of(const StpPrediction& prediction,
                       const std::vector<std::array<Vec2, kStpAgents>>& truth) {
  Distances sums;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    for (std::size_t agent = 0; agent < kStpAgents; ++agent) {
      if (!counts(agent)) continue;
      const double distance = (prediction.places[i][agent] - truth[i][agent]).length();
      sums.all += distance;
      if (i + 1 == truth.size()) sums.last += distance;
    }
  }
  return sums;
}

// Players keep their velocity for some frames and follow the ball for a part of its way, across the
// pitch half of it; numbers that fit a few goals of real teams.
constexpr double kMovedFrames = 10.0;
constexpr Vec2 kFollowed{0.3, 0.15};

Vec2 place_after(StpModel model, const StpRow& last, std::size_t agent, int frames) {
  const Vec2 start = last.place[agent];
  if (model == StpModel::kVelocity) return start + last.motion[agent] * frames;
  const double part = static_cast<double>(frames) / kStpFrames;
  const Vec2 way = Vec2{soccer::kHalfLength, 0.0} - last.place[kStpBall];
  if (agent == kStpBall) return start + way * part;
  return start + last.motion[agent] * (kMovedFrames * part) +
         Vec2{way.x * kFollowed.x, way.y * kFollowed.y} * part;
}

}  // namespace

StpPrediction predict_stp(StpModel model, const StpRow& last) {
  StpPrediction prediction;
  for (int frames = 1; frames <= kStpFrames; ++frames) {
    prediction.numbers.push_back(last.number + frames);
    auto& places = prediction.places.emplace_back();
    for (std::size_t agent = 0; agent < kStpAgents; ++agent) {
      places[agent] = place_after(model, last, agent, frames);
    }
  }
  return prediction;
}

Result<std::optional<int>> stp_last_cycle(base::ByteSource& tracking) {
  std::optional<int> found;
  int played = 0;
  bool in_goal = false;
  TRY(read_stp_rows(tracking, StpColumns::kModeAndCycle, [&](const StpRow& row) {
    const bool goal = row.mode == "goal_l";
    if (goal && !in_goal && !found && played >= kPlayFrames) found = row.cycle - kStpFrames;
    in_goal = goal;
    played = row.mode == "play_on" ? std::min(played + 1, kPlayFrames) : 0;
  }));
  return found;
}

Result<void> cut_stp_file(base::ByteSource& from, StpFile file, int last_cycle,
                          base::ByteSink& to) {
  InputBuffer input(from);
  std::string_view line;
  for (bool is_first = true;; is_first = false) {
    const InputBuffer::Line kind = input.next_line(line);
    if (kind == InputBuffer::Line::kEnd) break;

    const auto place = [&] { return fmt::format("line {}: ", input.line_number()); };
    if (kind == InputBuffer::Line::kTooLong) return Error{place() + "is too long"};
    const auto cycle = cycle_of_line(line, file, is_first);
    if (!cycle) return Error{place() + cycle.error().message};
    if (*cycle && **cycle > last_cycle) return {};

    to.write(line);
    if (kind == InputBuffer::Line::kWhole) to.write("\n");
  }
  if (!from.error().empty()) return Error{from.error()};
  return {};
}

Result<StpPrediction> read_stp_prediction(base::ByteSource& table, StpColumns columns) {
  StpPrediction prediction;
  std::size_t rows = 0;
  TRY(read_stp_rows(table, columns, [&](const StpRow& row) {
    if (++rows > kMaxRows) return;
    prediction.numbers.push_back(row.number);
    prediction.places.push_back(row.place);
  }));
  if (rows > kMaxRows) return Error{fmt::format("has more than {} rows", kMaxRows)};
  return prediction;
}

Result<StpRow> read_last_stp_row(base::ByteSource& test, StpColumns columns) {
  std::optional<StpRow> last;
  TRY(read_stp_rows(test, columns, [&](const StpRow& row) { last = row; }));
  if (!last) return Error{"has no rows"};
  last->mode = {};
  return *last;
}

std::optional<std::string> check_stp_prediction(const StpPrediction& prediction,
                                                std::int64_t last) {
  for (std::int64_t number = last + 1; number <= last + kStpFrames; ++number) {
    const auto& numbers = prediction.numbers;
    if (std::ranges::find(numbers, number) != numbers.end()) continue;
    return fmt::format("has no row {}; it must have rows {} to {}", number, last + 1,
                       last + kStpFrames);
  }
  return std::nullopt;
}

Result<StpScore> score_stp_prediction(const StpPrediction& prediction, base::ByteSource& truth,
                                      std::int64_t last) {
  const std::vector<std::int64_t>& numbers = prediction.numbers;
  if (numbers.empty() || numbers.front() != last + 1) {
    return Error{fmt::format("must begin with row {}, behind the test", last + 1)};
  }

  std::unordered_map<std::int64_t, std::size_t> index;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!index.emplace(numbers[i], i).second) {
      return Error{fmt::format("has row {} twice", numbers[i])};
    }
  }

  std::vector<std::array<Vec2, kStpAgents>> places(numbers.size());
  std::vector<bool> known(numbers.size(), false);
  TRY(read_stp_rows(truth, StpColumns::kAllPlaces, [&](const StpRow& row) {
    const auto found = index.find(row.number);
    if (found == index.end()) return;
    places[found->second] = row.place;
    known[found->second] = true;
  }));

  const auto unknown = std::ranges::find(known, false);
  if (unknown != known.end()) {
    const std::size_t at = base::index(unknown - known.begin());
    return Error{fmt::format("the match has no row {}", numbers[at])};
  }

  const Distances sums = distances_of(prediction, places);
  constexpr auto kCounted = static_cast<double>(kLeftPlayers + 1);
  return StpScore{sums.all / (kCounted * static_cast<double>(places.size())), sums.last / kCounted};
}

std::string format_stp_prediction(const StpPrediction& prediction) {
  std::string table = "#";
  for (std::size_t agent = 0; agent < kStpAgents; ++agent) {
    const std::string name = stp_agent(agent);
    table += fmt::format(",{}_x,{}_y", name, name);
  }

  const auto append = [&table](double value) {
    table += ',';
    if (!std::isnan(value)) base::append_g(value, table);
  };

  for (std::size_t i = 0; i < prediction.numbers.size(); ++i) {
    table += '\n';
    base::append_int(prediction.numbers[i], table);
    for (const Vec2& place : prediction.places[i]) {
      append(place.x);
      append(place.y);
    }
  }
  return table + '\n';
}

}  // namespace cls::analysis

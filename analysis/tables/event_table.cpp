// Pairs each touch with the touch, the goal or the line that ended it.
#include "analysis/tables/log_tables.h"

#include <algorithm>
#include <bit>
#include <iterator>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "analysis/play/one_ball.h"
#include "base/io/arrow_file.h"
#include "base/text/number_text.h"
#include "soccer/play_mode.h"

namespace cls::analysis {
namespace {

using gamelog::MatchRecord;
using soccer::PlayMode;
using soccer::Side;

constexpr int kUnknownPlayer = -1;

// A side, and one of its players where only one was involved.
struct Actor {
  Side side = Side::kNeutral;
  int unum = kUnknownPlayer;

  friend bool operator==(const Actor&, const Actor&) = default;
};

struct Row {
  std::string_view type;
  Actor from;
  std::size_t from_frame = 0;
  soccer::Vec2 from_point{};
  Actor to{};
  std::size_t to_frame = 0;
  soccer::Vec2 to_point{};
  bool success = false;
};

std::uint32_t touchers_of(const Touch& touch, Side side) {
  constexpr std::uint32_t kLeftTeam = (1u << kTeamSize) - 1;
  return touch.touchers & (side == Side::kLeft ? kLeftTeam : ~kLeftTeam);
}

Actor actor_of(const Touch& touch, Side side) {
  const std::uint32_t touchers = touchers_of(touch, side);
  if (std::popcount(touchers) != 1) return {side, kUnknownPlayer};
  return {side, soccer::unum_of_slot(std::countr_zero(touchers))};
}

// Neutral if both teams touched the ball.
Actor actor_of(const Touch& touch) {
  const bool left = touchers_of(touch, Side::kLeft) != 0;
  const bool right = touchers_of(touch, Side::kRight) != 0;
  if (left && right) return {};
  return actor_of(touch, left ? Side::kLeft : Side::kRight);
}

bool is_out(PlayMode without_side) {
  return without_side == PlayMode::kKickInLeft || without_side == PlayMode::kCornerKickLeft ||
         without_side == PlayMode::kGoalKickLeft;
}

class EventRows {
 public:
  explicit EventRows(const Flow& flow) : flow_(flow), record_(*flow.record) {}

  std::vector<Row> collect() {
    std::size_t next = 0;
    for (std::size_t frame = 1; frame < record_.frames(); ++frame) {
      if (next < flow_.touches.size() && flow_.touches[next].frame == frame) {
        add_touch(flow_.touches[next++]);
      }
      if (record_.mode[frame] != record_.mode[frame - 1]) add_mode(frame);
    }

    std::ranges::stable_sort(rows_, {},
                             [&](const Row& row) { return record_.time[row.from_frame]; });
    return std::move(rows_);
  }

 private:
  // A touch happens between two frames: its time and mode are those of the first.
  static Row row_of(std::string_view type, const Touch& first, Actor actor) {
    return {
        .type = type, .from = actor, .from_frame = first.frame - 1, .from_point = first.contact};
  }

  void add_touch(const Touch& touch) {
    const Touch* before = last_;
    last_ = &touch;
    if (before == nullptr || touch.live_phase < 0 || before->live_phase != touch.live_phase) return;
    if (is_catch(*before) || is_catch(touch)) return;

    const Actor from = actor_of(*before);
    if (from.unum == kUnknownPlayer) return;
    const Actor to = actor_of(touch);

    const bool kicked = touch.kind == TouchKind::kKick;
    std::string_view type = "Pass";
    bool success = kicked && to.unum != kUnknownPlayer;
    if (to.side == Side::kNeutral) {
      type = "MultiTouch";
    } else if (to.side != from.side) {
      type = "Interception";
      success = true;
    } else if (at_one_ball(flow_, *before, touch)) {
      type = "BallTouch";
      success = false;
    } else if (to == from) {
      if (dashed(*before, touch)) {
        type = "Dribble";
      } else if (!kicked) {
        type = "BallTouch";
      } else {
        return;
      }
    }

    Row row = row_of(type, *before, from);
    row.to = to;
    row.to_frame = touch.frame - 1;
    row.to_point = touch.contact;
    row.success = success;
    rows_.push_back(row);
  }

  void add_mode(std::size_t frame) {
    const PlayMode mode = soccer::without_side(record_.mode[frame]);
    const Side side = soccer::side(record_.mode[frame]);
    if (last_ != nullptr && mode == PlayMode::kGoalLeft) {
      const Actor scorer = actor_of(*last_);
      add_end(scorer.side == side ? "Shoot" : "OwnGoal", scorer, frame, true);
    } else if (last_ != nullptr && is_out(mode)) {
      add_end("OutOfBounds", actor_of(*last_, opponent(side)), frame, false);
    }

    // Play stands: what follows is not the consequence of the last touch.
    if (!flow_.is_live(frame)) last_ = nullptr;
  }

  void add_end(std::string_view type, Actor actor, std::size_t frame, bool success) {
    Row row = row_of(type, *last_, actor);
    row.to_frame = frame;
    row.to_point = record_.ball_position[frame];
    row.success = success;
    rows_.push_back(row);
  }

  static bool is_catch(const Touch& touch) {
    return touch.kind == TouchKind::kCatch || touch.kind == TouchKind::kPunch;
  }

  bool dashed(const Touch& first, const Touch& second) const {
    const std::size_t slot = slot_index(first.slot);
    return has_executed(record_, gamelog::Counter::kDash, entry_of(first.frame, slot),
                        entry_of(second.frame, slot));
  }

  const Flow& flow_;
  const MatchRecord& record_;
  const Touch* last_ = nullptr;  // since play began
  std::vector<Row> rows_;
};

// A drop ball is no mode of the table.
std::string_view mode_name(PlayMode mode) {
  return soccer::name(mode == PlayMode::kDropBall ? PlayMode::kPlayOn : mode);
}

// A text or a number.
using Cell = std::variant<std::string_view, double>;

struct Column {
  const char* heading;
  base::ArrowType type;
  const char* unit;
  Cell (*value)(const Row& row, const MatchRecord& record);
};

#define CLS_CELL(...) \
  [](const Row& r, [[maybe_unused]] const MatchRecord& record) -> Cell { return __VA_ARGS__; }

constexpr Column kColumns[] = {
    {"Type", base::ArrowType::kText, "", CLS_CELL(r.type)},
    {"Side1", base::ArrowType::kText, "", CLS_CELL(soccer::side_name(r.from.side))},
    {"Unum1", base::ArrowType::kInt8, "", CLS_CELL(double(r.from.unum))},
    {"Time1", base::ArrowType::kInt32, "cycle", CLS_CELL(double(record.time[r.from_frame]))},
    {"Mode1", base::ArrowType::kText, "", CLS_CELL(mode_name(record.mode[r.from_frame]))},
    {"X1", base::ArrowType::kFloat32, "m", CLS_CELL(r.from_point.x)},
    {"Y1", base::ArrowType::kFloat32, "m", CLS_CELL(r.from_point.y)},
    {"Side2", base::ArrowType::kText, "", CLS_CELL(soccer::side_name(r.to.side))},
    {"Unum2", base::ArrowType::kInt8, "", CLS_CELL(double(r.to.unum))},
    {"Time2", base::ArrowType::kInt32, "cycle", CLS_CELL(double(record.time[r.to_frame]))},
    {"X2", base::ArrowType::kFloat32, "m", CLS_CELL(r.to_point.x)},
    {"Y2", base::ArrowType::kFloat32, "m", CLS_CELL(r.to_point.y)},
    {"Success", base::ArrowType::kBool, "", CLS_CELL(r.success ? 1.0 : 0.0)},
};

#undef CLS_CELL

void append_cell(const Cell& cell, base::ArrowType type, std::string& out) {
  if (const auto* text = std::get_if<std::string_view>(&cell)) {
    out += *text;
  } else if (const double number = std::get<double>(cell); type == base::ArrowType::kBool) {
    out += number != 0.0 ? "true" : "false";
  } else if (type == base::ArrowType::kFloat32) {
    base::append_g(number, out);
  } else {
    base::append_int(static_cast<std::int64_t>(number), out);
  }
}

}  // namespace

void write_events_arrow(const Flow& flow, base::ByteSink& sink) {
  std::vector<base::ArrowField> fields;
  for (const Column& column : kColumns)
    fields.push_back({column.heading, column.type, column.unit});

  base::ArrowWriter table(sink, std::move(fields), {{"schema", "cls.events/1"}});
  for (const Row& row : EventRows(flow).collect()) {
    for (const Column& column : kColumns) {
      std::visit([&](auto cell) { table.add(cell); }, column.value(row, *flow.record));
    }
  }
  table.close();
}

std::string event_table(const Flow& flow) {
  std::string table;
  const auto end_cell = [&table](const Column& column) {
    table += &column == &kColumns[std::size(kColumns) - 1] ? '\n' : ',';
  };

  for (const Column& column : kColumns) {
    table += column.heading;
    end_cell(column);
  }
  for (const Row& row : EventRows(flow).collect()) {
    for (const Column& column : kColumns) {
      append_cell(column.value(row, *flow.record), column.type, table);
      end_cell(column);
    }
  }
  return table;
}

}  // namespace cls::analysis

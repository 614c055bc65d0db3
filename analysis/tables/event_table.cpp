// Pairs each touch with the touch, the goal or the line that ended it.
#include "analysis/tables/event_table.h"

#include <algorithm>
#include <bit>
#include <string_view>
#include <vector>

#include "analysis/tables/arrow_tables.h"
#include "base/io/arrow_file.h"
#include "base/text/number_text.h"
#include "soccer/play_mode.h"
#include "soccer/side.h"

namespace cls::analysis {
namespace {

using gamelog::MatchRecord;
using soccer::PlayMode;
using soccer::Side;

constexpr const char* kHeading =
    "Type,Side1,Unum1,Time1,Mode1,X1,Y1,Side2,Unum2,Time2,X2,Y2,Success\n";
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
  soccer::Vec2 from_point;
  Actor to;
  std::size_t to_frame = 0;
  soccer::Vec2 to_point;
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

bool is_out(PlayMode mode) {
  const PlayMode left = soccer::without_side(mode);
  return left == PlayMode::kKickInLeft || left == PlayMode::kCornerKickLeft ||
         left == PlayMode::kGoalKickLeft;
}

bool is_goal(PlayMode mode) { return soccer::without_side(mode) == PlayMode::kGoalLeft; }

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
    std::stable_sort(rows_.begin(), rows_.end(), [this](const Row& a, const Row& b) {
      return record_.time[a.from_frame] < record_.time[b.from_frame];
    });
    return std::move(rows_);
  }

 private:
  // A touch happens between two frames: its time and mode are those of the first.
  Row row_of(std::string_view type, const Touch& first, Actor actor) const {
    Row row;
    row.type = type;
    row.from = actor;
    row.from_frame = first.frame - 1;
    row.from_point = first.contact;
    return row;
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
    } else if (to == from) {
      if (dashed(*before, touch)) {
        type = "Dribble";
      } else if (!kicked) {
        type = "BallTouch";
      } else {
        return;
      }
    }
    add_pair(row_of(type, *before, from), to, touch, success);
  }

  void add_pair(Row row, Actor to, const Touch& touch, bool success) {
    row.to = to;
    row.to_frame = touch.frame - 1;
    row.to_point = touch.contact;
    row.success = success;
    rows_.push_back(row);
  }

  void add_mode(std::size_t frame) {
    const PlayMode mode = record_.mode[frame];
    if (last_ != nullptr && is_goal(mode)) {
      const Actor scorer = actor_of(*last_);
      add_end(scorer.side == side(mode) ? "Shoot" : "OwnGoal", scorer, frame, true);
    } else if (last_ != nullptr && is_out(mode)) {
      add_end("OutOfBounds", actor_of(*last_, opponent(side(mode))), frame, false);
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
    constexpr auto kDash = static_cast<std::size_t>(gamelog::Counter::kDash);
    const std::size_t slot = slot_index(first.slot);
    const auto& counters = record_.players.counters;
    return counters[entry_of(second.frame, slot)][kDash] >
           counters[entry_of(first.frame, slot)][kDash];
  }

  const Flow& flow_;
  const MatchRecord& record_;
  const Touch* last_ = nullptr;  // since play began
  std::vector<Row> rows_;
};

void append_actor(const Actor& actor, std::string& out) {
  out += ',';
  out += soccer::side_name(actor.side);
  out += ',';
  base::append_int(actor.unum, out);
}

void append_point(soccer::Vec2 point, std::string& out) {
  for (const double value : {point.x, point.y}) {
    out += ',';
    base::append_g(value, out);
  }
}

// A drop ball is no mode of the table.
std::string_view mode_name(const Row& row, const MatchRecord& record) {
  const PlayMode mode = record.mode[row.from_frame];
  return soccer::name(mode == PlayMode::kDropBall ? PlayMode::kPlayOn : mode);
}

void append_row(const Row& row, const MatchRecord& record, std::string& out) {
  out += row.type;
  append_actor(row.from, out);
  out += ',';
  base::append_int(record.time[row.from_frame], out);
  out += ',';
  out += mode_name(row, record);
  append_point(row.from_point, out);
  append_actor(row.to, out);
  out += ',';
  base::append_int(record.time[row.to_frame], out);
  append_point(row.to_point, out);
  out += row.success ? ",true\n" : ",false\n";
}

std::vector<base::ArrowField> event_fields() {
  using base::ArrowType;
  return {{"Type", ArrowType::kText},       {"Side1", ArrowType::kText},
          {"Unum1", ArrowType::kInt8},      {"Time1", ArrowType::kInt32, "cycle"},
          {"Mode1", ArrowType::kText},      {"X1", ArrowType::kFloat32, "m"},
          {"Y1", ArrowType::kFloat32, "m"}, {"Side2", ArrowType::kText},
          {"Unum2", ArrowType::kInt8},      {"Time2", ArrowType::kInt32, "cycle"},
          {"X2", ArrowType::kFloat32, "m"}, {"Y2", ArrowType::kFloat32, "m"},
          {"Success", ArrowType::kBool}};
}

void add_row(const Row& row, const MatchRecord& record, base::ArrowWriter& table) {
  table.add(row.type);
  table.add(std::string_view(soccer::side_name(row.from.side)));
  table.add(row.from.unum);
  table.add(record.time[row.from_frame]);
  table.add(mode_name(row, record));
  table.add(row.from_point.x);
  table.add(row.from_point.y);
  table.add(std::string_view(soccer::side_name(row.to.side)));
  table.add(row.to.unum);
  table.add(record.time[row.to_frame]);
  table.add(row.to_point.x);
  table.add(row.to_point.y);
  table.add(row.success ? 1.0 : 0.0);
}

}  // namespace

void write_events_arrow(const Flow& flow, base::ByteSink& sink) {
  base::ArrowWriter table(sink, event_fields(), {{"schema", "cls.events/1"}});
  for (const Row& row : EventRows(flow).collect()) add_row(row, *flow.record, table);
  table.close();
}

std::string event_table(const Flow& flow) {
  std::string table = kHeading;
  for (const Row& row : EventRows(flow).collect()) append_row(row, *flow.record, table);
  return table;
}

}  // namespace cls::analysis

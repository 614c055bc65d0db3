// A whole match in memory: one array per property, by frame and player slot.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "gamelog/record/frame.h"
#include "gamelog/record/parse_errors.h"
#include "gamelog/record/rcg_version.h"
#include "soccer/geometry.h"
#include "soccer/parameters/player_params.h"
#include "soccer/parameters/player_type.h"
#include "soccer/parameters/server_params.h"
#include "soccer/play_mode.h"
#include "soccer/side.h"

namespace cls::gamelog {

/// Leaves new elements uninitialized, because columns are written right after they grow.
template <typename T>
struct UninitializedAllocator : std::allocator<T> {
  template <typename U>
  struct rebind {
    using other = UninitializedAllocator<U>;
  };
  UninitializedAllocator() = default;
  template <typename U>
  UninitializedAllocator(const UninitializedAllocator<U>&) {}

  template <typename U>
  void construct(U* at) {
    ::new (static_cast<void*>(at)) U;
  }
  template <typename U, typename... Arguments>
  void construct(U* at, Arguments&&... arguments) {
    ::new (static_cast<void*>(at)) U(std::forward<Arguments>(arguments)...);
  }
};

template <typename T>
using Column = std::vector<T, UninitializedAllocator<T>>;

/// A point or vector in single precision, which holds the six significant digits of logs without
/// loss.
struct Point {
  float x;
  float y;

  operator soccer::Vec2() const { return {x, y}; }
};

/// Command counters of a player, in the order of text logs.
enum class Counter : std::uint8_t {
  kKick,
  kDash,
  kTurn,
  kCatch,
  kMove,
  kTurnNeck,
  kChangeView,
  kSay,
  kTackle,
  kPointto,
  kAttentionto,
  kChangeFocus,
};
constexpr std::size_t kCounterCount = 12;
using Counters = std::array<std::int32_t, kCounterCount>;

/// Name of the counted command: "kick", "dash", "turn", "catch", "move", "turn_neck", ...
std::string_view name(Counter counter);

/// Twenty-two entries per frame, at `frame * 22 + slot` (soccer/side.h). Meters, degrees.
struct PlayerColumns {
  Column<std::uint32_t> state;  ///< bits kState... of frame.h
  Column<std::int16_t> type;
  Column<Point> position;
  Column<Point> velocity;
  Column<float> body;
  Column<float> neck;         ///< relative to body
  Column<Point> pointing_at;  ///< x is NaN while the arm is down
  Column<float> view_width;
  Column<std::uint8_t> high_quality;
  Column<Point> focus;  ///< x distance, y direction; 0 before version 6 and in JSON
  Column<float> stamina;
  Column<float> effort;
  Column<float> recovery;
  Column<float> capacity;         ///< -1: unlimited, or not in the log (before version 5)
  Column<std::int8_t> attention;  ///< slot; -1: none
  Column<Counters> counters;      ///< since the server started
};

/// A text message in a log: referee, say, result, team graphic (board 1) or commands (board 2).
struct Message {
  int board = 1;
  std::string text;

  friend bool operator==(const Message&, const Message&) = default;
};

/// A line of unknown kind, stored as text so that conversion does not lose it.
struct UnknownLine {
  std::string text;
};

/// A record between two frames of a log.
struct Note {
  std::uint32_t frame = 0;  ///< number of frames before it
  std::int32_t time = 0;
  std::int32_t stopped = 0;  ///< as Frame::stopped
  std::variant<soccer::PlayMode, TeamFrames, Message, UnknownLine> content;
};

/// Contents of a game log. Frames are in the order of the log.
struct MatchRecord {
  RcgVersion version = RcgVersion::kV6;
  std::string server_version;  ///< in JSON logs only
  std::string timestamp;       ///< in JSON logs only

  /// Parameters that the log lacks have their defaults (versions 1 and 2 have none).
  soccer::ServerParams server;
  soccer::PlayerParams player;
  std::vector<soccer::PlayerType> types;
  /// The parameters as lines of a text log, in the order of the log; empty for versions without
  /// them.
  std::vector<std::string> parameter_lines;
  /// True for a log of the 2.5D server.
  bool has_ball_height = false;

  // One entry per frame.
  Column<std::int32_t> time;
  Column<std::int32_t> stopped;  ///< cycles that the clock has been stopped at this time, from 0
  Column<soccer::PlayMode> mode;
  Column<std::uint32_t> team_state;  ///< index into `teams`
  Column<Point> ball_position;
  Column<Point> ball_velocity;  ///< zero in versions 1 and 2
  Column<float> ball_height;    ///< meters; zero without has_ball_height

  PlayerColumns players;

  /// Each change of names and scores, in order. The first, without names and with 0:0, may be
  /// unused.
  std::vector<TeamFrames> teams = {TeamFrames{}};
  std::vector<Note> notes;

  /// Empty if the log is complete. Records before and after corrupt lines are read.
  ParseErrors errors;

  std::size_t frames() const { return time.size(); }
  const TeamFrames& final_teams() const { return teams.back(); }
};

constexpr std::size_t kSlots = soccer::kPlayersOnPitch;

/// Reserves memory for `frames` frames in total.
void reserve_frames(MatchRecord& record, std::size_t frames);

/// Appends uninitialized frames, or removes the last ones.
void resize_frames(MatchRecord& record, std::size_t frames);

/// A copy of one frame.
Frame frame_at(const MatchRecord& record, std::size_t frame);

/// Names and scores in a frame.
inline const TeamFrames& teams_at(const MatchRecord& record, std::size_t frame) {
  return record.teams[record.team_state[frame]];
}

/// Goals of the left team minus those of the right one, in a frame.
inline int lead_at(const MatchRecord& record, std::size_t frame) {
  const auto& [left, right] = teams_at(record, frame);
  return left.score - right.score;
}

inline bool is_enabled(const MatchRecord& record, std::size_t entry) {
  return (record.players.state[entry] & kStateEnabled) != 0;
}

}  // namespace cls::gamelog

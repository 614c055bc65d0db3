// Events of a step, in order, for messages, logs and sessions.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "base/text/number_text.h"
#include "simulator/world/world.h"

namespace cls::simulator {

/// A referee message to all clients: the name of a play mode (never goal_l or goal_r) or a call
/// such as goal_l_1 (docs/spec/simulation-model.md 9.18). All clients hear it immediately.
struct RefereeMessage {
  std::string_view name;        ///< static storage: a literal or the name of a play mode
  Side side = Side::kNeutral;   ///< appended as a letter unless neutral: penalty_foul_l
  std::optional<int> number{};  ///< appended last: goal_l_1, yellow_card_r_7

  void append_to(std::string& out) const {
    out += name;
    if (side != Side::kNeutral) (out += '_') += letter(side);
    if (number) base::append_int(*number, out += '_');
  }
  std::string text() const {
    std::string result;
    append_to(result);
    return result;
  }
};

/// Precedes the RefereeMessage with the name of the mode.
struct ModeChanged {
  PlayMode mode = PlayMode::kNull;
};

/// A player's say command; `position` is the speaker's at that time.
struct PlayerSaid {
  Slot speaker = kNoPlayer;
  Vec2 position;
  std::string text;
};

/// The player received this type: from a coach, or automatically at the first kick-off.
struct TypeChanged {
  Side side = Side::kLeft;
  int unum = 0;
  int type = 0;
};

/// A coach appointed this player goalie.
struct GoalieAppointed {
  Side side = Side::kLeft;
  int unum = 0;
};

/// The player was sent off; the server closes its connection.
struct SentOff {
  Slot slot = kNoPlayer;
};

struct Event {
  Clock clock;  ///< time of the event; the clock may advance later in the same step
  std::variant<RefereeMessage, ModeChanged, PlayerSaid, TypeChanged, GoalieAppointed, SentOff> what;
};

/// The simulator appends; the caller reads and clears.
using Events = std::vector<Event>;

/// Appends an event at the current clock.
template <typename What>
void report(Events& events, const World& world, What what) {
  Event& event = events.emplace_back();
  event.clock = world.clock;
  event.what = std::move(what);
}

}  // namespace cls::simulator

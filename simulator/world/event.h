// What happened in the world that others must be told, in order.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "simulator/world/world.h"

namespace cls::simulator {

/// The referee says something: a mode string (never goal_l or goal_r) or a word such as goal_l_1
/// (9.18). Everybody hears it at once.
struct RefereeSaid {
  std::string_view word;        ///< a literal or the name of a mode: it is never freed
  Side side = Side::kNeutral;   ///< follows as a letter, unless neutral: penalty_foul_l
  std::optional<int> number{};  ///< follows that: goal_l_1, yellow_card_r_7

  void append_to(std::string& out) const;
  std::string text() const;
};

/// Comes before the RefereeSaid with the mode's name.
struct ModeChanged {
  PlayMode mode = PlayMode::kNull;
};

/// A player's say command; `position` is where the speaker stood.
struct PlayerSaid {
  Slot speaker = kNobody;
  Vec2 position;
  std::string text;
};

/// The player has got this type: by a coach, or by itself at the first kick-off.
struct TypeChanged {
  Side side = Side::kLeft;
  int unum = 0;
  int type = 0;
};

/// A coach made this player the goalie.
struct GoalieAppointed {
  Side side = Side::kLeft;
  int unum = 0;
};

/// The player was sent off; its connection ends.
struct SentOff {
  Slot slot = kNobody;
};

struct Event {
  Clock clock;  ///< when it happened; the clock of the step may have moved on since
  std::variant<RefereeSaid, ModeChanged, PlayerSaid, TypeChanged, GoalieAppointed, SentOff> what;
};

/// The simulator appends; whoever drives it reads and clears.
using Events = std::vector<Event>;

/// Appends what has just happened.
template <typename What>
void report(Events& events, const World& world, What what) {
  Event& event = events.emplace_back();
  event.clock = world.clock;
  event.what = std::move(what);
}

}  // namespace cls::simulator

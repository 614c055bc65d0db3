// see_global and the reply to look: the noise-free view of coaches and trainers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "soccer/geometry.h"
#include "soccer/messages/see.h"
#include "soccer/protocol/team_name.h"
#include "soccer/protocol/view_mode.h"

namespace cls::soccer {

/// Global coordinates, whole degrees.
struct GlobalViewPlayer {
  TeamName team;
  int unum = 0;
  bool goalie = false;
  Vec2 position;
  Vec2 velocity;
  int body = 0;
  int neck = 0;  ///< relative to body
  bool pointing = false;
  int point_direction = 0;  ///< global
  ActionMark mark = ActionMark::kNone;
  Card card = Card::kNone;
};

struct GlobalView {
  bool is_look_reply = false;  ///< `(ok look T ...)` instead of `(see_global T ...)`
  int time = 0;
  Vec2 ball_position;
  Vec2 ball_velocity;
  std::vector<GlobalViewPlayer> players;  ///< enabled players, left team first
};

/// Parses either form (version 7 and later). Errors name the byte.
base::Result<void> parse(std::string_view message, GlobalView& out);

/// Appends the message. Look replies of rcssserver have no cards and no mark but "tackling"; the
/// caller omits the others.
void format(const GlobalView& view, std::string& out);

}  // namespace cls::soccer

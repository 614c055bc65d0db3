// What the programs of a side may ask of a soccer server that accepts any client.
#pragma once

#include <mutex>
#include <optional>
#include <string_view>

#include "soccer/per_side.h"
#include "soccer/protocol/reply_code.h"
#include "soccer/protocol/team_name.h"

namespace cls::match {

/// The names of the two teams on a server: a side has the first one that it plays under, and no
/// other. Used by any thread.
class ClaimedNames {
 public:
  /// True if `name` is that of `side`, or becomes it; false if the side has another one, or the
  /// opponent has it.
  bool claim(soccer::Side side, std::string_view name);
  /// True if `side` has this name already.
  bool has(soccer::Side side, std::string_view name) const;
  /// True if `side` has asked for the name of its opponent.
  bool collided(soccer::Side side) const;

 private:
  mutable std::mutex mutex_;
  soccer::PerSide<soccer::TeamName> names_;
  soccer::PerSide<bool> collided_;
};

/// The ports of a server that a side can reach.
enum class RelayedPort { kPlayers, kCoaches };

/// Why a request does not reach the server, with its reply instead.
struct Refusal {
  soccer::ErrorCode reply;
  bool intrusion = false;   ///< it asks for what others have
  bool connection = false;  ///< it may ask for a connection
};

/// Nothing for a request of a program of `side` to play for it, or to coach it, under its own name.
/// All others are refused: of monitors, of other teams, and whatever is not such a request.
std::optional<Refusal> refusal_of(RelayedPort port, std::string_view request, soccer::Side side,
                                  ClaimedNames& names);

/// Whether the server takes commands of the client only at the port that it opens for it. `request`
/// is one that passes; of a player who comes back it is not known.
bool gets_own_port(RelayedPort port, std::string_view request);

}  // namespace cls::match

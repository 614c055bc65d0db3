// The clients that the soccer server of a match accepts.
#pragma once

#include <string>

#include "soccer/per_side.h"

namespace cls::match {

/// In a match, a client belongs to the side whose program has opened its socket.
struct BoundSides {
  soccer::PerSide<bool> external;  ///< played by programs of its own; otherwise by agents of cls
  bool trainer = false;            ///< agents of cls play the trainer: there is no other
  /// The name of a side whose programs are of several teams, each with a name of its own; empty:
  /// its first client names it.
  soccer::PerSide<std::string> names = {};
  /// Descriptors of the doors to networks that sides have for themselves (process::NetworkDoor); 0:
  /// the side plays in the network of the server.
  soccer::PerSide<int> doors = {};
};

}  // namespace cls::match

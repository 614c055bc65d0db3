// Whose clients a soccer server accepts that a match has started.
#pragma once

#include "soccer/per_side.h"

namespace cls::orchestration::match {

/// In a match, a client belongs to the side whose program has opened its socket.
struct BoundSides {
  soccer::PerSide<bool> external;  ///< played by programs of its own; otherwise by agents of cls
  bool trainer = false;            ///< agents of cls play the trainer: there is no other
};

}  // namespace cls::orchestration::match

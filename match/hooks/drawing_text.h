// Texts and shapes that a Playmaker shows, a line each, for the decision debugger.
#pragma once

#include <string>

#include "proto/playmaker.pb.h"

namespace cls::match {

/// The `log` and `debug_client` actions of a reply in the lines of a debug log (docs/actions.md),
/// without the time and with numbers of two decimals: "1024 c 12.3 -4 2 red". Empty: none. What
/// does not fit into a recorded text is left out.
std::string drawings_text(const protos::PlayerActions& reply);

/// True for an action that shows something and does nothing else.
bool is_drawing(const protos::PlayerAction& action);

}  // namespace cls::match

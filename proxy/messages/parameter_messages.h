// Fills the handshake messages with server parameters, player parameters and player types.
#pragma once

#include <string_view>

#include "proto/playmaker.pb.h"
#include "soccer/parameters/player_params.h"
#include "soccer/parameters/player_type.h"
#include "soccer/parameters/server_params.h"

namespace cls::proxy {

// Values come from the parameter tables of soccer/, by name, plus pitch sizes and derived values.
// All functions replace the content of `out` except register_response. Texts (paths, file names,
// commands) stay unset, as in upstream's messages.

void fill(const soccer::ServerParams& params, protos::ServerParam& out);
void fill(const soccer::PlayerParams& params, protos::PlayerParam& out);
/// `server` provides the default catch area and the dash limits.
void fill(const soccer::PlayerType& type, const soccer::ServerParams& server,
          protos::PlayerType& out);

/// The server parameter that a field of ServerParam or PlayerParam has: mostly of the same name.
std::string_view server_parameter_of(std::string_view field);

}  // namespace cls::proxy

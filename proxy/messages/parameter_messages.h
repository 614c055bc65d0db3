// What a Playmaker is told about the match before it begins: parameters and player types.
#pragma once

#include "proto/playmaker.pb.h"
#include "soccer/parameters/player_params.h"
#include "soccer/parameters/player_type.h"
#include "soccer/parameters/server_params.h"

namespace cls::proxy {

// Values come from the parameter tables of soccer/, by name; to them come the sizes of the pitch
// and what follows from the parameters. All replace what was in `out` except register_response.
// Texts (paths, file names, commands) stay unset, as in upstream's messages.

void fill(const soccer::ServerParams& params, protos::ServerParam& out);
void fill(const soccer::PlayerParams& params, protos::PlayerParam& out);
/// `server` says how far a goalie of default build reaches and how strong a dash may be.
void fill(const soccer::PlayerType& type, const soccer::ServerParams& server,
          protos::PlayerType& out);

}  // namespace cls::proxy

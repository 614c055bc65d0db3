// Match parameters before a server has announced any.
#include "proxy/world/match_parameters.h"

namespace cls::proxy {

MatchParameters::MatchParameters()
    : types{soccer::default_player_type(server)},
      landmark_distances(server.quantize_step_l),
      object_distances(server.quantize_step) {}

}  // namespace cls::proxy

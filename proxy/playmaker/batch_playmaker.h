// One call per team and cycle: the TeamPlaymaker service behind the interface of single calls.
#pragma once

#include <memory>

#include "proxy/playmaker/batch_mode.h"
#include "proxy/playmaker/playmaker.h"

namespace cls::proxy {

/// Collects the calls of a cycle, sends them as one and hands out the replies by agent. Users see
/// the calls of Game: a handshake, a decision and a goodbye for each agent. A Playmaker without
/// the service gets those calls from then on. `inner` makes the calls; its agent 0 is the team.
/// With kOff, returns `inner`.
std::unique_ptr<Playmaker> make_batch_playmaker(std::unique_ptr<Playmaker> inner, BatchMode mode);

}  // namespace cls::proxy

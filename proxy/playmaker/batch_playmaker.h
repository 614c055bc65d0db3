// One call per team and cycle: the TeamPlaymaker service behind the interface of single calls.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

#include "proxy/playmaker/playmaker.h"

namespace cls::proxy {

/// Whether a team asks with the calls of TeamPlaymaker (docs/wire.md).
enum class BatchMode : std::uint8_t {
  kAuto,      ///< when the Playmaker implements them
  kOff,       ///< always the calls of Game
  kRequired,  ///< a Playmaker without them is refused
};

/// "auto", "never" or "always".
std::string_view name(BatchMode mode);
std::optional<BatchMode> parse_batch_mode(std::string_view text);

/// Collects the calls of a cycle, sends them as one and hands out the replies by agent. Users see
/// the calls of Game: a handshake, a decision and a goodbye for each agent. A Playmaker without
/// the service gets those calls from then on. `inner` makes the calls; its agent 0 is the team.
/// With kOff, returns `inner`.
std::unique_ptr<Playmaker> make_batch_playmaker(std::unique_ptr<Playmaker> inner, BatchMode mode);

}  // namespace cls::proxy

// One team whose agents are decided for by several Playmakers.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "proxy/playmaker/playmaker.h"

namespace cls::proxy {

/// Index of the Playmaker of each agent, by agent number.
using PartOfAgent = std::array<std::size_t, kAgentNumbers>;

/// Sends the calls of each agent to its part. The parts, which are not mixed ones, see a team of
/// their agents only.
std::unique_ptr<Playmaker> make_mixed_playmaker(std::vector<std::unique_ptr<Playmaker>> parts,
                                                const PartOfAgent& part_of);

}  // namespace cls::proxy

// A connection inside one process: what one end sends the other receives, in order.
#pragma once

#include <memory>
#include <utility>

#include "soccer/channel.h"

namespace cls::soccer {

/// Two connected ends. They share their queues without a lock: in lockstep, server and agent take
/// turns, and whoever moves an end to another thread orders the turns. Memory of messages is
/// reused, so a steady exchange does not allocate.
std::pair<std::unique_ptr<Channel>, std::unique_ptr<Channel>> make_memory_channel();

}  // namespace cls::soccer

// A connection within one process, first in, first out.
#pragma once

#include <memory>
#include <utility>

#include "soccer/channel.h"

namespace cls::soccer {

/// Two connected ends. Their queues have no lock: in lockstep, server and agent take turns; callers
/// that move an end to another thread must synchronize. Message memory is reused, so a steady
/// exchange does not allocate.
std::pair<std::unique_ptr<Channel>, std::unique_ptr<Channel>> make_memory_channel();

}  // namespace cls::soccer

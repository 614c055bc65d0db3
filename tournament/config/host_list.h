// The key hosts: where the executor "hosts" plays.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"

namespace cls::tournament {

struct HostSlots {
  std::string name;  ///< as the remote shell takes it: "node1", "ada@node1"
  int slots = 1;     ///< parallel matches
};

/// Parses "node1" and "4/node2", as GNU parallel writes them. The error quotes the wrong one.
base::Result<std::vector<HostSlots>> parse_hosts(const std::vector<std::string>& texts);

}  // namespace cls::tournament

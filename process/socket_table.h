// Sockets of this host and of its processes, as /proc shows them.
#pragma once

#include <sys/types.h>

#include <set>
#include <string>
#include <vector>

namespace cls::process {

enum class Protocol { kTcp, kUdp };

/// A bound socket; addresses as the kernel writes them.
struct SocketEntry {
  std::string host;
  int port = 0;
  std::string peer_host;
  int peer_port = 0;     ///< 0: not connected
  bool listens = false;  ///< TCP
  uid_t user = 0;
  unsigned long inode = 0;
};

/// All sockets of a protocol in the network of a process; 0: of this one.
std::vector<SocketEntry> bound_sockets(Protocol protocol, int pid = 0);

/// The inodes of a process's open sockets; empty without permission.
std::set<unsigned long> sockets_of(int pid);

}  // namespace cls::process

// The program that a UDP socket of this host belongs to, by what the kernel says.
#pragma once

#include <sys/types.h>

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/system/socket_address.h"

namespace cls::process {

/// Begins the short name (/proc/PID/comm) of a keeper; the name of its program follows, up to 15
/// characters in all. No other process can change it.
inline constexpr std::string_view kKeeperMark = "of ";
/// The short name of a guard.
inline constexpr std::string_view kGuardMark = "match-guard of";

struct SocketOwner {
  enum class Kind {
    kProgram,  ///< a program below a keeper of the guard
    kStarter,  ///< the process that started the guard
    kOutside,  ///< any other process
    kUnknown,  ///< cannot be seen: a process can hide its descriptors from its user
  };

  Kind kind = Kind::kUnknown;
  std::string program;  ///< kProgram: the beginning of its name (CommandPlan::name)
  pid_t pid = 0;        ///< 0: unknown
  std::string command;  ///< of that process, as ps shows it; the process can choose it
};

/// Finds owners among the programs of one guard: the kernel knows which processes hold a socket,
/// and keepers adopt all orphans, so that a process cannot leave the tree of its program.
class SocketOwners {
 public:
  /// Among the programs that this process starts. Its guard must be active.
  static SocketOwners of_own_programs();
  /// Among the programs that the same guard starts next to this one; none if a guard did not
  /// start this process.
  static std::optional<SocketOwners> of_programs_beside();

  /// The owner of the socket that sends from `address`. Where several processes share the socket or
  /// the address, they must be of one program; otherwise it is unknown.
  SocketOwner owner_of(const base::SocketAddress& address);

  /// The owners of the peers of all connected UDP sockets that `server`, or a process below it, has
  /// on loopback.
  std::vector<SocketOwner> peers_of(pid_t server);

 private:
  SocketOwners(pid_t guard, pid_t starter) : guard_(guard), starter_(starter) {}

  struct Family;
  Family family() const;
  SocketOwner find(const std::vector<unsigned long>& inodes, const Family& family) const;
  SocketOwner find_outside(unsigned long inode) const;
  void remember(unsigned long inode, const SocketOwner& owner);

  pid_t guard_;
  pid_t starter_;
  std::map<unsigned long, SocketOwner> known_;  ///< by inode of the socket
};

}  // namespace cls::process

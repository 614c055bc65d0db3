// Reads /proc/net/udp, the descriptors of processes, and their parents.
#include "process/socket_owner.h"

#include <fmt/format.h>
#include <netinet/in.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <set>

#include "base/system/udp_socket.h"
#include "process/guard.h"
#include "process/process_tree.h"
#include "process/socket_table.h"
#include "process/socket_visibility.h"

namespace cls::process {
namespace {

// Limits the memory; a match has less than a hundred sockets.
constexpr std::size_t kMaxKnown = 4096;

constexpr std::string_view kAnyV4 = "00000000";
constexpr std::string_view kMappedV4 = "0000000000000000FFFF0000";

std::string hex_host(const base::SocketAddress& address) {
  std::array<std::uint32_t, 4> parts{};
  if (address.family() == AF_INET6) {
    const auto& v6 = reinterpret_cast<const sockaddr_in6&>(address.bytes);
    std::memcpy(parts.data(), &v6.sin6_addr, sizeof parts);
    return fmt::format("{:08X}{:08X}{:08X}{:08X}", parts[0], parts[1], parts[2], parts[3]);
  }
  const auto& v4 = reinterpret_cast<const sockaddr_in&>(address.bytes);
  std::memcpy(parts.data(), &v4.sin_addr, sizeof parts[0]);
  return fmt::format("{:08X}", parts[0]);
}

// Whether a socket bound to `bound` can send from `host`: a program may choose the address of each
// datagram among those of this host (IP_PKTINFO), and use IPv6 sockets for IPv4.
bool can_send_from(std::string_view bound, std::string_view host) {
  if (bound.size() == host.size()) return true;
  if (bound.size() < host.size()) return false;
  const bool any = bound.find_first_not_of('0') == std::string_view::npos;
  return any || bound.starts_with(kMappedV4);
}

std::vector<SocketEntry> sockets_at(const std::vector<SocketEntry>& sockets, std::string_view host,
                                    int port) {
  std::vector<SocketEntry> found;
  std::ranges::copy_if(sockets, std::back_inserter(found), [&](const SocketEntry& socket) {
    return socket.port == port && can_send_from(socket.host, host);
  });
  return found;
}

std::vector<unsigned long> inodes_of(const std::vector<SocketEntry>& sockets) {
  std::vector<unsigned long> inodes;
  for (const SocketEntry& socket : sockets) inodes.push_back(socket.inode);
  return inodes;
}

bool on_loopback(std::string_view host) {
  return host.ends_with("7F") && (host.size() == kAnyV4.size() || host.starts_with(kMappedV4));
}

pid_t parent_of(pid_t pid) {
  const auto process = read_process(pid);
  return process ? process->parent : 0;
}

}  // namespace

/// The starter and all that it has started. Reading it takes milliseconds: once for all sockets
/// that are looked for.
struct SocketOwners::Family {
  // The keeper above a process, the starter, or the process itself if its parent is not known.
  pid_t top_of(pid_t pid, pid_t guard) const {
    auto entry = parents.find(pid);
    while (entry != parents.end() && entry->second != guard && entry->second != 0) {
      pid = entry->second;
      entry = parents.find(pid);
    }
    return pid;
  }

  std::map<pid_t, pid_t> parents;  ///< 0: of the starter
  std::map<pid_t, std::set<unsigned long>> sockets;
};

std::string missing_socket_owners() {
  const auto socket = base::UdpSocket::bind(*base::parse_ip_address("127.0.0.1", 0));
  const std::set<unsigned long> own = sockets_of(::getpid());
  for (const SocketEntry& entry : bound_sockets(Protocol::kUdp)) {
    if (socket && entry.port == socket->local_port() && own.contains(entry.inode)) return {};
  }
  return "this system does not show which process holds a socket (/proc): a program of one side "
         "can connect as the other side";
}

SocketOwners SocketOwners::of_own_programs() {
  const Guard* guard = Guard::active();
  return {guard == nullptr ? 0 : guard->pid(), ::getpid()};
}

std::optional<SocketOwners> SocketOwners::of_programs_beside() {
  const pid_t keeper = ::getppid();
  const pid_t guard = parent_of(keeper);
  const bool kept = short_name(keeper).starts_with(kKeeperMark);
  if (!kept || !short_name(guard).starts_with(kGuardMark)) return std::nullopt;
  return SocketOwners(guard, parent_of(guard));
}

// A process that forks while /proc is read can be missed: so an unknown owner is not remembered.
void SocketOwners::remember(unsigned long inode, const SocketOwner& owner) {
  if (owner.kind == SocketOwner::Kind::kUnknown) return;
  if (known_.size() >= kMaxKnown) known_.clear();
  known_[inode] = owner;
}

SocketOwner SocketOwners::owner_of(const base::SocketAddress& address) {
  const auto sockets = sockets_at(bound_sockets(Protocol::kUdp), hex_host(address), address.port());
  if (sockets.empty()) return {};  // a flood of such requests must cost nothing
  if (sockets.size() != 1) return find(inodes_of(sockets), family());
  const SocketEntry& socket = sockets.front();
  const auto known = known_.find(socket.inode);
  if (known != known_.end()) return known->second;

  SocketOwner owner = find({socket.inode}, family());
  if (owner.pid == 0 && socket.user != ::geteuid()) owner.kind = SocketOwner::Kind::kOutside;
  if (owner.pid == 0 && socket.user == ::geteuid()) owner = find_outside(socket.inode);
  remember(socket.inode, owner);
  return owner;
}

std::vector<SocketOwner> SocketOwners::peers_of(pid_t server) {
  std::set<unsigned long> own = sockets_of(server);
  for (const ProcessEntry& below : descendants_of(server)) own.merge(sockets_of(below.pid));
  const std::vector<SocketEntry> sockets = bound_sockets(Protocol::kUdp);

  std::vector<SocketOwner> owners;
  std::optional<Family> holders;
  for (const SocketEntry& socket : sockets) {
    if (socket.peer_port == 0 || !own.contains(socket.inode)) continue;
    if (!on_loopback(socket.peer_host)) continue;

    const std::string_view host =
        std::string_view(socket.peer_host).substr(socket.peer_host.size() - kAnyV4.size());
    const auto inodes = inodes_of(sockets_at(sockets, host, socket.peer_port));
    const auto known = inodes.size() == 1 ? known_.find(inodes.front()) : known_.end();
    if (known == known_.end() && !holders) holders = family();
    owners.push_back(known != known_.end() ? known->second : find(inodes, *holders));
    if (inodes.size() == 1) remember(inodes.front(), owners.back());
  }
  return owners;
}

SocketOwners::Family SocketOwners::family() const {
  Family family;
  family.parents[starter_] = 0;
  for (const ProcessEntry& entry : descendants_of(starter_)) {
    family.parents[entry.pid] = entry.parent;
  }
  for (const auto& [pid, parent] : family.parents) family.sockets[pid] = sockets_of(pid);
  return family;
}

SocketOwner SocketOwners::find_outside(unsigned long inode) const {
  const Family family = this->family();
  for (const int pid : all_pids()) {
    if (family.parents.contains(pid) || !sockets_of(pid).contains(inode)) continue;
    return {SocketOwner::Kind::kOutside, "", pid, short_name(pid)};
  }
  return {};
}

// Each socket must be held, and all holders must be of one program.
SocketOwner SocketOwners::find(const std::vector<unsigned long>& inodes,
                               const Family& family) const {
  std::set<unsigned long> missing(inodes.begin(), inodes.end());
  std::set<pid_t> keepers;  // or the starter
  SocketOwner owner;

  for (const auto& [pid, held] : family.sockets) {
    const auto holds = [&held = held](unsigned long inode) { return held.contains(inode); };
    if (std::ranges::none_of(inodes, holds)) continue;
    std::erase_if(missing, holds);
    owner.pid = pid;

    keepers.insert(family.top_of(pid, guard_));
  }

  if (owner.pid == 0) return owner;
  owner.command = short_name(owner.pid);
  if (keepers.size() != 1 || !missing.empty()) return owner;

  const pid_t top = *keepers.begin();
  if (top == starter_) {
    if (owner.pid == starter_) owner.kind = SocketOwner::Kind::kStarter;
    return owner;
  }

  const std::string name = short_name(top);
  if (!name.starts_with(kKeeperMark)) return owner;
  owner.kind = SocketOwner::Kind::kProgram;
  owner.program = name.substr(kKeeperMark.size());
  return owner;
}

}  // namespace cls::process

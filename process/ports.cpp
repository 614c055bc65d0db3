// Probes ports by binding, reserves them with abstract sockets, finds owners in /proc/net.
#include "process/ports.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netdb.h>
#include <netinet/in.h>
#include <sys/random.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <memory>
#include <optional>
#include <set>
#include <system_error>

#include "base/system/socket_address.h"
#include "base/system/tcp_connect.h"
#include "base/text/counted.h"
#include "process/process_tree.h"

namespace cls::process {
namespace {

// Below Linux's ephemeral ports (32768 and up).
constexpr int kMinPort = 20000;
constexpr int kMaxPort = 31999;
constexpr int kAttempts = 2000;

// 0, or the errno of what failed.
int bind_error(int type, int port) {
  const int off = 0;
  const int on = 1;
  std::string any = "::";  // includes IPv4 with IPV6_V6ONLY off
  base::UniqueFd socket(::socket(AF_INET6, type | SOCK_CLOEXEC, 0));
  if (!socket || ::setsockopt(socket.get(), IPPROTO_IPV6, IPV6_V6ONLY, &off, sizeof off) != 0) {
    any = "0.0.0.0";  // host without IPv6
    socket = base::UniqueFd(::socket(AF_INET, type | SOCK_CLOEXEC, 0));
  }
  if (!socket) return errno;

  // A server can reuse a TCP port with old connections in TIME_WAIT.
  if (type == SOCK_STREAM) {
    ::setsockopt(socket.get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  }

  const base::SocketAddress address = *base::parse_ip_address(any, port);
  return ::bind(socket.get(), address.get(), address.size) == 0 ? 0 : errno;
}

// Those of servers: of TCP without the connections of clients.
std::vector<SocketEntry> listening_sockets(Protocol protocol, int pid = 0) {
  std::vector<SocketEntry> sockets = bound_sockets(protocol, pid);
  std::erase_if(sockets, [protocol](const SocketEntry& socket) {
    return protocol == Protocol::kTcp && !socket.listens;
  });
  return sockets;
}

// Marks a port as taken among programs of cls; without a mark, `error` has the errno.
std::optional<base::UniqueFd> reserve(int port, int& error) {
  base::UniqueFd mark(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  if (!mark) {
    error = errno;
    return std::nullopt;
  }

  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  // An abstract socket (name begins with NUL) leaves no file.
  const std::string name = fmt::format("cls-port-{}", port);
  std::memcpy(address.sun_path + 1, name.data(), name.size());
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());

  if (::bind(mark.get(), reinterpret_cast<const sockaddr*>(&address), size) != 0) {
    error = errno;
    return std::nullopt;
  }
  return mark;
}

int random_port() {
  unsigned value = 0;
  if (::getrandom(&value, sizeof value, 0) != sizeof value)
    value = static_cast<unsigned>(::getpid());
  return kMinPort + static_cast<int>(value % (kMaxPort - kMinPort + 1));
}

}  // namespace

const std::string& loopback_host() {
  static const std::string host = [] {
    addrinfo* addresses = nullptr;
    const bool known = ::getaddrinfo("localhost", nullptr, nullptr, &addresses) == 0;
    if (known) ::freeaddrinfo(addresses);
    return known ? "localhost" : "127.0.0.1";
  }();
  return host;
}

std::string loopback_problem(bool ipv4) {
  ifaddrs* interfaces = nullptr;
  if (::getifaddrs(&interfaces) != 0) return {};
  const std::unique_ptr<ifaddrs, void (*)(ifaddrs*)> owner(interfaces, ::freeifaddrs);

  bool up = false;
  bool has_address = false;
  for (const ifaddrs* one = interfaces; one != nullptr; one = one->ifa_next) {
    if ((one->ifa_flags & IFF_LOOPBACK) == 0 || (one->ifa_flags & IFF_UP) == 0) continue;
    up = true;
    if (one->ifa_addr == nullptr || one->ifa_addr->sa_family != AF_INET) continue;
    const auto& address = reinterpret_cast<const sockaddr_in&>(*one->ifa_addr);
    has_address |= ntohl(address.sin_addr.s_addr) == INADDR_LOOPBACK;
  }

  if (!up) return "the loopback interface is down; bring it up: ip link set lo up";
  if (ipv4 && !has_address) {
    return "the loopback interface has no address 127.0.0.1; add it: ip addr add 127.0.0.1/8 dev "
           "lo";
  }
  return {};
}

bool port_is_free(Protocol protocol, int port) {
  return bind_error(protocol == Protocol::kTcp ? SOCK_STREAM : SOCK_DGRAM, port) == 0;
}

std::vector<PortOwner> owners_of(Protocol protocol, int port) {
  std::set<unsigned long> wanted;
  for (const SocketEntry& socket : listening_sockets(protocol)) {
    if (socket.port == port) wanted.insert(socket.inode);
  }

  std::vector<PortOwner> owners;
  if (wanted.empty()) return owners;

  const auto is_wanted = [&wanted](unsigned long inode) { return wanted.contains(inode); };
  for (const int pid : all_pids()) {
    if (std::ranges::any_of(sockets_of(pid), is_wanted)) owners.push_back({pid, short_name(pid)});
  }
  if (owners.empty()) owners.emplace_back();
  return owners;
}

std::string port_taken_text(Protocol protocol, int port) {
  std::string text =
      fmt::format("{} port {} is taken", protocol == Protocol::kTcp ? "TCP" : "UDP", port);
  const std::vector<PortOwner> owners = owners_of(protocol, port);
  if (owners.empty()) return text;
  if (owners.front().pid == 0) return text + " by a process of another user";
  return text + fmt::format(" by {} (process {})", owners.front().program, owners.front().pid);
}

std::string taken_port(Protocol protocol, const std::vector<int>& ports) {
  const auto taken = std::ranges::find_if(
      ports, [&](int port) { return port != 0 && !port_is_free(protocol, port); });
  return taken == ports.end() ? std::string() : port_taken_text(protocol, *taken);
}

std::string unusable_host(const std::string& host) {
  const auto addresses = base::resolve_all(base::strip_brackets(host), 0, AF_UNSPEC, SOCK_STREAM);
  if (!addresses) return "cannot be resolved: " + addresses.error().message;

  for (const base::SocketAddress& address : *addresses) {
    const base::UniqueFd socket(::socket(address.family(), SOCK_STREAM | SOCK_CLOEXEC, 0));
    if (socket && ::bind(socket.get(), address.get(), address.size) == 0) return {};
  }
  return "not an address of this host; 0.0.0.0 listens on all";
}

std::vector<int> ports_of(Protocol protocol, int pid) {
  std::set<unsigned long> inodes = sockets_of(pid);
  for (const ProcessEntry& entry : descendants_of(pid)) inodes.merge(sockets_of(entry.pid));

  std::set<int> ports;
  for (const SocketEntry& socket : listening_sockets(protocol, pid)) {
    if (inodes.contains(socket.inode)) ports.insert(socket.port);
  }
  return {ports.begin(), ports.end()};
}

namespace {

enum class Marks { kNeeded, kIgnored };

// Reserves a port that no process uses; else sets `error`.
std::optional<base::UniqueFd> reserve_free(int number, Marks marks, int& error) {
  auto mark = reserve(number, error);
  if (!mark && marks == Marks::kIgnored && error == EADDRINUSE) mark.emplace();
  for (const int type : {SOCK_STREAM, SOCK_DGRAM}) {
    if (const int failed = mark ? bind_error(type, number) : 0; failed != 0) {
      error = failed;
      mark.reset();
    }
  }
  return mark;
}

// Any user can take the names of the marks, all of them too. They only keep programs of cls from
// choosing the same port in parallel, so a host where they run out goes without.
Marks marks_of(int attempt) { return attempt < kAttempts / 2 ? Marks::kNeeded : Marks::kIgnored; }

}  // namespace

base::Result<std::vector<ReservedPort>> ReservedPort::choose(int count) {
  std::vector<ReservedPort> ports;
  int error = 0;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    if (static_cast<int>(ports.size()) == count) return ports;
    const int number = random_port();
    const bool chosen = std::ranges::find(ports, number, &ReservedPort::number) != ports.end();
    auto mark = chosen ? std::nullopt : reserve_free(number, marks_of(attempt), error);
    if (mark) ports.push_back(ReservedPort(number, *std::move(mark)));
  }
  return base::Error{fmt::format("no {} between {} and {} after {} tries; the last one: {}",
                                 base::counted(count, "free port"), kMinPort, kMaxPort, kAttempts,
                                 std::generic_category().message(error))};
}

base::Result<std::vector<ReservedPort>> ReservedPort::choose_row(int count, int first) {
  // Empty if one of them is in use or reserved: `error` says why.
  int error = 0;
  const auto reserve_row = [&](int from, Marks marks) {
    std::vector<ReservedPort> ports;
    for (int number = from; number < from + count; ++number) {
      auto mark = reserve_free(number, marks, error);
      if (!mark) return std::vector<ReservedPort>();
      ports.push_back(ReservedPort(number, *std::move(mark)));
    }
    return ports;
  };

  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const bool wished = attempt == 0 && first != 0;
    auto ports = reserve_row(wished ? first : random_port(), marks_of(attempt));
    if (!ports.empty()) return ports;
  }
  return base::Error{
      fmt::format("no {} free ports in a row between {} and {} after {} tries; the last one: {}",
                  count, kMinPort, kMaxPort, kAttempts, std::generic_category().message(error))};
}

bool tcp_answers(const std::string& host, int port, int limit_ms) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds(limit_ms);
  return static_cast<bool>(base::connect_tcp(host, port, deadline));
}

}  // namespace cls::process

// Requests to the guard for namespaces, and to a maker for sockets.
#include "process/namespaces.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <string_view>
#include <utility>

#include "process/confinement.h"
#include "process/guard.h"
#include "process/landlock.h"
#include "process/namespace_maker.h"
#include "process/packet.h"

namespace cls::process {
namespace {

using base::Error;
using base::Result;

std::string_view what_failed(NamespaceStep step) {
  switch (step) {
    case NamespaceStep::kUser:
      return "a user namespace";
    case NamespaceStep::kNetwork:
      return "a network namespace";
    case NamespaceStep::kMounts:
      return "mounts and a /proc of its own";
  }
  return "";
}

// Settings with which systems forbid namespaces to users, and the value that allows them.
struct Setting {
  const char* name;
  const char* file;
  bool zero_forbids;
};
constexpr Setting kSettings[] = {
    {"kernel.unprivileged_userns_clone=1", "/proc/sys/kernel/unprivileged_userns_clone", true},
    {"kernel.apparmor_restrict_unprivileged_userns=0",
     "/proc/sys/kernel/apparmor_restrict_unprivileged_userns", false},
    {"user.max_user_namespaces=10000", "/proc/sys/user/max_user_namespaces", true},
    {"user.max_net_namespaces=10000", "/proc/sys/user/max_net_namespaces", true}};

// "; sysctl NAME=VALUE allows it"; empty: no setting is the reason.
std::string remedy() {
  for (const Setting& setting : kSettings) {
    std::ifstream file(setting.file);
    long value = 0;
    if (!(file >> value) || (value == 0) != setting.zero_forbids) continue;
    return fmt::format("; sysctl {} allows it", setting.name);
  }
  return {};
}

struct Made {
  base::UniqueFd user;
  base::UniqueFd network;
  base::UniqueFd door;
};

Result<Made> make(const NamespaceRequest& request) {
  const Guard* guard = Guard::active();
  if (guard == nullptr) return Error{"no guard process"};

  auto control = make_socket_pair();
  if (!control || !send_plain(guard->socket(), request, {control->second.get()})) {
    return Error{std::strerror(errno)};
  }
  control->second.reset();

  Packet packet = receive_packet(control->first.get());
  const auto reply = read_plain<NamespaceReply>(packet);
  if (!reply) return Error{"no process could be made for it"};
  if (reply->error != 0) {
    return Error{
        fmt::format("{}: {}{}", what_failed(reply->step), std::strerror(reply->error), remedy())};
  }

  constexpr std::size_t kUserAndNetwork = 2;
  if (packet.fds.size() != kUserAndNetwork) return Error{std::strerror(EMFILE)};
  return Made{std::move(packet.fds[0]), std::move(packet.fds[1]), std::move(control->first)};
}

std::string try_namespaces() {
  if (landlock_version() == 0) return "this kernel has no Landlock";
  if (!can_confine()) return "this kernel has no seccomp";
  const auto made = make({.tried = true});
  return made ? std::string() : made.error().message;
}

}  // namespace

Result<base::UniqueFd> NetworkDoor::ask(const SocketRequest& request) const {
  if (!send_plain(socket_.get(), request)) return Error{std::strerror(errno)};

  Packet packet = receive_packet(socket_.get());
  const auto error = read_plain<SocketReply>(packet);
  if (!error) return Error{"the process in that network is gone"};
  if (*error != 0) return Error{std::strerror(*error)};
  if (packet.fds.size() != 1) return Error{std::strerror(EMFILE)};
  return std::move(packet.fds[0]);
}

Result<base::UdpSocket> NetworkDoor::bind_udp(const base::SocketAddress& local) const {
  TRY_INIT(auto socket, ask({.tcp = false, .local = local}));
  return base::UdpSocket::adopt(std::move(socket), local.family());
}

Result<base::UniqueFd> NetworkDoor::make_tcp(int family) const {
  SocketRequest request{.tcp = true, .local = {}};
  request.local.bytes.ss_family = static_cast<sa_family_t>(family);
  return ask(request);
}

Result<std::shared_ptr<const Namespaces>> Namespaces::create() {
  TRY_INIT(auto made, make({}));
  return std::shared_ptr<const Namespaces>(
      new Namespaces(std::move(made.user), std::move(made.network), std::move(made.door)));
}

const std::string& missing_namespaces() {
  static const std::string why = try_namespaces();
  return why;
}

}  // namespace cls::process

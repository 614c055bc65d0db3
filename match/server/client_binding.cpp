// Rights by owner, and lines about intrusions.
#include "match/server/client_binding.h"

#include <fmt/format.h>

#include "base/text/printable.h"
#include "soccer/side.h"

namespace cls::match {
namespace {

using process::SocketOwner;
using soccer::Side;

constexpr std::size_t kMaxLines = 20;
constexpr std::size_t kMaxRequestSize = 60;

std::string program_of(Side side) {
  return fmt::format("a program of the {} side", side_name(side));
}

std::string describe(const SocketOwner& owner) {
  const Side side = side_of(owner);
  std::string text = side == Side::kNeutral ? "a process outside of the match" : program_of(side);
  if (owner.kind == SocketOwner::Kind::kUnknown) text = "a process that hides its sockets";
  if (owner.pid == 0) return text;
  return text + fmt::format(" ({}, process {})", base::printable(owner.command), owner.pid);
}

// Begins a request, and says what it asks for.
std::string_view kind_of(std::string_view request) { return request.substr(0, request.find(' ')); }

}  // namespace

Side side_of(const SocketOwner& owner) {
  if (owner.kind != SocketOwner::Kind::kProgram) return Side::kNeutral;
  for (const Side side : soccer::kBothSides) {
    if (owner.program.starts_with(fmt::format("{} ", side_name(side)))) return side;
  }
  return Side::kNeutral;
}

simulator::ClientRights ClientBinding::rights_of(const base::SocketAddress& sender) {
  constexpr simulator::ClientRights kNone{false, false, false, false};

  const SocketOwner owner = owners_->owner_of(sender);
  switch (owner.kind) {
    case SocketOwner::Kind::kStarter:
      return {!sides_.external.left, !sides_.external.right, true, true};
    case SocketOwner::Kind::kOutside:
      return {false, false, !sides_.trainer, true};
    case SocketOwner::Kind::kUnknown:
      return kNone;
    case SocketOwner::Kind::kProgram:
      break;
  }

  const Side side = side_of(owner);
  return side == Side::kNeutral || !sides_.external[side] ? kNone : rights_of(side);
}

simulator::ClientRights ClientBinding::rights_of(Side side) const {
  return {side == Side::kLeft, side == Side::kRight, false, false,
          soccer::TeamName(sides_.names[side])};
}

std::optional<std::string> ClientBinding::intrusion_line(const base::SocketAddress& sender,
                                                         std::string_view request) {
  const SocketOwner owner = owners_->owner_of(sender);
  const std::string key = fmt::format("{} {}", owner.pid, kind_of(request));
  return line(describe(owner), key, sender.port(), request);
}

std::optional<std::string> ClientBinding::intrusion_line(Side side,
                                                         const base::SocketAddress& sender,
                                                         std::string_view request) {
  const std::string who = program_of(side);
  return line(who, fmt::format("{} {}", who, kind_of(request)), sender.port(), request);
}

std::optional<std::string> ClientBinding::line(const std::string& who, const std::string& key,
                                               int port, std::string_view request) {
  if (reported_.size() >= kMaxLines || !reported_.insert(key).second) return std::nullopt;
  return fmt::format("{} at UDP port {} sent {}: refused", who, port,
                     base::printable(std::string(request.substr(0, kMaxRequestSize))));
}

simulator::OtherNetwork network_of(Side side, ClientBinding& binding,
                                   const process::NetworkDoor& door,
                                   std::function<void(std::string)> report) {
  const auto bind = [&door](const base::SocketAddress& local) { return door.bind_udp(local); };
  const auto on_intrusion = [side, &binding, report = std::move(report)](
                                const base::SocketAddress& sender, std::string_view request) {
    if (auto line = binding.intrusion_line(side, sender, request)) report(*std::move(line));
  };
  return {bind, binding.rights_of(side), on_intrusion};
}

}  // namespace cls::match

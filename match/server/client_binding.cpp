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

std::string describe(const SocketOwner& owner, int port) {
  const Side side = side_of(owner);
  std::string text = side == Side::kNeutral
                         ? "a process outside of the match"
                         : fmt::format("a program of the {} side", side_name(side));
  if (owner.kind == SocketOwner::Kind::kUnknown) text = "a process that hides its sockets";
  if (owner.pid != 0) {
    text += fmt::format(" ({}, process {})", base::printable(owner.command), owner.pid);
  }
  return text + fmt::format(" at UDP port {}", port);
}

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

  const SocketOwner owner = owners_.owner_of(sender);
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
  if (side == Side::kNeutral || !sides_.external[side]) return kNone;
  return {side == Side::kLeft, side == Side::kRight, false, false,
          soccer::TeamName(sides_.names[side])};
}

std::optional<std::string> ClientBinding::intrusion_line(const base::SocketAddress& sender,
                                                         std::string_view request) {
  const SocketOwner owner = owners_.owner_of(sender);
  const std::string kind(request.substr(0, request.find(' ')));
  const std::string key = fmt::format("{} {}", owner.pid, kind);
  if (reported_.size() >= kMaxLines || !reported_.insert(key).second) return std::nullopt;

  return fmt::format("{} sent {}: refused", describe(owner, sender.port()),
                     base::printable(std::string(request.substr(0, kMaxRequestSize))));
}

}  // namespace cls::match

// Messages between cls, its guard and the keepers over local sockets.
#pragma once

#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/system/unique_fd.h"
#include "process/command_plan.h"
#include "process/launch.h"

namespace cls::process {

/// From a keeper to cls.
struct KeeperReport {
  enum class Kind : std::uint8_t {
    kStarted,   ///< the program is running
    kFailed,    ///< it could not be started: `number` (errno) and `step`
    kExited,    ///< the program itself exited; `living` descendants are still running
    kUsage,     ///< reply to kUsage
    kCpuLimit,  ///< a process below the program died of its limit of CPU time
    kGone,      ///< no process is left; the last report
  };

  Kind kind = Kind::kStarted;
  bool by_signal = false;     ///< kExited
  bool at_cpu_limit = false;  ///< kCpuLimit, and kExited if the program itself died of that limit
  LaunchStep step = LaunchStep::kProgram;  ///< kFailed
  std::int32_t pid = 0;                    ///< kStarted
  std::int32_t number = 0;                 ///< kExited: exit code or signal; kFailed: errno
  std::int32_t living = 0;                 ///< kExited: descendants still running
  double cpu_seconds = 0.0;                ///< of the program and all its descendants until now
  double delayed_seconds = 0.0;            ///< of those that ran when it was asked to end, or run
};

/// From cls to a keeper.
struct KeeperRequest {
  enum class Kind : std::uint8_t {
    kUsage,      ///< report the CPU time
    kEnd,        ///< SIGTERM to all, after `grace_s` SIGKILL
    kEndGently,  ///< SIGTERM to the program alone, to the rest after its exit, then as kEnd
  };

  Kind kind = Kind::kUsage;
  double grace_s = 1.0;
};

/// A received message: bytes and descriptors. No bytes: the peer has closed the connection.
struct Packet {
  std::string bytes;
  std::vector<base::UniqueFd> fds;
};

/// Two connected sockets that preserve message boundaries (SOCK_SEQPACKET), close-on-exec. Empty on
/// failure.
std::optional<std::pair<base::UniqueFd, base::UniqueFd>> make_socket_pair();

/// Sends one message and copies of the descriptors. False with errno set on failure.
bool send_packet(int socket, std::string_view bytes, const std::vector<int>& fds = {});

/// Waits for one message.
Packet receive_packet(int socket);

/// Sends the bytes of a value as a message, see send_packet(): both ends are of one build.
template <typename T>
bool send_plain(int socket, const T& value, const std::vector<int>& fds = {}) {
  static_assert(std::is_trivially_copyable_v<T>);
  return send_packet(socket, {reinterpret_cast<const char*>(&value), sizeof value}, fds);
}

/// The value of such a message; nothing if it is not of the size of one.
template <typename T>
std::optional<T> read_plain(const Packet& packet) {
  static_assert(std::is_trivially_copyable_v<T>);
  T value;
  if (packet.bytes.size() != sizeof value) return std::nullopt;
  std::memcpy(&value, packet.bytes.data(), sizeof value);
  return value;
}

/// `program`: a descriptor of its process (pidfd), where `pid` is not its number for the receiver;
/// -1: none.
bool send_report(int socket, const KeeperReport& report, int program = -1);
bool send_request(int socket, const KeeperRequest& request);
/// Nothing if the bytes are not such a message.
std::optional<KeeperReport> read_report(const Packet& packet);
std::optional<KeeperRequest> read_request(const Packet& packet);

/// Converts a plan to bytes and back, without its log file, which cls writes, and its namespaces
/// and passed descriptors, which go with the packet: of `passed` only the number is kept.
/// Hand-written: the guard and the keepers are forks of cls that must not load protobuf or allocate
/// JSON trees, and both ends are always of the same build.
std::string encode(const CommandPlan& plan);
std::optional<CommandPlan> decode_plan(std::string_view bytes);

}  // namespace cls::process

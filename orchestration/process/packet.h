// What cls, its guard and the keepers say to each other over local sockets.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "orchestration/process/command_plan.h"
#include "orchestration/process/unique_fd.h"

namespace cls::orchestration::process {

/// From a keeper to cls.
struct KeeperReport {
  enum class Kind : std::uint8_t {
    kStarted,  ///< the program runs
    kFailed,   ///< it could not be started: `error` (errno) and `stage`
    kExited,   ///< the program itself ended; `living` of its descendants go on
    kUsage,    ///< answer to kUsage
    kGone,     ///< nothing of it is left; the last report
  };

  Kind kind = Kind::kStarted;
  bool by_signal = false;    ///< kExited
  bool in_folder = false;    ///< kFailed: changing to the working directory, not the program
  std::int32_t pid = 0;      ///< kStarted
  std::int32_t number = 0;   ///< kExited: exit code or signal; kFailed: errno
  std::int32_t living = 0;   ///< kExited: descendants that are still there
  double cpu_seconds = 0.0;  ///< of the program and all its descendants until now
};

/// From cls to a keeper.
struct KeeperRequest {
  enum class Kind : std::uint8_t {
    kUsage,      ///< report the CPU time
    kEnd,        ///< SIGTERM to all, after `grace_s` SIGKILL
    kEndGently,  ///< SIGTERM to the program alone, to the rest when it is gone, then as kEnd
  };

  Kind kind = Kind::kUsage;
  double grace_s = 1.0;
};

/// A message as it came: its bytes and the descriptors it carried. No bytes: the other side is
/// gone.
struct Packet {
  std::string bytes;
  std::vector<UniqueFd> fds;
};

/// Two connected sockets that keep message boundaries, closed on exec. Empty when the system has
/// none left.
std::optional<std::pair<UniqueFd, UniqueFd>> make_socket_pair();

/// Sends one message and copies of the descriptors. False with errno set when it cannot be sent.
bool send_packet(int socket, std::string_view bytes, const std::vector<int>& fds = {});

/// Waits for one message.
Packet receive_packet(int socket);

bool send_report(int socket, const KeeperReport& report);
bool send_request(int socket, const KeeperRequest& request);
/// Nothing when the bytes are not of that kind.
std::optional<KeeperReport> read_report(const Packet& packet);
std::optional<KeeperRequest> read_request(const Packet& packet);

/// A plan as bytes and back (not its log: that is written by cls).
std::string encode(const CommandPlan& plan);
std::optional<CommandPlan> decode_plan(std::string_view bytes);

}  // namespace cls::orchestration::process

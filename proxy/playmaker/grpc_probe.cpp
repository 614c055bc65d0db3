// Sends the beginning of an HTTP/2 connection, and looks at the first bytes that come back.
#include "proxy/playmaker/grpc_probe.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <array>
#include <chrono>
#include <cstring>
#include <string_view>

#include "base/system/tcp_connect.h"
#include "base/system/unique_fd.h"
#include "proxy/playmaker/tls_probe.h"

namespace cls::proxy {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kConnectTimeout{1000};
constexpr std::chrono::milliseconds kReplyTimeout{1000};
// RFC 9113, 3.4: the preface and an empty SETTINGS frame (3 bytes length, type 4, flags, stream).
constexpr std::string_view kPreface("PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n\0\0\0\4\0\0\0\0\0", 33);
constexpr std::size_t kFrameType = 3;
constexpr char kSettings = 4;

base::UniqueFd connect_unix(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) return base::UniqueFd();
  std::memcpy(address.sun_path, path.c_str(), path.size());
  base::UniqueFd fd(::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  if (!fd) return fd;
  const auto* generic = reinterpret_cast<const sockaddr*>(&address);
  if (::connect(fd.get(), generic, sizeof address) != 0) return base::UniqueFd();
  return fd;
}

base::UniqueFd connect_to(const GrpcTarget& target, int agent) {
  if (!target.unix_path.empty()) return connect_unix(target.unix_path);
  return base::connect_tcp(target.host, port_of(target, agent), Clock::now() + kConnectTimeout,
                           target.make_socket);
}

enum class Answer { kHttp2, kHttp1, kOther, kClosed, kSilent };

Answer read_answer(int fd) {
  const auto deadline = Clock::now() + kReplyTimeout;
  std::array<char, 64> bytes{};
  if (::send(fd, kPreface.data(), kPreface.size(), MSG_NOSIGNAL) < 0) return Answer::kClosed;
  if (!base::wait_for_events(fd, POLLIN, deadline)) return Answer::kSilent;

  const auto size = ::recv(fd, bytes.data(), bytes.size(), 0);
  if (size <= 0) return Answer::kClosed;
  const std::string_view answer(bytes.data(), static_cast<std::size_t>(size));
  if (answer.size() > kFrameType && answer[0] == 0 && answer[kFrameType] == kSettings) {
    return Answer::kHttp2;
  }
  // Servers that do not know the version of a request reply without headers.
  if (answer.starts_with("HTTP/") || answer.starts_with('<')) return Answer::kHttp1;
  return Answer::kOther;
}

}  // namespace

GrpcProbe probe_grpc(const GrpcTarget& target, int agent) {
  const std::string place = address(target, agent);
  const base::UniqueFd fd = connect_to(target, agent);
  if (!fd) return {"nothing listens at " + place, false};
  if (target.tls != nullptr) return {explain_tls_failure(target, agent), false};

  const Answer answer = read_answer(fd.get());
  if (answer == Answer::kHttp2) return {};
  if (answer == Answer::kSilent) {
    return {"the program at " + place +
                " accepts connections and sends nothing: it hangs, or does not speak gRPC",
            false};
  }
  if (answer == Answer::kHttp1) {
    return {"an HTTP server answers at " + place +
                ", it does not speak gRPC, which needs HTTP/2 without TLS (in ASP.NET Core: "
                "options.Listen(..., o => o.Protocols = HttpProtocols.Http2))",
            true};
  }

  // Servers with TLS answer with an alert, or close the connection.
  const std::string tls = explain_tls_failure(target, agent);
  if (!tls.empty()) return {tls, true};
  // A forwarder whose Playmaker is not up yet closes connections, too.
  if (answer == Answer::kClosed) {
    return {"the program at " + place + " closes connections: not ready, or does not speak gRPC",
            false};
  }
  return {"the program at " + place + " does not speak gRPC", true};
}

}  // namespace cls::proxy

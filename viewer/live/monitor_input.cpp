// Turns the datagrams of a monitor connection into the lines of a game log.
#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "base/system/tcp_connect.h"
#include "base/system/udp_socket.h"
#include "soccer/play_mode.h"
#include "soccer/protocol/scanner.h"
#include "viewer/live/live_input.h"

namespace cls::viewer {
namespace {

using std::chrono::steady_clock;

constexpr std::chrono::seconds kConnectTimeout{3};
/// A server sends a show per step; after this much silence it is gone.
constexpr std::chrono::seconds kSilence{30};
constexpr int kReceiveBuffer = 1 << 20;

/// The start of a show: "(show TIME (pm MODE) (tm TEAMS) ".
struct ShowHead {
  int time = 0;
  int mode = 0;
  std::string_view teams;
  std::string_view rest;  ///< ball and players
};

std::optional<ShowHead> parse_head(std::string_view show) {
  ShowHead head;
  soccer::Scanner in(show);
  if (!in.sequence("(show ", head.time, " (pm ", head.mode, ") (tm ")) return std::nullopt;
  if (head.mode <= 0 || head.mode >= soccer::kPlayModeCount) return std::nullopt;

  const std::size_t end = in.rest().find(')');
  if (end == std::string_view::npos) return std::nullopt;
  head.teams = in.rest().substr(0, end);
  head.rest = in.rest().substr(end);
  return head;
}

class MonitorInput : public LiveInput {
 public:
  MonitorInput(base::UdpSocket socket, base::SocketAddress server)
      : socket_(std::move(socket)), server_(server) {
    socket_.set_receive_buffer(kReceiveBuffer);
  }
  ~MonitorInput() override { socket_.send("(dispbye)", true, &server_); }

  /// Asks for version 5 and waits for the first datagram. The error is empty or one line.
  std::string connect() {
    socket_.send("(dispinit version 5)", true, &server_);
    const auto deadline = steady_clock::now() + kConnectTimeout;
    if (!base::wait_for_events(socket_.fd(), POLLIN, deadline)) return "no soccer server answers";

    receive();
    const std::size_t line = lines_.find('\n') + 1;
    if (lines_.compare(line, 7, "(error ") != 0) return "";
    return fmt::format("the server refused: {}", lines_.substr(line, lines_.size() - line - 1));
  }

  std::size_t read(char* to, std::size_t size) override {
    receive();
    const std::size_t count = std::min(size, lines_.size());
    std::copy_n(lines_.begin(), count, to);
    lines_.erase(0, count);
    return count;
  }

  State state() override {
    return steady_clock::now() - heard_ > kSilence ? State::kEnded : State::kOpen;
  }

 private:
  // Everything after the first reply comes from a port of its own.
  void receive() {
    while (incoming_.receive(socket_) == 0 && incoming_.size() > 0) {
      heard_ = steady_clock::now();
      for (std::size_t i = 0; i < incoming_.size(); ++i) {
        if (!incoming_.sender(i).same_host(server_)) continue;
        server_ = incoming_.sender(i);
        add(std::string(incoming_.bytes(i)));
      }
    }
  }

  void add(std::string message) {
    while (!message.empty() && message.back() == '\0') message.pop_back();
    std::ranges::replace(message, '\n', ' ');
    if (message.starts_with("(show ")) return add_show(message);
    lines_ += message + "\n";
  }

  // Logs have play mode and teams as records of their own. Before kick-off and after the match
  // servers send the same show again and again.
  void add_show(const std::string& message) {
    const auto head = parse_head(message);
    if (!head) return;

    const bool changed = head->mode != mode_ || head->teams != teams_;
    if (head->mode != mode_) {
      const auto mode = static_cast<soccer::PlayMode>(head->mode);
      lines_ += fmt::format("(playmode {} {})\n", head->time, soccer::name(mode));
    }
    if (head->teams != teams_) lines_ += fmt::format("(team {} {})\n", head->time, head->teams);

    mode_ = head->mode;
    teams_ = head->teams;
    if (!changed && head->rest == rest_) return;
    rest_ = head->rest;
    lines_ += message + "\n";
  }

  base::UdpSocket socket_;
  base::SocketAddress server_;
  base::IncomingDatagrams incoming_;

  std::string lines_ = "ULG6\n";
  steady_clock::time_point heard_ = steady_clock::now();
  int mode_ = 0;
  std::string teams_;
  std::string rest_;
};

}  // namespace

base::Result<std::unique_ptr<LiveInput>> follow_server(const std::string& host, int port) {
  const auto place = [&](const std::string& why) {
    return base::Error{fmt::format("{}:{}: {}", host, port, why)};
  };

  TRY_INIT(const auto server, base::resolve_udp(host, port));
  auto socket = base::UdpSocket::open(server.family());
  if (!socket) return place(socket.error().message);

  auto input = std::make_unique<MonitorInput>(*std::move(socket), server);
  if (const std::string why = input->connect(); !why.empty()) return place(why);
  return std::unique_ptr<LiveInput>(std::move(input));
}

}  // namespace cls::viewer

// Turns the datagrams of a monitor connection into the lines of a game log.
#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <utility>

#include "base/system/tcp_connect.h"
#include "base/system/udp_socket.h"
#include "soccer/play_mode.h"
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

bool parse_head(const std::string& show, ShowHead& head) {
  int teams = 0;
  if (std::sscanf(show.c_str(), "(show %d (pm %d) (tm %n", &head.time, &head.mode, &teams) != 2) {
    return false;
  }
  const std::size_t end = show.find(')', static_cast<std::size_t>(teams));
  if (teams == 0 || end == std::string::npos) return false;

  head.teams = std::string_view(show).substr(static_cast<std::size_t>(teams),
                                             end - static_cast<std::size_t>(teams));
  head.rest = std::string_view(show).substr(end);
  return head.mode > 0 && head.mode < soccer::kPlayModeCount;
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
    std::replace(message.begin(), message.end(), '\n', ' ');
    if (message.starts_with("(show ")) return add_show(message);
    lines_ += message + "\n";
  }

  // Logs have play mode and teams as records of their own. Before kick-off and after the match
  // servers send the same show again and again.
  void add_show(const std::string& message) {
    ShowHead head;
    if (!parse_head(message, head)) return;

    const bool changed = head.mode != mode_ || head.teams != teams_;
    if (head.mode != mode_) {
      const auto mode = static_cast<soccer::PlayMode>(head.mode);
      lines_ += fmt::format("(playmode {} {})\n", head.time, soccer::name(mode));
    }
    if (head.teams != teams_) lines_ += fmt::format("(team {} {})\n", head.time, head.teams);

    mode_ = head.mode;
    teams_ = head.teams;
    if (!changed && head.rest == rest_) return;
    rest_ = head.rest;
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

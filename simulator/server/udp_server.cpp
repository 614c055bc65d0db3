// Sockets around the match server.
#include "simulator/server/udp_server.h"

#include <array>
#include <boost/asio.hpp>
#include <utility>
#include <variant>

namespace cls::simulator {
namespace {

namespace asio = boost::asio;
using asio::ip::udp;
using WallClock = std::chrono::steady_clock;

constexpr std::size_t kBufferSize = 8192;

/// Text as it came: without the closing NUL, and up to the first one.
struct Datagram {
  std::string_view text;
  bool null_terminated = false;
};

Datagram strip(std::string_view bytes) {
  const bool terminated = !bytes.empty() && bytes.back() == '\0';
  return {bytes.substr(0, bytes.find('\0')), terminated};
}

/// The server's end of one client: a socket of its own, connected to the client's.
class UdpChannel : public soccer::Channel {
 public:
  explicit UdpChannel(udp::socket socket) : socket_(std::move(socket)) {}

  bool send(std::string_view message) override {
    constexpr char kNul = '\0';
    const std::array<asio::const_buffer, 2> buffers = {asio::buffer(message),
                                                       asio::buffer(&kNul, 1)};
    boost::system::error_code error;
    socket_.send(buffers, 0, error);
    return !is_gone(error);
  }

  bool receive(std::string& message) override {
    Datagram datagram;
    if (!receive(datagram)) return false;
    message = datagram.text;
    return true;
  }

  /// The view holds until the next call.
  bool receive(Datagram& datagram) {
    boost::system::error_code error;
    const std::size_t size = socket_.receive(asio::buffer(buffer_), 0, error);
    gone_ = gone_ || is_gone(error);
    if (error) return false;
    datagram = strip({buffer_.data(), size});
    return true;
  }

  /// The other side has closed its port.
  bool gone() const { return gone_; }

  udp::socket& socket() { return socket_; }

 private:
  // A full buffer loses a datagram, as networks do; only a closed port is the end.
  static bool is_gone(const boost::system::error_code& error) {
    return error == asio::error::connection_refused;
  }

  udp::socket socket_;
  bool gone_ = false;
  std::array<char, kBufferSize> buffer_;
};

}  // namespace

/// The port of the server and the sockets of its clients, which the match owns by its sessions.
class UdpServer::Network {
 public:
  explicit Network(MatchServer& match) : match_(match), door_(io_) {}

  soccer::Result<void> open(const std::string& address, int port) {
    boost::system::error_code error;
    const auto ip = asio::ip::make_address(address, error);
    udp::endpoint local(ip, static_cast<unsigned short>(port));
    if (!error) door_.open(local.protocol(), error);
    if (!error) door_.bind(local, error);
    if (!error) door_.non_blocking(true, error);
    if (error) {
      return soccer::Error{"cannot listen on " + address + " port " + std::to_string(port) + ": " +
                           error.message()};
    }
    address_ = ip;
    listen_at_door();
    return {};
  }

  int port() const { return door_.local_endpoint().port(); }

  /// Takes in what arrives until `deadline`, or until nobody is awaited if `only_awaited`.
  void receive_until(WallClock::time_point deadline, bool only_awaited) {
    io_.poll();
    while (!(only_awaited && !match_.awaits_anybody()) && WallClock::now() < deadline) {
      io_.run_one_until(deadline);
    }
  }

 private:
  void listen_at_door() {
    door_.async_wait(udp::socket::wait_read, [this](const boost::system::error_code& error) {
      if (error) return;
      receive_at_door();
      listen_at_door();
    });
  }

  void receive_at_door() {
    udp::endpoint sender;
    for (;;) {
      boost::system::error_code error;
      const std::size_t size = door_.receive_from(asio::buffer(buffer_), sender, 0, error);
      if (error == asio::error::connection_refused) continue;  // an answer that nobody wanted
      if (error) return;
      answer(strip({buffer_.data(), size}).text, sender);
    }
  }

  void answer(std::string_view text, const udp::endpoint& sender) {
    if (Session* known = session_of(sender)) {
      std::string refusal;
      soccer::format(soccer::ErrorCode::kOnlyInitAllowedOnInitPort, refusal);
      known->send(refusal);
      return;
    }
    if (text.ends_with('\n')) text.remove_suffix(1);
    const auto admission = match_.admit(text);
    if (const auto* admitted = std::get_if<Admission>(&admission)) {
      welcome(*admitted, text, sender);
    } else {
      refuse(std::get<soccer::ErrorCode>(admission), sender);
    }
  }

  void welcome(const Admission& admission, std::string_view request, const udp::endpoint& sender) {
    boost::system::error_code error;
    udp::socket socket(io_);
    socket.open(sender.protocol(), error);
    if (!error) socket.bind(udp::endpoint(address_, 0), error);
    if (!error) socket.connect(sender, error);
    if (!error) socket.non_blocking(true, error);
    if (error) {
      match_.withdraw(admission);
      refuse(soccer::ErrorCode::kSocketOpenFailed, sender);
      return;
    }
    auto channel = std::make_unique<UdpChannel>(std::move(socket));
    Client& client = clients_[static_cast<std::size_t>(admission.slot)];
    client = {sender, channel.get(), client.generation + 1};
    match_.greet(admission, std::move(channel), request);
    listen_to(admission.slot, client.generation);
  }

  void refuse(soccer::ErrorCode code, const udp::endpoint& sender) {
    std::string refusal;
    soccer::format(code, refusal);
    boost::system::error_code ignored;
    door_.send_to(asio::buffer(refusal.c_str(), refusal.size() + 1), sender, 0, ignored);
  }

  void listen_to(Slot slot, int generation) {
    Client& client = clients_[static_cast<std::size_t>(slot)];
    client.channel->socket().async_wait(
        udp::socket::wait_read, [this, slot, generation](const boost::system::error_code& error) {
          // The socket may have gone, or another client taken the place, while this was due.
          if (error || !is_connected(slot, generation)) return;
          receive_from(slot);
          listen_to(slot, generation);
        });
  }

  bool is_connected(Slot slot, int generation) {
    const Client& client = clients_[static_cast<std::size_t>(slot)];
    const Session* session = match_.session(slot);
    return client.generation == generation && session != nullptr &&
           session->channel.get() == client.channel;
  }

  void receive_from(Slot slot) {
    UdpChannel& channel = *clients_[static_cast<std::size_t>(slot)].channel;
    Datagram datagram;
    while (channel.receive(datagram)) {
      match_.receive(slot, datagram.text, datagram.null_terminated);
    }
    if (channel.gone()) match_.lose(slot);
  }

  Session* session_of(const udp::endpoint& sender) {
    for (Slot slot = 0; slot < soccer::kPlayersOnPitch; ++slot) {
      const Client& client = clients_[static_cast<std::size_t>(slot)];
      if (client.address == sender && is_connected(slot, client.generation)) {
        return match_.session(slot);
      }
    }
    return nullptr;
  }

  struct Client {
    udp::endpoint address;
    UdpChannel* channel = nullptr;  ///< valid while is_connected()
    int generation = 0;
  };

  MatchServer& match_;
  asio::io_context io_;
  udp::socket door_;
  asio::ip::address address_;
  std::array<Client, soccer::kPlayersOnPitch> clients_;
  std::array<char, kBufferSize> buffer_;
};

soccer::Result<std::unique_ptr<UdpServer>> UdpServer::open(UdpConfig config) {
  config.match.server.synch_mode = true;
  auto match = MatchServer::create(config.match);
  if (!match) return match.error();
  std::unique_ptr<UdpServer> server(new UdpServer(std::move(config), std::move(*match)));
  const auto opened = server->network_->open(server->config_.address, server->config_.port);
  if (!opened) return opened.error();
  return server;
}

UdpServer::UdpServer(UdpConfig config, std::unique_ptr<MatchServer> match)
    : config_(std::move(config)),
      match_(std::move(match)),
      network_(std::make_unique<Network>(*match_)) {}

// Sessions own sockets that belong to the network's context: they go first.
UdpServer::~UdpServer() { match_->disconnect_all(); }

int UdpServer::port() const { return network_->port(); }

void UdpServer::record(gamelog::ByteSink* game_log, gamelog::ByteSink* text_log) {
  match_->record(game_log, text_log);
}

std::int64_t UdpServer::missed_cycles() const { return missed_cycles_; }

const World& UdpServer::world() const { return match_->world(); }

UdpEnd UdpServer::run(const std::atomic<bool>& stop) {
  UdpEnd end = UdpEnd::kStopped;
  int cycles_over = 0;
  while (!stop.load()) {
    if (!run_cycle()) {
      end = UdpEnd::kUnanswered;
      break;
    }
    if (!match_->finished()) continue;
    const bool all_left = match_->connected() == 0;
    const bool time_over = world().mode == PlayMode::kTimeOver;
    if (!time_over || all_left || ++cycles_over > world().params().game_over_wait) {
      end = UdpEnd::kFinished;
      break;
    }
  }
  match_->finish();
  return end;
}

bool UdpServer::run_cycle() {
  match_->step();
  match_->sense();
  const bool started = world().clock.time > 0;
  if (!started) network_->receive_until(WallClock::now() + config_.pause_before_start, false);
  match_->think();
  network_->receive_until(WallClock::now() + config_.max_wait, true);
  if (match_->awaits_anybody()) {
    ++missed_cycles_;
    if (started) ++missed_in_a_row_;
    if (started) tell(UdpNotice::Kind::kMissedCycle, kNobody);
  } else {
    missed_in_a_row_ = 0;
  }
  tell_connections();
  match_->execute();
  tell_connections();
  return missed_in_a_row_ <= config_.max_missed;
}

// Looked at before and after the commands of a cycle, when the lost ones go.
void UdpServer::tell_connections() {
  for (Slot slot = 0; slot < soccer::kPlayersOnPitch; ++slot) {
    const Session*& told = told_[static_cast<std::size_t>(slot)];
    const Session* now = match_->session(slot);
    if (now == told) continue;
    if (now == nullptr) tell(UdpNotice::Kind::kDisconnected, slot);
    if (now != nullptr) tell(UdpNotice::Kind::kConnected, slot, now->version);
    told = now;
  }
}

}  // namespace cls::simulator

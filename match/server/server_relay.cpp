// One epoll loop for the sockets of all clients of a side.
#include "match/server/server_relay.h"

#include <fmt/format.h>
#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "base/index.h"
#include "base/system/time_slice.h"
#include "match/server/client_binding.h"

namespace cls::match {
namespace {

using base::SocketAddress;
using base::UdpSocket;

// Of a team's 11 players and its coach some are started twice, or connect again.
constexpr std::size_t kMaxClients = 64;
constexpr int kReceiveBuffer = 1 << 20;  // bytes; as agents of cls have
// Of the thread: server and clients wait for each other's datagrams, and have more to do than it.
constexpr std::chrono::microseconds kTimeSlice{100};

// A full buffer loses a datagram, as networks do.
bool is_gone(int error) { return error != 0 && error != EAGAIN && error != ENOBUFS; }

// The server reads a request up to its first NUL.
std::string_view request_in(std::string_view bytes) { return bytes.substr(0, bytes.find('\0')); }

}  // namespace

class ServerRelay::Traffic {
 public:
  Traffic(RelayRoute route, ClaimedNames& names)
      : route_(std::move(route)),
        names_(names),
        lines_({}, std::nullopt),
        epoll_(::epoll_create1(EPOLL_CLOEXEC)),
        wake_(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {}

  ~Traffic() {
    if (!thread_.joinable()) return;
    const std::uint64_t one = 1;
    [[maybe_unused]] const ssize_t written = ::write(wake_.get(), &one, sizeof one);
    thread_.join();
  }

  Traffic(const Traffic&) = delete;
  Traffic& operator=(const Traffic&) = delete;

  base::Result<void> start() {
    if (!watch(wake_.get(), kStop)) return base::Error{std::strerror(errno)};
    TRY(enter(0, RelayedPort::kPlayers, route_.players, route_.server_players));
    TRY(enter(1, RelayedPort::kCoaches, route_.coaches, route_.server_coaches));
    thread_ = std::thread([this] { run(); });
    return {};
  }

  std::optional<UdpSocket> hand_over(const SocketAddress& sender) {
    const std::scoped_lock lock(clients_mutex_);
    for (auto& [id, client] : clients_) {
      if (client.outside.local_port() != sender.port()) continue;
      // Another host may have a socket with that port.
      if (!sender.same_host(client.entrance->server)) return std::nullopt;
      if (!client.expects_port || !client.gets_own_port) return std::nullopt;
      auto socket = open_port(client);
      if (!socket) return std::nullopt;
      client.expects_port = false;
      return *std::move(socket);
    }
    return std::nullopt;
  }

  std::vector<std::string> take_warnings() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(warnings_, {});
  }

 private:
  /// A port of the server in the network of the side.
  struct Entrance {
    RelayedPort port;
    SocketAddress local;
    SocketAddress server;
    UdpSocket socket;
  };

  /// A client of the side, known by the address from which it sends.
  struct Client {
    Entrance* entrance;
    SocketAddress address;
    UdpSocket outside;                ///< toward the server; unconnected, as those of agents of cls
    std::optional<UdpSocket> inside;  ///< toward the client, once the server has a port for it
    SocketAddress server_port;        ///< that port, with `inside`
    bool expects_port = true;         ///< the server may answer its last request from a new port
    bool gets_own_port = false;       ///< and takes commands at that port only
  };

  using Clients = std::map<std::uint32_t, Client>;

  // User data of epoll events: what is readable, and of which client.
  static constexpr std::uint64_t kStop = 0;
  static constexpr std::uint64_t kEntrance = std::uint64_t{1} << 32;
  static constexpr std::uint64_t kOutside = std::uint64_t{2} << 32;
  static constexpr std::uint64_t kInside = std::uint64_t{3} << 32;

  // Closing a socket removes it from the epoll instance.
  bool watch(int fd, std::uint64_t mark) {
    epoll_event event{};
    event.events = EPOLLIN;
    event.data.u64 = mark;
    return ::epoll_ctl(epoll_.get(), EPOLL_CTL_ADD, fd, &event) == 0;
  }

  base::Result<void> enter(std::size_t index, RelayedPort port, const SocketAddress& local,
                           const SocketAddress& server) {
    auto socket = route_.bind(local);
    if (!socket || !watch(socket->fd(), kEntrance | index)) {
      return base::Error{fmt::format("port {}: {}", local.port(),
                                     socket ? std::strerror(errno) : socket.error().message)};
    }
    entrances_[index].emplace(Entrance{port, local, server, *std::move(socket)});
    return {};
  }

  void run() {
    base::set_time_slice(kTimeSlice);
    std::array<epoll_event, 2 * kMaxClients + 4> ready;
    while (true) {
      const int count = ::epoll_wait(epoll_.get(), ready.data(), ready.size(), -1);
      for (int i = 0; i < count; ++i) {
        const std::uint64_t mark = ready[base::index(i)].data.u64;
        if (mark == kStop) return;
        handle(mark);
      }
    }
  }

  // One batch of datagrams: a client that floods delays the others by no more than that.
  void handle(std::uint64_t mark) {
    const std::scoped_lock lock(clients_mutex_);
    const std::uint64_t kind = mark & ~std::uint64_t{UINT32_MAX};
    const auto id = static_cast<std::uint32_t>(mark);
    if (kind == kEntrance) return receive_requests(*entrances_[id]);

    const auto client = clients_.find(id);
    if (client == clients_.end()) return;
    const bool open = kind == kInside ? pass_to_server(client->second) : pass_to_client(*client);
    // Its sockets are closed on both sides, as a port is whose program has ended.
    if (!open) clients_.erase(client);
  }

  void receive_requests(Entrance& entrance) {
    requests_.receive(entrance.socket);
    for (std::size_t i = 0; i < requests_.size(); ++i) {
      handle_request(entrance, requests_.sender(i), requests_.bytes(i));
    }
  }

  void handle_request(Entrance& entrance, const SocketAddress& sender, std::string_view bytes) {
    const std::string_view request = request_in(bytes);
    const auto refusal = refusal_of(entrance.port, request, route_.side, names_);
    auto client = find(entrance, sender);
    // Clients of old versions of the protocol send all commands to the first port.
    const bool command = refusal && !refusal->connection && client != clients_.end();
    if (refusal && !command) return refuse(entrance, sender, request, *refusal);

    if (client == clients_.end()) client = add(entrance, sender);
    if (client == clients_.end()) return;
    if (!refusal) {
      client->second.expects_port = true;
      client->second.gets_own_port = gets_own_port(entrance.port, request);
    }
    const std::string_view passed = bytes.substr(0, request.size() + 1);
    if (is_gone(client->second.outside.send(passed, false, &entrance.server))) {
      clients_.erase(client);
    }
  }

  void refuse(Entrance& entrance, const SocketAddress& sender, std::string_view request,
              const Refusal& refusal) {
    std::string reply;
    soccer::format(refusal.reply, reply);
    entrance.socket.send(reply, true, &sender);
    if (!refusal.intrusion) return;
    if (auto line = lines_.intrusion_line(route_.side, sender, request)) {
      const std::scoped_lock lock(mutex_);
      warnings_.push_back(*std::move(line));
    }
  }

  Clients::iterator find(const Entrance& entrance, const SocketAddress& sender) {
    auto client = clients_.begin();
    while (client != clients_.end() &&
           !(client->second.entrance == &entrance && client->second.address == sender)) {
      ++client;
    }
    return client;
  }

  // The end if there are too many clients.
  Clients::iterator add(Entrance& entrance, const SocketAddress& sender) {
    if (clients_.size() >= kMaxClients && !make_room()) return clients_.end();
    auto socket = UdpSocket::open(entrance.server.family());
    const std::uint32_t id = next_id_++;
    if (!socket || !watch(socket->fd(), kOutside | id)) return clients_.end();
    socket->set_receive_buffer(kReceiveBuffer);
    socket->report_errors(true);

    Client client{&entrance, sender, *std::move(socket), std::nullopt, {}};
    return clients_.emplace(id, std::move(client)).first;
  }

  // Forgets the oldest client that the server has not accepted.
  bool make_room() {
    for (auto client = clients_.begin(); client != clients_.end(); ++client) {
      if (client->second.inside) continue;
      clients_.erase(client);
      return true;
    }
    return false;
  }

  // False: the server has closed its port, or the client. One datagram: there are seldom more.
  bool pass_to_server(Client& client) {
    const int error = receive(*client.inside);
    if (error != 0) return !is_gone(error);
    return !is_gone(client.outside.send(datagram(), false, &client.server_port));
  }

  // The same.
  bool pass_to_client(Clients::value_type& entry) {
    auto& [id, client] = entry;
    const int error = receive(client.outside);
    if (error != 0) return !is_gone(error);
    if (!sender_.same_host(client.entrance->server)) return true;
    if (sender_.port() == client.entrance->server.port()) {
      client.entrance->socket.send(datagram(), false, &client.address);
      return true;
    }
    if (!is_port_of(client, sender_) && !open_port(id, client, sender_)) return true;
    return client.inside->send(datagram(), false) != ECONNREFUSED;
  }

  int receive(UdpSocket& socket) { return socket.receive(buffer_, size_, sender_); }
  std::string_view datagram() const { return {buffer_.data(), size_}; }

  static bool is_port_of(const Client& client, const SocketAddress& sender) {
    return client.inside && client.server_port.port() == sender.port();
  }

  std::optional<UdpSocket> open_port(const Client& client) const {
    SocketAddress local = client.entrance->local;
    local.set_port(0);
    auto socket = route_.bind(local);
    if (!socket || !socket->connect(client.address)) return std::nullopt;
    socket->set_receive_buffer(kReceiveBuffer);
    return *std::move(socket);
  }

  // The server has accepted the client: from now on it has a port of its own, here and there.
  bool open_port(std::uint32_t id, Client& client, const SocketAddress& sender) {
    if (!client.expects_port) return false;
    auto socket = open_port(client);
    if (!socket || !watch(socket->fd(), kInside | id)) return false;

    client.inside = *std::move(socket);
    client.server_port = sender;
    client.expects_port = false;
    return true;
  }

  RelayRoute route_;
  ClaimedNames& names_;
  ClientBinding lines_;
  base::UniqueFd epoll_;
  base::UniqueFd wake_;
  std::array<std::optional<Entrance>, 2> entrances_;
  std::mutex clients_mutex_;  ///< of them, their sockets, and route_
  Clients clients_;
  std::uint32_t next_id_ = 0;
  base::IncomingDatagrams requests_;
  std::array<char, base::IncomingDatagrams::kMaxBytes> buffer_;
  std::size_t size_ = 0;  ///< of the datagram in the buffer
  SocketAddress sender_;
  std::mutex mutex_;
  std::vector<std::string> warnings_;
  std::thread thread_;
};

ServerRelay::ServerRelay(std::unique_ptr<Traffic> traffic) : traffic_(std::move(traffic)) {}

ServerRelay::~ServerRelay() = default;

base::Result<std::unique_ptr<ServerRelay>> ServerRelay::create(RelayRoute route,
                                                               ClaimedNames& names) {
  auto traffic = std::make_unique<Traffic>(std::move(route), names);
  TRY(traffic->start());
  return std::unique_ptr<ServerRelay>(new ServerRelay(std::move(traffic)));
}

std::optional<base::UdpSocket> ServerRelay::hand_over(const base::SocketAddress& sender) {
  return traffic_->hand_over(sender);
}

std::vector<std::string> ServerRelay::take_warnings() { return traffic_->take_warnings(); }

}  // namespace cls::match

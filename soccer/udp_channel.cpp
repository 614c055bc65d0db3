// Client sockets, and the thread that reads them.
#include "soccer/udp_channel.h"

#include <poll.h>
#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "base/system/udp_socket.h"

namespace cls::soccer {
namespace {

using Time = std::chrono::steady_clock::time_point;

constexpr std::size_t kBufferSize = 8192;    // server messages are never longer
constexpr int kReceiveBuffer = 1 << 20;      // bytes; enough for a team that stalls for seconds
constexpr std::size_t kMaxWaiting = 10'000;  // messages; the client has stopped reading

struct Message {
  std::string text;
  Time received_at;
};

/// One client's connection to the server. Used by one thread at a time, apart from `gone`.
class Connection {
 public:
  Connection(base::UdpSocket socket, const base::SocketAddress& server)
      : server_(server), socket_(std::move(socket)) {
    socket_.set_receive_buffer(kReceiveBuffer);
    socket_.report_errors(true);
  }

  int fd() const { return socket_.fd(); }
  bool gone() const { return gone_.load(); }

  /// A full buffer loses the datagram, as networks do; only a closed port ends the connection.
  bool send(std::string_view message) {
    if (gone()) return false;
    if (socket_.send(message, true, has_own_port_ ? &own_port_ : &server_) == ECONNREFUSED) {
      gone_ = true;
    }

    return !gone();
  }

  /// The view is valid until the next call.
  bool receive(std::string_view& text) {
    while (!gone()) {
      base::SocketAddress sender;
      std::size_t size = 0;

      if (const int error = socket_.receive(buffer_, size, sender); error != 0) {
        if (error == ECONNREFUSED) gone_ = true;
        return false;
      }
      if (has_own_port_ ? !(sender == own_port_) : !sender.same_host(server_)) continue;
      if (!has_own_port_ && sender.port() != server_.port()) {
        own_port_ = sender;
        has_own_port_ = true;
      }
      text = std::string_view(buffer_.data(), size);
      if (text.ends_with('\0')) text.remove_suffix(1);
      return true;
    }

    return false;
  }

 private:
  // The socket stays unconnected, and so bound to all addresses: a connected one is bound to a
  // single one, and another program of the host could have its port on another address, and send
  // in its name (IP_PKTINFO).
  base::SocketAddress server_;
  base::SocketAddress own_port_;  ///< the server's port of this client
  base::UdpSocket socket_;
  std::atomic<bool> has_own_port_{false};
  std::atomic<bool> gone_{false};
  std::array<char, kBufferSize> buffer_;
};

}  // namespace

struct UdpClients::Sockets {
  struct Client {
    Client(base::UdpSocket socket, const base::SocketAddress& server)
        : connection(std::move(socket), server) {}
    Connection connection;
    bool readable = true;         // without the thread: may have a message
    std::deque<Message> waiting;  // filled by the thread; guarded by `mutex`
  };
  class ClientChannel;

  explicit Sockets(const base::SocketAddress& to)
      : server(to), ready(::epoll_create1(EPOLL_CLOEXEC)) {}
  ~Sockets() { stop(); }

  bool has_thread() const { return static_cast<bool>(wake); }

  void start() {
    wake = base::UniqueFd(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC));
    thread = std::thread([this] { read_all(); });
  }

  void stop() {
    if (!thread.joinable()) return;

    stopping = true;
    wake_up();
    thread.join();  // `wake` stays open, so that has_thread() remains true
  }

  void wake_up() const {
    const std::uint64_t one = 1;
    [[maybe_unused]] const ssize_t written = ::write(wake.get(), &one, sizeof one);
  }

  // The open connections, and their entries for poll().
  std::vector<std::shared_ptr<Client>> collect(std::vector<pollfd>& polled) {
    std::vector<std::shared_ptr<Client>> open;
    const std::lock_guard lock(mutex);

    for (const std::weak_ptr<Client>& each : clients) {
      std::shared_ptr<Client> client = each.lock();
      if (client == nullptr || client->connection.gone()) continue;
      polled.push_back({client->connection.fd(), POLLIN, 0});
      open.push_back(std::move(client));
    }

    return open;
  }

  void read_all() {
    std::vector<pollfd> polled;
    while (!stopping) {
      polled.assign(1, {wake.get(), POLLIN, 0});
      const auto open = collect(polled);
      if (::poll(polled.data(), polled.size(), -1) < 0 && errno != EINTR) return;

      std::uint64_t wakeups = 0;
      [[maybe_unused]] const ssize_t taken = ::read(wake.get(), &wakeups, sizeof wakeups);

      for (std::size_t i = 0; i < open.size(); ++i) {
        if (polled[i + 1].revents != 0) read(*open[i]);
      }
    }
  }

  void read(Client& client) {
    std::string_view text;
    bool changed = false;
    while (client.connection.receive(text)) {
      const Time now = std::chrono::steady_clock::now();
      const std::lock_guard lock(mutex);
      if (client.waiting.size() < kMaxWaiting) client.waiting.push_back({std::string(text), now});
      changed = true;
    }

    if (!changed && !client.connection.gone()) return;
    {
      const std::lock_guard lock(mutex);
      ++arrivals;
    }

    arrived.notify_one();
  }

  bool wait_for_thread(Time deadline) {
    std::unique_lock lock(mutex);

    const bool arrived_in_time =
        arrived.wait_until(lock, deadline, [this] { return arrivals != reported; });

    reported = arrivals;
    return arrived_in_time;
  }

  // Adds a client to those that wait_for_sockets() waits for.
  bool add(Client& client) const {
    epoll_event event{EPOLLIN, {&client}};
    return ::epoll_ctl(ready.get(), EPOLL_CTL_ADD, client.connection.fd(), &event) == 0;
  }
  void remove(const Client& client) const {
    ::epoll_ctl(ready.get(), EPOLL_CTL_DEL, client.connection.fd(), nullptr);
  }

  // Marks the clients with a message or an error; false when there are none.
  bool mark_readable() const {
    std::array<epoll_event, 32> events;
    const int count = ::epoll_wait(ready.get(), events.data(), static_cast<int>(events.size()), 0);
    bool any = false;

    for (int i = 0; i < count; ++i) {
      auto& client = *static_cast<Client*>(events[static_cast<std::size_t>(i)].data.ptr);
      if (client.connection.gone()) {
        remove(client);
      } else {
        client.readable = any = true;
      }
    }

    return any;
  }

  bool wait_for_sockets(Time deadline) const {
    if (mark_readable()) return true;

    const auto left = deadline - std::chrono::steady_clock::now();
    if (left <= Time::duration::zero()) return false;

    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(left);
    const timespec limit{static_cast<time_t>(seconds.count()),
                         static_cast<long>(std::chrono::nanoseconds(left - seconds).count())};

    pollfd polled{ready.get(), POLLIN, 0};
    return ::ppoll(&polled, 1, &limit, nullptr) > 0 && mark_readable();
  }

  const base::SocketAddress server;
  std::mutex mutex;
  std::condition_variable arrived;
  std::vector<std::weak_ptr<Client>> clients;
  std::uint64_t arrivals = 0;
  std::uint64_t reported = 0;
  std::atomic<bool> stopping{false};
  base::UniqueFd ready;  // epoll, of all clients
  base::UniqueFd wake;
  std::thread thread;
};

class UdpClients::Sockets::ClientChannel : public Channel {
 public:
  ClientChannel(std::shared_ptr<Sockets> sockets, std::shared_ptr<Client> client)
      : sockets_(std::move(sockets)), client_(std::move(client)) {}
  ClientChannel(const ClientChannel&) = delete;
  ClientChannel& operator=(const ClientChannel&) = delete;
  ~ClientChannel() override { sockets_->remove(*client_); }

  bool send(std::string_view message) override { return client_->connection.send(message); }

  bool receive(std::string& message) override {
    if (!sockets_->has_thread()) {
      std::string_view text;
      if (!client_->readable) return false;
      client_->readable = client_->connection.receive(text);
      if (!client_->readable) return false;
      message = text;
      received_at_ = std::chrono::steady_clock::now();
      return true;
    }

    const std::lock_guard lock(sockets_->mutex);
    if (client_->waiting.empty()) return false;

    message.swap(client_->waiting.front().text);
    received_at_ = client_->waiting.front().received_at;
    client_->waiting.pop_front();

    return true;
  }

  Time received_at() const override { return received_at_; }

 private:
  std::shared_ptr<Sockets> sockets_;
  std::shared_ptr<Client> client_;
  Time received_at_;
};

base::Result<std::unique_ptr<UdpClients>> UdpClients::create(const std::string& host, int port) {
  const base::Result<base::SocketAddress> server = base::resolve_udp(host, port);
  if (!server) return base::Error{"soccer server host '" + host + "': " + server.error().message};

  auto clients = of(*server);
  if (clients == nullptr) return base::Error{"no file descriptor left for connections"};
  return clients;
}

std::unique_ptr<UdpClients> UdpClients::of(const base::SocketAddress& server) {
  auto sockets = std::make_shared<Sockets>(server);
  if (!sockets->ready) return nullptr;
  return std::unique_ptr<UdpClients>(new UdpClients(std::move(sockets)));
}

std::unique_ptr<UdpClients> UdpClients::beside() const { return of(sockets_->server); }

UdpClients::UdpClients(std::shared_ptr<Sockets> sockets) : sockets_(std::move(sockets)) {}

UdpClients::~UdpClients() { sockets_->stop(); }

void UdpClients::read_on_thread() {
  if (!sockets_->has_thread()) sockets_->start();
}

std::unique_ptr<Channel> UdpClients::connect(int port) {
  base::SocketAddress server = sockets_->server;
  if (port != 0) server.set_port(port);

  auto socket = base::UdpSocket::open(server.family());
  if (!socket) return nullptr;

  auto client = std::make_shared<Sockets::Client>(*std::move(socket), server);
  if (!sockets_->add(*client)) return nullptr;

  {
    const std::lock_guard lock(sockets_->mutex);
    std::erase_if(sockets_->clients, [](const auto& other) { return other.expired(); });
    sockets_->clients.push_back(client);
  }

  if (sockets_->has_thread()) sockets_->wake_up();
  return std::make_unique<Sockets::ClientChannel>(sockets_, std::move(client));
}

bool UdpClients::wait_until(std::chrono::steady_clock::time_point deadline) {
  return sockets_->has_thread() ? sockets_->wait_for_thread(deadline)
                                : sockets_->wait_for_sockets(deadline);
}

}  // namespace cls::soccer

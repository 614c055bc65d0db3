// Sockets, and the thread that reads them.
#include "soccer/udp_channel.h"

#include <netinet/in.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <sys/uio.h>
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

#include "base/system/udp_address.h"

namespace cls::soccer {
namespace {

using Time = std::chrono::steady_clock::time_point;

constexpr std::size_t kBufferSize = 8192;     // the server's messages are never longer
constexpr int kReceiveBuffer = 1 << 20;       // a team that is slow for seconds loses nothing
constexpr std::size_t kMostWaiting = 10'000;  // beyond that nobody reads any more

struct Message {
  std::string text;
  Time arrived;
};

/// One client's socket. Used by one thread at a time, apart from `gone`.
class Socket {
 public:
  explicit Socket(const base::UdpAddress& server)
      : server_(server),
        fd_(::socket(server.bytes.ss_family, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)) {
    if (fd_ < 0) return;
    ::setsockopt(fd_, SOL_SOCKET, SO_RCVBUF, &kReceiveBuffer, sizeof kReceiveBuffer);
    report_errors(1);
  }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;
  ~Socket() {
    if (fd_ >= 0) ::close(fd_);
  }

  int fd() const { return fd_; }
  bool gone() const { return gone_.load(); }

  bool send(std::string_view message) {
    if (gone()) return false;
    char nul = '\0';
    std::array<iovec, 2> parts = {iovec{const_cast<char*>(message.data()), message.size()},
                                  iovec{&nul, 1}};
    msghdr header{};
    header.msg_iov = parts.data();
    header.msg_iovlen = parts.size();
    if (!has_own_port_) {
      header.msg_name = server_.get();
      header.msg_namelen = server_.size;
    }
    // A full buffer loses a datagram, as networks do; only a closed port is the end.
    if (::sendmsg(fd_, &header, 0) < 0 && errno == ECONNREFUSED) gone_ = true;
    return !gone();
  }

  /// The view holds until the next call.
  bool receive(std::string_view& text) {
    while (!gone()) {
      base::UdpAddress from;
      const ssize_t size =
          ::recvfrom(fd_, buffer_.data(), buffer_.size(), 0, from.get(), &from.size);
      if (size < 0) {
        if (errno == EINTR) continue;
        if (errno == ECONNREFUSED) gone_ = true;
        return false;
      }
      if (!has_own_port_ && !from.same_host(server_)) continue;
      if (!has_own_port_ && from.port() != server_.port()) stay_with(from);
      text = std::string_view(buffer_.data(), static_cast<std::size_t>(size));
      if (text.ends_with('\0')) text.remove_suffix(1);
      return true;
    }
    return false;
  }

 private:
  // A socket that is not connected hears of a closed port only on demand.
  void report_errors(int on) const {
    if (server_.bytes.ss_family == AF_INET6) {
      ::setsockopt(fd_, IPPROTO_IPV6, IPV6_RECVERR, &on, sizeof on);
    } else {
      ::setsockopt(fd_, IPPROTO_IP, IP_RECVERR, &on, sizeof on);
    }
  }

  void stay_with(const base::UdpAddress& port) {
    if (::connect(fd_, port.get(), port.size) != 0) return;
    has_own_port_ = true;
    report_errors(0);
  }

  base::UdpAddress server_;
  int fd_;
  std::atomic<bool> has_own_port_{false};
  std::atomic<bool> gone_{false};
  std::array<char, kBufferSize> buffer_;
};

}  // namespace

struct UdpClients::Sockets {
  struct Line {
    explicit Line(const base::UdpAddress& server) : socket(server) {}
    Socket socket;
    std::deque<Message> waiting;  // filled by the thread; under `mutex`
  };
  class LineChannel;

  explicit Sockets(const base::UdpAddress& to) : server(to) {}
  ~Sockets() { stop(); }

  bool has_thread() const { return wake >= 0; }

  void start() {
    wake = ::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC);
    thread = std::thread([this] { read_all(); });
  }

  void stop() {
    if (!thread.joinable()) return;
    stopping = true;
    nudge();
    thread.join();
    ::close(wake);
  }

  void nudge() const {
    const std::uint64_t one = 1;
    [[maybe_unused]] const ssize_t written = ::write(wake, &one, sizeof one);
  }

  // The lines that can still receive, and what poll needs of them.
  std::vector<std::shared_ptr<Line>> collect(std::vector<pollfd>& polled) {
    std::vector<std::shared_ptr<Line>> open;
    const std::lock_guard lock(mutex);
    lines.erase(
        std::remove_if(lines.begin(), lines.end(), [](const auto& line) { return line.expired(); }),
        lines.end());
    for (const std::weak_ptr<Line>& each : lines) {
      std::shared_ptr<Line> line = each.lock();
      if (line == nullptr || line->socket.gone()) continue;
      polled.push_back({line->socket.fd(), POLLIN, 0});
      open.push_back(std::move(line));
    }
    return open;
  }

  void read_all() {
    std::vector<pollfd> polled;
    while (!stopping) {
      polled.assign(1, {wake, POLLIN, 0});
      const auto open = collect(polled);
      if (::poll(polled.data(), polled.size(), -1) < 0 && errno != EINTR) return;
      std::uint64_t nudges = 0;
      [[maybe_unused]] const ssize_t taken = ::read(wake, &nudges, sizeof nudges);
      for (std::size_t i = 0; i < open.size(); ++i) {
        if (polled[i + 1].revents != 0) read(*open[i]);
      }
    }
  }

  void read(Line& line) {
    std::string_view text;
    bool news = false;
    while (line.socket.receive(text)) {
      const Time now = std::chrono::steady_clock::now();
      const std::lock_guard lock(mutex);
      if (line.waiting.size() < kMostWaiting) line.waiting.push_back({std::string(text), now});
      news = true;
    }
    if (!news && !line.socket.gone()) return;
    {
      const std::lock_guard lock(mutex);
      ++arrivals;
    }
    arrived.notify_one();
  }

  bool wait_for_thread(Time deadline) {
    std::unique_lock lock(mutex);
    const bool news = arrived.wait_until(lock, deadline, [this] { return arrivals != reported; });
    reported = arrivals;
    return news;
  }

  bool wait_for_sockets(Time deadline) {
    std::vector<pollfd> polled;
    const auto open = collect(polled);
    const auto left = std::max(deadline - std::chrono::steady_clock::now(), Time::duration::zero());
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(left);
    const timespec limit{static_cast<time_t>(seconds.count()),
                         static_cast<long>(std::chrono::nanoseconds(left - seconds).count())};
    return ::ppoll(polled.data(), polled.size(), &limit, nullptr) > 0;
  }

  const base::UdpAddress server;
  std::mutex mutex;
  std::condition_variable arrived;
  std::vector<std::weak_ptr<Line>> lines;
  std::uint64_t arrivals = 0;
  std::uint64_t reported = 0;
  std::atomic<bool> stopping{false};
  int wake = -1;
  std::thread thread;
};

class UdpClients::Sockets::LineChannel : public Channel {
 public:
  LineChannel(std::shared_ptr<Sockets> sockets, std::shared_ptr<Line> line)
      : sockets_(std::move(sockets)), line_(std::move(line)) {}

  bool send(std::string_view message) override { return line_->socket.send(message); }

  bool receive(std::string& message) override {
    if (!sockets_->has_thread()) {
      std::string_view text;
      if (!line_->socket.receive(text)) return false;
      message = text;
      arrived_ = std::chrono::steady_clock::now();
      return true;
    }
    const std::lock_guard lock(sockets_->mutex);
    if (line_->waiting.empty()) return false;
    message.swap(line_->waiting.front().text);
    arrived_ = line_->waiting.front().arrived;
    line_->waiting.pop_front();
    return true;
  }

  Time arrived() const override { return arrived_; }

 private:
  std::shared_ptr<Sockets> sockets_;
  std::shared_ptr<Line> line_;
  Time arrived_;
};

base::Result<std::unique_ptr<UdpClients>> UdpClients::create(const std::string& host, int port) {
  const base::Result<base::UdpAddress> server = base::find_address(host, port);
  if (!server) return base::Error{"soccer server host '" + host + "': " + server.error().message};
  return std::unique_ptr<UdpClients>(new UdpClients(std::make_shared<Sockets>(*server)));
}

UdpClients::UdpClients(std::shared_ptr<Sockets> sockets) : sockets_(std::move(sockets)) {}

UdpClients::~UdpClients() { sockets_->stop(); }

void UdpClients::read_on_thread() {
  if (!sockets_->has_thread()) sockets_->start();
}

std::unique_ptr<Channel> UdpClients::connect(int port) {
  base::UdpAddress server = sockets_->server;
  if (port != 0) server.set_port(port);
  auto line = std::make_shared<Sockets::Line>(server);
  if (line->socket.fd() < 0) return nullptr;
  {
    const std::lock_guard lock(sockets_->mutex);
    sockets_->lines.push_back(line);
  }
  if (sockets_->has_thread()) sockets_->nudge();
  return std::make_unique<Sockets::LineChannel>(sockets_, std::move(line));
}

bool UdpClients::wait_until(std::chrono::steady_clock::time_point deadline) {
  return sockets_->has_thread() ? sockets_->wait_for_thread(deadline)
                                : sockets_->wait_for_sockets(deadline);
}

}  // namespace cls::soccer

// Sockets around the match server.
#include "simulator/server/udp_network.h"

#include <poll.h>
#include <sys/epoll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <deque>
#include <utility>
#include <variant>
#include <vector>

#include "simulator/server/message_compression.h"
#include "simulator/server/udp_socket.h"

namespace cls::simulator {
namespace {

using base::UdpAddress;

/// Text as it came: without the closing NUL, and up to the first one.
struct Datagram {
  std::string_view text;
  bool null_terminated = false;
};

Datagram strip(std::string_view bytes) {
  const bool terminated = !bytes.empty() && bytes.back() == '\0';
  return {bytes.substr(0, bytes.find('\0')), terminated};
}

/// The server's end of one client: a socket of its own, connected to the client's. What is sent
/// waits for flush(): a client gets all that it is told in a cycle by one system call, and wakes up
/// once.
class UdpChannel : public soccer::Channel {
 public:
  /// `talkative` lists the channels with messages to flush.
  UdpChannel(UdpSocket socket, bool with_nul, std::vector<UdpChannel*>& talkative)
      : socket_(std::move(socket)), nul_(with_nul), talkative_(talkative) {}
  UdpChannel(const UdpChannel&) = delete;
  UdpChannel& operator=(const UdpChannel&) = delete;

  ~UdpChannel() override {
    talkative_.erase(std::remove(talkative_.begin(), talkative_.end(), this), talkative_.end());
    flush();
  }

  bool send(std::string_view message) override {
    if (gone_) return false;
    if (outgoing_.empty()) talkative_.push_back(this);
    if (compression_ == nullptr) {
      outgoing_.add(message, nul_);
      return true;
    }
    whole_ = message;
    if (nul_) whole_ += '\0';
    outgoing_.add(compression_->packed(whole_), false);
    return true;
  }

  void flush() {
    if (!outgoing_.send(socket_)) gone_ = true;
  }

  /// The network reads.
  bool receive(std::string&) override { return false; }

  /// What came in; holds until the next call.
  Datagram read(std::string_view bytes) {
    if (compression_ == nullptr) return strip(bytes);
    // What cannot be unpacked is an empty message: the client is told that it makes no sense.
    if (!compression_->unpack(bytes, IncomingDatagrams::kLongest, whole_)) whole_.clear();
    return strip(whole_);
  }

  bool can_compress() const override { return true; }
  void compress(int level) override {
    compression_ = level < 0 ? nullptr : std::make_unique<MessageCompression>(level);
  }

  const UdpSocket& socket() const { return socket_; }

 private:
  UdpSocket socket_;
  bool nul_;           ///< closes every message
  bool gone_ = false;  ///< the other side has closed its port
  OutgoingDatagrams outgoing_;
  std::vector<UdpChannel*>& talkative_;
  std::unique_ptr<MessageCompression> compression_;
  std::string whole_;
};

}  // namespace

class UdpNetwork::Sockets {
 public:
  explicit Sockets(MatchServer& match) : match_(match), epoll_(::epoll_create1(EPOLL_CLOEXEC)) {}
  Sockets(const Sockets&) = delete;
  Sockets& operator=(const Sockets&) = delete;
  ~Sockets() {
    if (epoll_ >= 0) ::close(epoll_);
  }

  base::Result<void> open(Door door, const std::string& address, int port) {
    const auto error = [&](const std::string& cause) {
      return base::Error{"cannot listen on " + address + " port " + std::to_string(port) + ": " +
                         cause};
    };
    const auto local = base::numeric_address(address, port);
    if (!local) return error(local.error().message);
    auto socket = UdpSocket::bound_to(*local);
    if (!socket) return error(socket.error().message);
    if (!watch(*socket, door_mark(doors_.size()))) return error(std::strerror(errno));
    doors_.push_back({door, *local, std::move(*socket)});
    return {};
  }

  int port(Door kind) const {
    for (const OpenDoor& door : doors_) {
      if (door.kind == kind) return door.socket.local_port();
    }
    return 0;
  }

  void poll(Time deadline) {
    while (handle_ready(0) && std::chrono::steady_clock::now() < deadline) {
    }
  }

  void receive_until(Time deadline, const std::function<bool()>& enough) {
    bool waits = !enough();
    do {
      if (waits) flush();
      handle_ready(waits ? wait(milliseconds_until(deadline)) : 0);
      waits = !enough();
    } while (waits && std::chrono::steady_clock::now() < deadline);
  }

  void flush() {
    for (UdpChannel* channel : talkative_) channel->flush();
    talkative_.clear();
  }

 private:
  struct OpenDoor {
    Door kind;
    UdpAddress address;
    UdpSocket socket;
  };

  struct Client {
    UdpAddress address;
    const OpenDoor* door = nullptr;
    UdpChannel* channel = nullptr;  ///< valid while is_connected()
    std::uint32_t generation = 0;
  };

  // What the system gives back with an event: a door, or a client and its generation.
  static constexpr std::uint64_t kDoorMark = std::uint64_t{1} << 63;
  static std::uint64_t door_mark(std::size_t index) { return kDoorMark | index; }
  static std::uint64_t client_mark(ClientId id, std::uint32_t generation) {
    return std::uint64_t{generation} << 16 | static_cast<std::uint64_t>(id);
  }

  // A socket leaves with its end.
  bool watch(const UdpSocket& socket, std::uint64_t mark) {
    epoll_event event{};
    event.events = EPOLLIN;
    event.data.u64 = mark;
    return ::epoll_ctl(epoll_, EPOLL_CTL_ADD, socket.fd(), &event) == 0;
  }

  static int milliseconds_until(Time deadline) {
    const auto left = deadline - std::chrono::steady_clock::now();
    return std::max(0,
                    static_cast<int>(std::chrono::ceil<std::chrono::milliseconds>(left).count()));
  }

  // Where the match waits for answers it sleeps until one of those who owe one has sent something,
  // the last that was asked: what the others have sent by then is taken in together. To wake up for
  // each would cost more than to read. Returns the time that is left to wait for anybody: none
  // then.
  int wait(int timeout_ms) {
    const UdpChannel* awaited = last_awaited();
    if (awaited == nullptr) return timeout_ms;
    pollfd socket{awaited->socket().fd(), POLLIN, 0};
    ::poll(&socket, 1, timeout_ms);
    return 0;
  }

  // Of the network's clients; null if none is awaited.
  const UdpChannel* last_awaited() {
    for (ClientId id = kFirstMonitor - 1; id >= 0; --id) {
      if (match_.awaits(id) && is_connected(id, client_at(id).generation)) {
        return client_at(id).channel;
      }
    }
    return nullptr;
  }

  // Everybody who has sent something has a turn: one read. What waits beyond is left for the next,
  // so that a flood delays nobody else. False if nobody has.
  bool handle_ready(int timeout_ms) {
    std::array<epoll_event, 128> ready;  // more than there can be clients and doors
    const int count = ::epoll_wait(epoll_, ready.data(), ready.size(), timeout_ms);
    for (int i = 0; i < count; ++i) {
      const std::uint64_t mark = ready[static_cast<std::size_t>(i)].data.u64;
      if ((mark & kDoorMark) != 0) {
        receive_at(doors_[mark & ~kDoorMark]);
      } else {
        receive_from(static_cast<ClientId>(mark & 0xffff), static_cast<std::uint32_t>(mark >> 16));
      }
    }
    return count > 0;
  }

  void receive_at(OpenDoor& door) {
    incoming_.receive(door.socket);
    for (std::size_t k = 0; k < incoming_.size(); ++k) {
      answer(door, strip(incoming_.bytes(k)), incoming_.sender(k));
    }
  }

  void answer(OpenDoor& door, const Datagram& datagram, const UdpAddress& sender) {
    std::string_view text = datagram.text;
    if (const Connection* known = connection_of(door, sender)) {
      return match_.receive_at_door(known->client, text, datagram.null_terminated);
    }
    if (text.ends_with('\n')) text.remove_suffix(1);
    const auto admission = match_.admit(door.kind, text);
    if (const auto* admitted = std::get_if<Admission>(&admission)) {
      welcome(door, *admitted, text, sender);
    } else {
      refuse(door, std::get<soccer::ErrorCode>(admission), sender);
    }
  }

  void welcome(OpenDoor& door, const Admission& admission, std::string_view request,
               const UdpAddress& sender) {
    Client& client = client_at(admission.client);
    UdpAddress local = door.address;
    local.set_port(0);
    auto socket = UdpSocket::bound_to(local);
    if (!socket || !socket->connect(sender) ||
        !watch(*socket, client_mark(admission.client, client.generation + 1))) {
      match_.withdraw(admission);
      return refuse(door, soccer::ErrorCode::kSocketOpenFailed, sender);
    }
    auto channel = std::make_unique<UdpChannel>(std::move(*socket), !admission.binary, talkative_);
    client = {sender, &door, channel.get(), client.generation + 1};
    match_.greet(admission, std::move(channel), request);
  }

  void refuse(OpenDoor& door, soccer::ErrorCode code, const UdpAddress& sender) {
    std::string refusal;
    soccer::format(code, refusal);
    door.socket.send_to(sender, {refusal.c_str(), refusal.size() + 1});
  }

  bool is_connected(ClientId id, std::uint32_t generation) {
    const Client& client = client_at(id);
    const Connection* connection = match_.connection(id);
    return client.generation == generation && connection != nullptr &&
           connection->channel.get() == client.channel;
  }

  // The socket may have gone, or another client taken the place, while an event was due.
  void receive_from(ClientId id, std::uint32_t generation) {
    if (!is_connected(id, generation)) return;
    UdpChannel& channel = *client_at(id).channel;
    if (incoming_.receive(channel.socket()) == ECONNREFUSED) return match_.lose(id);
    for (std::size_t k = 0; k < incoming_.size() && is_connected(id, generation); ++k) {
      const Datagram datagram = channel.read(incoming_.bytes(k));
      match_.receive(id, datagram.text, datagram.null_terminated);
    }
  }

  Connection* connection_of(const OpenDoor& door, const UdpAddress& sender) {
    for (std::size_t i = 0; i < clients_.size(); ++i) {
      const Client& client = clients_[i];
      const auto id = static_cast<ClientId>(i);
      if (client.door == &door && client.address == sender && is_connected(id, client.generation)) {
        return match_.connection(id);
      }
    }
    return nullptr;
  }

  Client& client_at(ClientId id) {
    const auto index = static_cast<std::size_t>(id);
    if (index >= clients_.size()) clients_.resize(index + 1);
    return clients_[index];
  }

  MatchServer& match_;
  int epoll_;
  std::deque<OpenDoor> doors_;  ///< whose places stay
  std::vector<Client> clients_;
  std::vector<UdpChannel*> talkative_;
  IncomingDatagrams incoming_;
};

UdpNetwork::UdpNetwork(MatchServer& match) : sockets_(std::make_unique<Sockets>(match)) {}
UdpNetwork::~UdpNetwork() = default;

base::Result<void> UdpNetwork::open(Door door, const std::string& address, int port) {
  return sockets_->open(door, address, port);
}

int UdpNetwork::port(Door door) const { return sockets_->port(door); }

void UdpNetwork::poll(Time deadline) { sockets_->poll(deadline); }

void UdpNetwork::receive_until(Time deadline, const std::function<bool()>& enough) {
  sockets_->receive_until(deadline, enough);
}

void UdpNetwork::flush() { sockets_->flush(); }

}  // namespace cls::simulator

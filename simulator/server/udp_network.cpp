// Implements UdpNetwork: listening sockets, one socket per client, one epoll instance.
#include "simulator/server/udp_network.h"

#include <poll.h>
#include <sys/epoll.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <deque>
#include <utility>
#include <variant>
#include <vector>

#include "base/index.h"
#include "base/system/udp_socket.h"
#include "simulator/server/message_compression.h"

namespace cls::simulator {
namespace {

using base::IncomingDatagrams;
using base::SocketAddress;
using base::UdpSocket;

/// Text of a datagram up to the first NUL.
struct Datagram {
  std::string_view text;
  bool null_terminated = false;
};

/// Stands for the datagrams of a client that floods the server: it is not waited for.
constexpr std::string_view kDoneCommand = "(done)";

Datagram strip_nul(std::string_view bytes) {
  const bool terminated = !bytes.empty() && bytes.back() == '\0';
  return {bytes.substr(0, bytes.find('\0')), terminated};
}

/// Channel to one client, with a socket of its own. Messages wait for flush(), so that a client
/// receives all messages of a cycle by one system call and wakes up once.
class UdpChannel : public soccer::Channel {
 public:
  /// Adds itself to `unflushed` while it has messages to send.
  UdpChannel(UdpSocket socket, bool with_nul, std::vector<UdpChannel*>& unflushed)
      : socket_(std::move(socket)), with_nul_(with_nul), unflushed_(unflushed) {}
  UdpChannel(const UdpChannel&) = delete;
  UdpChannel& operator=(const UdpChannel&) = delete;

  ~UdpChannel() override {
    std::erase(unflushed_, this);
    flush();
  }

  bool send(std::string_view message) override {
    if (closed_) return false;
    if (outgoing_.empty()) unflushed_.push_back(this);

    if (compression_ == nullptr) {
      outgoing_.add(message, with_nul_);
      return true;
    }

    buffer_ = message;
    if (with_nul_) buffer_ += '\0';
    outgoing_.add(compression_->compress(buffer_), false);
    return true;
  }

  void flush() {
    if (!outgoing_.send(socket_)) closed_ = true;
  }

  /// Unused: UdpNetwork receives.
  bool receive(std::string&) override { return false; }

  /// Decodes a received datagram; the text is valid until the next call.
  Datagram decode(std::string_view bytes) {
    if (compression_ == nullptr) return strip_nul(bytes);
    // A datagram that cannot be decompressed becomes an empty message, which is a syntax error.
    if (!compression_->decompress(bytes, IncomingDatagrams::kMaxBytes, buffer_)) buffer_.clear();
    return strip_nul(buffer_);
  }

  bool can_compress() const override { return true; }
  bool compresses() const { return compression_ != nullptr; }
  void compress(int level) override {
    compression_ = level < 0 ? nullptr : std::make_unique<MessageCompression>(level);
  }

  const UdpSocket& socket() const { return socket_; }

 private:
  UdpSocket socket_;
  bool with_nul_;        ///< appended to every message
  bool closed_ = false;  ///< the client has closed its port
  base::OutgoingDatagrams outgoing_;
  std::vector<UdpChannel*>& unflushed_;
  std::unique_ptr<MessageCompression> compression_;
  std::string buffer_;
};

/// Listening sockets, a socket per client, and one epoll instance.
class SocketNetwork : public UdpNetwork {
 public:
  explicit SocketNetwork(MatchServer& match)
      : match_(match), epoll_(::epoll_create1(EPOLL_CLOEXEC)) {}

  void bind_clients(RightsOf rights_of, OnIntrusion on_intrusion) override {
    rights_of_ = std::move(rights_of);
    on_intrusion_ = std::move(on_intrusion);
  }

  base::Result<void> open(ListeningPort role, const std::string& address, int port) override {
    return listen(role, address, port, nullptr);
  }

  base::Result<void> open_in(const OtherNetwork& network, ListeningPort role,
                             const std::string& address, int port) override {
    return listen(role, address, port, std::make_shared<OtherNetwork>(network));
  }

  int port(ListeningPort role) const override {
    for (const ListeningSocket& listening : listening_) {
      if (listening.role == role && listening.network == nullptr)
        return listening.socket.local_port();
    }
    return 0;
  }

  void poll(Time deadline) override {
    while (handle_ready(0) && std::chrono::steady_clock::now() < deadline) {
    }
  }

  void receive_until(Time deadline, const std::function<bool()>& enough) override {
    bool waits = !enough();
    do {
      if (waits) flush();
      handle_ready(waits ? wait(milliseconds_until(deadline)) : 0);
      waits = !enough();
    } while (waits && std::chrono::steady_clock::now() < deadline);
  }

  void flush() override {
    for (UdpChannel* channel : unflushed_) channel->flush();
    unflushed_.clear();
  }

 private:
  struct ListeningSocket {
    ListeningPort role;
    SocketAddress address;
    UdpSocket socket;
    std::shared_ptr<const OtherNetwork> network;  ///< null: that of this process
  };

  struct Client {
    SocketAddress address;
    const ListeningSocket* listening = nullptr;
    UdpChannel* channel = nullptr;  ///< valid while is_connected()
    std::uint32_t generation = 0;
  };

  base::Result<void> listen(ListeningPort role, const std::string& address, int port,
                            std::shared_ptr<const OtherNetwork> network) {
    const auto error = [&](const std::string& cause) {
      return base::Error{"cannot listen on " + address + " port " + std::to_string(port) + ": " +
                         cause};
    };

    const auto local = base::parse_ip_address(address, port);
    if (!local) return error(local.error().message);

    auto socket = bind(network.get(), *local);
    if (!socket) return error(socket.error().message);
    if (!watch(*socket, listening_mark(listening_.size()))) return error(std::strerror(errno));

    listening_.push_back({role, *local, std::move(*socket), std::move(network)});
    return {};
  }

  static base::Result<UdpSocket> bind(const OtherNetwork* network, const SocketAddress& local) {
    return network == nullptr ? UdpSocket::bind(local) : network->bind(local);
  }

  ClientRights rights_of(const ListeningSocket& listening, const SocketAddress& sender) const {
    if (listening.network != nullptr) return listening.network->rights;
    return rights_of_ ? rights_of_(sender) : ClientRights{};
  }

  // User data of epoll events: a listening socket, or a client and its generation.
  static constexpr std::uint64_t kListeningMark = std::uint64_t{1} << 63;
  static std::uint64_t listening_mark(std::size_t index) { return kListeningMark | index; }
  static std::uint64_t client_mark(ClientId id, std::uint32_t generation) {
    return std::uint64_t{generation} << 16 | static_cast<std::uint64_t>(id);
  }

  // Closing a socket removes it from the epoll instance.
  bool watch(const UdpSocket& socket, std::uint64_t mark) {
    epoll_event event{};
    event.events = EPOLLIN;
    event.data.u64 = mark;
    return ::epoll_ctl(epoll_.get(), EPOLL_CTL_ADD, socket.fd(), &event) == 0;
  }

  static int milliseconds_until(Time deadline) {
    const auto left = deadline - std::chrono::steady_clock::now();
    return std::max(0,
                    static_cast<int>(std::chrono::ceil<std::chrono::milliseconds>(left).count()));
  }

  // Sleeps until the last awaited client has sent a datagram, because waking up for each client
  // costs more than reading. Returns the remaining timeout in ms, 0 after sleeping. Before the
  // match clients join and await replies: each datagram wakes.
  int wait(int timeout_ms) {
    const UdpChannel* awaited = match_.world().clock.time > 0 ? last_awaited() : nullptr;
    if (awaited == nullptr) return timeout_ms;

    pollfd socket{awaited->socket().fd(), POLLIN, 0};
    ::poll(&socket, 1, timeout_ms);
    return 0;
  }

  // Null if no client on this network is awaited.
  const UdpChannel* last_awaited() {
    for (ClientId id = kFirstMonitor - 1; id >= 0; --id) {
      if (match_.awaits(id) && is_connected(id, client_at(id).generation)) {
        return client_at(id).channel;
      }
    }
    return nullptr;
  }

  // Reads once from each socket with data; the rest waits for the next call, so that a flood delays
  // no other client. Returns false if no socket had data.
  bool handle_ready(int timeout_ms) {
    std::array<epoll_event, 128> ready;  // exceeds the number of sockets
    const int count = ::epoll_wait(epoll_.get(), ready.data(), ready.size(), timeout_ms);
    for (int i = 0; i < count; ++i) {
      const std::uint64_t mark = ready[base::index(i)].data.u64;
      if ((mark & kListeningMark) != 0) {
        receive_requests(listening_[mark & ~kListeningMark]);
      } else {
        receive_commands(static_cast<ClientId>(mark & 0xffff),
                         static_cast<std::uint32_t>(mark >> 16));
      }
    }

    return count > 0;
  }

  // To find whose process a sender is takes milliseconds: a flood of requests gets a fifth of the
  // time, and the rest of it waits in the socket. A host that stalls meanwhile is not a flood: it
  // would keep a coach out for good.
  void receive_requests(ListeningSocket& listening) {
    constexpr int kRest = 4;
    constexpr std::chrono::steady_clock::duration kLongestRest = std::chrono::milliseconds(500);
    const auto begin = std::chrono::steady_clock::now();
    const bool looks_for_owners = listening.network == nullptr && rights_of_;
    if (looks_for_owners && begin < next_requests_) return;

    incoming_.receive(listening.socket);
    for (std::size_t k = 0; k < incoming_.size(); ++k) {
      handle_request(listening, strip_nul(incoming_.bytes(k)), incoming_.sender(k));
    }
    const auto end = std::chrono::steady_clock::now();
    if (looks_for_owners) next_requests_ = end + std::min(kRest * (end - begin), kLongestRest);
  }

  void handle_request(ListeningSocket& listening, const Datagram& datagram,
                      const SocketAddress& sender) {
    std::string_view text = datagram.text;
    if (const Connection* known = connection_of(listening, sender)) {
      return match_.receive_on_listening_port(known->client, text, datagram.null_terminated);
    }

    if (text.ends_with('\n')) text.remove_suffix(1);
    const AdmissionResult admission =
        match_.admit(listening.role, text, rights_of(listening, sender));
    if (const auto* admitted = std::get_if<Admission>(&admission)) {
      return accept(listening, *admitted, text, sender);
    }
    if (std::holds_alternative<Intrusion>(admission)) report_intrusion(listening, sender, text);
    refuse(listening, refusal(admission), sender);
  }

  void report_intrusion(const ListeningSocket& listening, const SocketAddress& sender,
                        std::string_view text) {
    if (listening.network != nullptr && listening.network->on_intrusion) {
      listening.network->on_intrusion(sender, text);
    } else if (on_intrusion_) {
      on_intrusion_(sender, text);
    }
  }

  void accept(ListeningSocket& listening, const Admission& admission, std::string_view request,
              const SocketAddress& sender) {
    Client& client = client_at(admission.client);
    SocketAddress local = listening.address;
    local.set_port(0);

    auto socket = bind(listening.network.get(), local);
    if (!socket || !socket->connect(sender) ||
        !watch(*socket, client_mark(admission.client, client.generation + 1))) {
      match_.cancel(admission);
      return refuse(listening, soccer::ErrorCode::kSocketOpenFailed, sender);
    }

    auto channel = std::make_unique<UdpChannel>(std::move(*socket), !admission.binary, unflushed_);
    client = {sender, &listening, channel.get(), client.generation + 1};
    match_.complete_handshake(admission, std::move(channel), request);
  }

  void refuse(ListeningSocket& listening, soccer::ErrorCode code, const SocketAddress& sender) {
    std::string refusal;
    soccer::format(code, refusal);
    listening.socket.send(refusal, true, &sender);
  }

  bool is_connected(ClientId id, std::uint32_t generation) {
    const Client& client = client_at(id);
    const Connection* connection = match_.connection(id);

    return client.generation == generation && connection != nullptr &&
           connection->channel.get() == client.channel;
  }

  // The client of a pending event may be disconnected, or its id reused, by now.
  void receive_commands(ClientId id, std::uint32_t generation) {
    if (!is_connected(id, generation)) return;

    UdpChannel& channel = *client_at(id).channel;
    if (incoming_.receive(channel.socket()) == ECONNREFUSED) return match_.mark_lost(id);

    for (std::size_t k = 0; k < incoming_.size() && is_connected(id, generation); ++k) {
      // Decompressing what will be dropped would take the time of other clients.
      if (channel.compresses() && match_.has_used_quota(id)) {
        match_.receive(id, kDoneCommand, false);
        continue;
      }

      const Datagram datagram = channel.decode(incoming_.bytes(k));
      match_.receive(id, datagram.text, datagram.null_terminated);
    }
  }

  Connection* connection_of(const ListeningSocket& listening, const SocketAddress& sender) {
    for (std::size_t i = 0; i < clients_.size(); ++i) {
      const Client& client = clients_[i];
      const auto id = static_cast<ClientId>(i);
      if (client.listening == &listening && client.address == sender &&
          is_connected(id, client.generation)) {
        return match_.connection(id);
      }
    }
    return nullptr;
  }

  Client& client_at(ClientId id) {
    const auto index = base::index(id);
    if (index >= clients_.size()) clients_.resize(index + 1);
    return clients_[index];
  }

  MatchServer& match_;
  RightsOf rights_of_;    ///< empty: any client may become anything
  Time next_requests_{};  ///< from senders whose rights it has to find
  OnIntrusion on_intrusion_;
  base::UniqueFd epoll_;
  std::deque<ListeningSocket> listening_;  ///< a deque keeps addresses stable
  std::vector<Client> clients_;
  std::vector<UdpChannel*> unflushed_;
  IncomingDatagrams incoming_;
};

}  // namespace

std::unique_ptr<UdpNetwork> make_udp_network(MatchServer& match) {
  return std::make_unique<SocketNetwork>(match);
}

}  // namespace cls::simulator

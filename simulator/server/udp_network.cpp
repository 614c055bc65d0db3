// Sockets around the match server.
#include "simulator/server/udp_network.h"

#include <array>
#include <boost/asio.hpp>
#include <deque>
#include <utility>
#include <variant>
#include <vector>

#include "simulator/server/message_compression.h"

namespace cls::simulator {
namespace {

namespace asio = boost::asio;
using asio::ip::udp;

constexpr std::size_t kBufferSize = 8192;

/// Of one client in one turn; what it sends beyond waits, so that a flood delays nobody else.
constexpr int kDatagramsInARow = 64;

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
  UdpChannel(udp::socket socket, bool with_nul) : socket_(std::move(socket)), nul_(with_nul) {}

  bool send(std::string_view message) override {
    boost::system::error_code error;
    if (compression_ != nullptr) {
      whole_ = message;
      if (nul_) whole_ += '\0';
      socket_.send(asio::buffer(compression_->packed(whole_)), 0, error);
      return !is_gone(error);
    }
    constexpr char kNul = '\0';
    const std::array<asio::const_buffer, 2> buffers = {asio::buffer(message),
                                                       asio::buffer(&kNul, nul_ ? 1 : 0)};
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
    std::string_view bytes(buffer_.data(), size);
    // What cannot be unpacked is an empty message: the client is told that it makes no sense.
    if (compression_ != nullptr) {
      if (!compression_->unpack(bytes, kBufferSize, whole_)) whole_.clear();
      bytes = whole_;
    }
    datagram = strip(bytes);
    return true;
  }

  bool can_compress() const override { return true; }
  void compress(int level) override {
    compression_ = level < 0 ? nullptr : std::make_unique<MessageCompression>(level);
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
  bool nul_;  ///< closes every message
  bool gone_ = false;
  std::unique_ptr<MessageCompression> compression_;
  std::string whole_;
  std::array<char, kBufferSize> buffer_;
};

}  // namespace

class UdpNetwork::Sockets {
 public:
  explicit Sockets(MatchServer& match) : match_(match) {}

  soccer::Result<void> open(Door door, const std::string& address, int port) {
    boost::system::error_code error;
    const auto ip = asio::ip::make_address(address, error);
    const udp::endpoint local(ip, static_cast<unsigned short>(port));
    udp::socket socket(io_);
    if (!error) socket.open(local.protocol(), error);
    if (!error) socket.bind(local, error);
    if (!error) socket.non_blocking(true, error);
    if (error) {
      return soccer::Error{"cannot listen on " + address + " port " + std::to_string(port) + ": " +
                           error.message()};
    }
    listen_at(doors_.emplace_back(OpenDoor{door, ip, std::move(socket)}));
    return {};
  }

  int port(Door kind) const {
    for (const OpenDoor& door : doors_) {
      if (door.kind == kind) return door.socket.local_endpoint().port();
    }
    return 0;
  }

  void poll(Time deadline) {
    while (io_.poll_one() > 0 && std::chrono::steady_clock::now() < deadline) {
    }
  }

  void receive_until(Time deadline, const std::function<bool()>& enough) {
    poll(deadline);
    while (!enough() && std::chrono::steady_clock::now() < deadline) io_.run_one_until(deadline);
  }

 private:
  struct OpenDoor {
    Door kind;
    asio::ip::address address;
    udp::socket socket;
  };

  struct Client {
    udp::endpoint address;
    const OpenDoor* door = nullptr;
    UdpChannel* channel = nullptr;  ///< valid while is_connected()
    int generation = 0;
  };

  void listen_at(OpenDoor& door) {
    door.socket.async_wait(udp::socket::wait_read,
                           [this, &door](const boost::system::error_code& error) {
                             if (error) return;
                             receive_at(door);
                             listen_at(door);
                           });
  }

  void receive_at(OpenDoor& door) {
    udp::endpoint sender;
    for (int i = 0; i < kDatagramsInARow;) {
      boost::system::error_code error;
      const std::size_t size = door.socket.receive_from(asio::buffer(buffer_), sender, 0, error);
      if (error == asio::error::connection_refused) continue;  // an answer that nobody wanted
      if (error) return;
      answer(door, strip({buffer_.data(), size}), sender);
      ++i;
    }
  }

  void answer(OpenDoor& door, const Datagram& datagram, const udp::endpoint& sender) {
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
               const udp::endpoint& sender) {
    boost::system::error_code error;
    udp::socket socket(io_);
    socket.open(sender.protocol(), error);
    if (!error) socket.bind(udp::endpoint(door.address, 0), error);
    if (!error) socket.connect(sender, error);
    if (!error) socket.non_blocking(true, error);
    if (error) {
      match_.withdraw(admission);
      refuse(door, soccer::ErrorCode::kSocketOpenFailed, sender);
      return;
    }
    auto channel = std::make_unique<UdpChannel>(std::move(socket), !admission.binary);
    Client& client = client_at(admission.client);
    client = {sender, &door, channel.get(), client.generation + 1};
    match_.greet(admission, std::move(channel), request);
    listen_to(admission.client, client.generation);
  }

  void refuse(OpenDoor& door, soccer::ErrorCode code, const udp::endpoint& sender) {
    std::string refusal;
    soccer::format(code, refusal);
    boost::system::error_code ignored;
    door.socket.send_to(asio::buffer(refusal.c_str(), refusal.size() + 1), sender, 0, ignored);
  }

  void listen_to(ClientId id, int generation) {
    client_at(id).channel->socket().async_wait(
        udp::socket::wait_read, [this, id, generation](const boost::system::error_code& error) {
          // The socket may have gone, or another client taken the place, while this was due.
          if (error || !is_connected(id, generation)) return;
          receive_from(id, generation);
          if (is_connected(id, generation)) listen_to(id, generation);
        });
  }

  bool is_connected(ClientId id, int generation) {
    const Client& client = client_at(id);
    const Connection* connection = match_.connection(id);
    return client.generation == generation && connection != nullptr &&
           connection->channel.get() == client.channel;
  }

  void receive_from(ClientId id, int generation) {
    Datagram datagram;
    for (int i = 0; i < kDatagramsInARow && is_connected(id, generation); ++i) {
      UdpChannel& channel = *client_at(id).channel;
      if (!channel.receive(datagram)) {
        if (channel.gone()) match_.lose(id);
        return;
      }
      match_.receive(id, datagram.text, datagram.null_terminated);
    }
  }

  Connection* connection_of(const OpenDoor& door, const udp::endpoint& sender) {
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
  asio::io_context io_;
  std::deque<OpenDoor> doors_;  ///< whose places stay
  std::vector<Client> clients_;
  std::array<char, kBufferSize> buffer_;
};

UdpNetwork::UdpNetwork(MatchServer& match) : sockets_(std::make_unique<Sockets>(match)) {}
UdpNetwork::~UdpNetwork() = default;

soccer::Result<void> UdpNetwork::open(Door door, const std::string& address, int port) {
  return sockets_->open(door, address, port);
}

int UdpNetwork::port(Door door) const { return sockets_->port(door); }

void UdpNetwork::poll(Time deadline) { sockets_->poll(deadline); }

void UdpNetwork::receive_until(Time deadline, const std::function<bool()>& enough) {
  sockets_->receive_until(deadline, enough);
}

}  // namespace cls::simulator

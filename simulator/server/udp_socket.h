// UDP sockets that never block, and several datagrams by one system call.
#pragma once

#include <sys/socket.h>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "base/system/udp_address.h"

namespace cls::simulator {

/// Owns a socket.
class UdpSocket {
 public:
  /// Errors are causes in the system's words. Port 0 takes a free one.
  static base::Result<UdpSocket> bound_to(const base::UdpAddress& local);

  UdpSocket(UdpSocket&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  UdpSocket& operator=(UdpSocket&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  ~UdpSocket();

  int fd() const { return fd_; }
  int local_port() const;

  /// Talks to that address only from now on; false if it cannot.
  bool connect(const base::UdpAddress& peer);

  /// A full buffer loses the datagram, as networks do.
  void send_to(const base::UdpAddress& peer, std::string_view bytes);

 private:
  explicit UdpSocket(int fd) : fd_(fd) {}

  int fd_;
};

/// Datagrams on their way in. Large: made once and used for all sockets.
class IncomingDatagrams {
 public:
  static constexpr std::size_t kMost = 16;
  static constexpr std::size_t kLongest = 8192;  ///< the rest of a longer one is lost

  IncomingDatagrams();

  /// Takes what waits at the socket, at most kMost. When there is nothing it returns the system's
  /// error, else 0.
  int receive(const UdpSocket& socket);

  std::size_t size() const { return count_; }
  std::string_view bytes(std::size_t i) const { return {buffers_[i].data(), headers_[i].msg_len}; }
  const base::UdpAddress& sender(std::size_t i) const { return senders_[i]; }

 private:
  std::array<std::array<char, kLongest>, kMost> buffers_;
  std::array<base::UdpAddress, kMost> senders_;
  std::array<iovec, kMost> parts_;
  std::array<mmsghdr, kMost> headers_;
  std::size_t count_ = 0;
};

/// Datagrams for one connected socket, kept until they are sent all at once. Memory is reused.
class OutgoingDatagrams {
 public:
  bool empty() const { return ends_.empty(); }

  /// `message`, and a NUL if `with_nul`.
  void add(std::string_view message, bool with_nul);

  /// Sends and forgets all. False if the other side has closed its port; other troubles lose
  /// datagrams, as networks do.
  bool send(const UdpSocket& socket);

 private:
  std::string bytes_;
  std::vector<std::size_t> ends_;
};

}  // namespace cls::simulator

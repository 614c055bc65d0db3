// Non-blocking UDP sockets, and batches of datagrams per system call.
#pragma once

#include <sys/socket.h>

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "base/system/socket_address.h"
#include "base/system/unique_fd.h"

namespace cls::base {

/// Sends and receives return 0 or an errno value.
class UdpSocket {
 public:
  /// An unbound socket of the family AF_INET or AF_INET6. Errors are those of the system.
  static Result<UdpSocket> open(int family);
  /// Port 0 selects a free port.
  static Result<UdpSocket> bind(const SocketAddress& local);
  /// One that another process has opened; it becomes non-blocking.
  static UdpSocket adopt(UniqueFd fd, int family);

  int fd() const { return fd_.get(); }
  int local_port() const;

  /// From now on sends to `peer` and receives from it only; false on failure.
  bool connect(const SocketAddress& peer);

  /// A connected socket needs no `peer`. A full buffer loses the datagram, as networks do.
  int send(std::string_view message, bool with_nul, const SocketAddress* peer = nullptr);
  /// Receives one datagram into `buffer`; the excess of a longer one is lost.
  int receive(std::span<char> buffer, std::size_t& size, SocketAddress& sender);

  void set_receive_buffer(int bytes);
  /// Whether an unconnected socket reports ICMP errors, such as a closed port (ECONNREFUSED).
  void report_errors(bool on);

 private:
  UdpSocket(int fd, int family) : fd_(fd), family_(family) {}

  UniqueFd fd_;
  int family_;
};

/// Receives batches of datagrams. Large: use one object for all sockets.
class IncomingDatagrams {
 public:
  static constexpr std::size_t kMaxCount = 16;
  static constexpr std::size_t kMaxBytes = 8192;  ///< the excess of a longer datagram is lost

  IncomingDatagrams();

  /// Receives the waiting datagrams, at most kMaxCount. Returns 0, or the errno value when there
  /// are none.
  int receive(const UdpSocket& socket);

  std::size_t size() const { return count_; }
  std::string_view bytes(std::size_t i) const { return {buffers_[i].data(), headers_[i].msg_len}; }
  const SocketAddress& sender(std::size_t i) const { return senders_[i]; }

 private:
  std::array<std::array<char, kMaxBytes>, kMaxCount> buffers_;
  std::array<SocketAddress, kMaxCount> senders_;
  std::array<iovec, kMaxCount> parts_;
  std::array<mmsghdr, kMaxCount> headers_;
  std::size_t count_ = 0;
};

/// Collects datagrams for one connected socket and sends them as one batch. Memory is reused.
class OutgoingDatagrams {
 public:
  bool empty() const { return ends_.empty(); }

  /// Queues `message`, with a closing NUL if `with_nul`.
  void add(std::string_view message, bool with_nul);

  /// Sends and removes all datagrams. False if the peer has closed its port; after other errors
  /// datagrams are lost, as in networks.
  bool send(const UdpSocket& socket);

 private:
  std::string bytes_;
  std::vector<std::size_t> ends_;
};

}  // namespace cls::base

// Socket calls for UDP.
#include "base/system/udp_socket.h"

#include <fcntl.h>
#include <sys/uio.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace cls::base {

Result<UdpSocket> UdpSocket::open(int family) {
  UdpSocket socket(::socket(family, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0), family);
  if (!socket.fd_) return Error{std::strerror(errno)};
  return socket;
}

Result<UdpSocket> UdpSocket::bind(const SocketAddress& local) {
  Result<UdpSocket> socket = open(local.family());
  if (socket && ::bind(socket->fd(), local.get(), local.size) != 0) {
    return Error{std::strerror(errno)};
  }
  return socket;
}

UdpSocket UdpSocket::adopt(UniqueFd fd, int family) {
  UdpSocket socket(-1, family);
  socket.fd_ = std::move(fd);
  ::fcntl(socket.fd(), F_SETFL, O_NONBLOCK);
  return socket;
}

int UdpSocket::local_port() const {
  SocketAddress local;
  return ::getsockname(fd(), local.get(), &local.size) == 0 ? local.port() : 0;
}

bool UdpSocket::connect(const SocketAddress& peer) {
  return ::connect(fd(), peer.get(), peer.size) == 0;
}

int UdpSocket::send(std::string_view message, bool with_nul, const SocketAddress* peer) {
  char nul = '\0';
  std::array<iovec, 2> parts = {iovec{const_cast<char*>(message.data()), message.size()},
                                iovec{&nul, 1}};

  msghdr header{};
  header.msg_iov = parts.data();
  header.msg_iovlen = with_nul ? 2 : 1;
  if (peer != nullptr) {
    header.msg_name = const_cast<sockaddr*>(peer->get());
    header.msg_namelen = peer->size;
  }

  return ::sendmsg(fd(), &header, 0) < 0 ? errno : 0;
}

int UdpSocket::receive(std::span<char> buffer, std::size_t& size, SocketAddress& sender) {
  ssize_t received = 0;
  do {
    sender.size = sizeof sender.bytes;
    received = ::recvfrom(fd(), buffer.data(), buffer.size(), 0, sender.get(), &sender.size);
  } while (received < 0 && errno == EINTR);
  if (received < 0) return errno;
  size = static_cast<std::size_t>(received);
  return 0;
}

void UdpSocket::set_receive_buffer(int bytes) {
  ::setsockopt(fd(), SOL_SOCKET, SO_RCVBUF, &bytes, sizeof bytes);
}

void UdpSocket::report_errors(bool on) {
  const int value = on ? 1 : 0;
  if (family_ == AF_INET6) {
    ::setsockopt(fd(), IPPROTO_IPV6, IPV6_RECVERR, &value, sizeof value);
  } else {
    ::setsockopt(fd(), IPPROTO_IP, IP_RECVERR, &value, sizeof value);
  }
}

IncomingDatagrams::IncomingDatagrams() {
  for (std::size_t i = 0; i < kMaxCount; ++i) {
    parts_[i] = {buffers_[i].data(), kMaxBytes};
    headers_[i] = {};
    headers_[i].msg_hdr.msg_iov = &parts_[i];
    headers_[i].msg_hdr.msg_iovlen = 1;
    headers_[i].msg_hdr.msg_name = senders_[i].get();
  }
}

int IncomingDatagrams::receive(const UdpSocket& socket) {
  for (mmsghdr& header : headers_) header.msg_hdr.msg_namelen = sizeof(sockaddr_storage);
  int received = 0;
  do {
    received = ::recvmmsg(socket.fd(), headers_.data(), kMaxCount, 0, nullptr);
  } while (received < 0 && errno == EINTR);

  count_ = static_cast<std::size_t>(std::max(received, 0));
  for (std::size_t i = 0; i < count_; ++i) senders_[i].size = headers_[i].msg_hdr.msg_namelen;
  return received < 0 ? errno : 0;
}

void OutgoingDatagrams::add(std::string_view message, bool with_nul) {
  bytes_ += message;
  if (with_nul) bytes_ += '\0';
  ends_.push_back(bytes_.size());
}

bool OutgoingDatagrams::send(const UdpSocket& socket) {
  constexpr std::size_t kBatch = 32;
  std::array<iovec, kBatch> parts;
  std::array<mmsghdr, kBatch> headers{};
  bool open = true;
  for (std::size_t next = 0; open && next < ends_.size();) {
    const std::size_t count = std::min(kBatch, ends_.size() - next);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t begin = next + i == 0 ? 0 : ends_[next + i - 1];
      parts[i] = {bytes_.data() + begin, ends_[next + i] - begin};
      headers[i].msg_hdr.msg_iov = &parts[i];
      headers[i].msg_hdr.msg_iovlen = 1;
    }

    const int sent = ::sendmmsg(socket.fd(), headers.data(), static_cast<unsigned>(count), 0);
    if (sent < 0 && errno == EINTR) continue;
    open = sent >= 0 || errno != ECONNREFUSED;
    next += sent > 0 ? static_cast<std::size_t>(sent) : 1;
  }

  bytes_.clear();
  ends_.clear();
  return open;
}

}  // namespace cls::base

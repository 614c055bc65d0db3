// System calls for datagrams.
#include "simulator/server/udp_socket.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace cls::simulator {

using base::UdpAddress;

base::Result<UdpSocket> UdpSocket::bound_to(const UdpAddress& local) {
  const int type = SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC;
  UdpSocket socket(::socket(local.bytes.ss_family, type, 0));
  if (socket.fd() < 0 || ::bind(socket.fd(), local.get(), local.size) != 0) {
    return base::Error{std::strerror(errno)};
  }
  return socket;
}

UdpSocket::~UdpSocket() {
  if (fd_ >= 0) ::close(fd_);
}

int UdpSocket::local_port() const {
  UdpAddress local;
  return ::getsockname(fd_, local.get(), &local.size) == 0 ? local.port() : 0;
}

bool UdpSocket::connect(const UdpAddress& peer) {
  return ::connect(fd_, peer.get(), peer.size) == 0;
}

void UdpSocket::send_to(const UdpAddress& peer, std::string_view bytes) {
  [[maybe_unused]] const ssize_t sent =
      ::sendto(fd_, bytes.data(), bytes.size(), 0, peer.get(), peer.size);
}

IncomingDatagrams::IncomingDatagrams() {
  for (std::size_t i = 0; i < kMost; ++i) {
    parts_[i] = {buffers_[i].data(), kLongest};
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
    received = ::recvmmsg(socket.fd(), headers_.data(), kMost, 0, nullptr);
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
  constexpr std::size_t kAtOnce = 32;
  std::array<iovec, kAtOnce> parts;
  std::array<mmsghdr, kAtOnce> headers{};
  bool open = true;
  for (std::size_t next = 0; open && next < ends_.size();) {
    const std::size_t count = std::min(kAtOnce, ends_.size() - next);
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

}  // namespace cls::simulator

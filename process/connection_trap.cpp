// Notifications of seccomp about connect(), and descriptors that they add.
#include "process/connection_trap.h"

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

#include "process/packet.h"

namespace cls::process {
namespace {

constexpr std::uint32_t word(std::size_t offset) { return static_cast<std::uint32_t>(offset); }

std::optional<base::SocketAddress> peer_of(const seccomp_notif& call) {
  base::SocketAddress peer;
  const auto size = std::min<std::size_t>(call.data.args[2], sizeof peer.bytes);
  iovec own{&peer.bytes, size};
  iovec theirs{reinterpret_cast<void*>(call.data.args[1]), size};
  const auto pid = static_cast<pid_t>(call.pid);
  if (::process_vm_readv(pid, &own, 1, &theirs, 1, 0) != static_cast<ssize_t>(size)) {
    return std::nullopt;
  }
  peer.size = static_cast<socklen_t>(size);
  if (peer.family() != AF_INET && peer.family() != AF_INET6) return std::nullopt;
  return peer;
}

// Puts a copy of `socket` in place of the one of the call.
bool replace_socket(int listener, const seccomp_notif& call, const base::UdpSocket& socket) {
  seccomp_notif_addfd added{};
  added.id = call.id;
  added.flags = SECCOMP_ADDFD_FLAG_SETFD;
  added.srcfd = static_cast<std::uint32_t>(socket.fd());
  added.newfd = static_cast<std::uint32_t>(call.data.args[0]);
  return ::ioctl(listener, SECCOMP_IOCTL_NOTIF_ADDFD, &added) >= 0;
}

}  // namespace

base::Result<std::unique_ptr<ConnectionTrap>> ConnectionTrap::create(SocketFor socket_for) {
  std::unique_ptr<ConnectionTrap> trap(new ConnectionTrap(std::move(socket_for)));
  auto ends = make_socket_pair();
  if (!ends) return base::Error{std::strerror(errno)};
  trap->own_end_ = std::move(ends->first);
  trap->child_end_ = std::move(ends->second);
  trap->wake_ = base::UniqueFd(::eventfd(0, EFD_CLOEXEC));
  if (!trap->wake_) return base::Error{std::strerror(errno)};

  trap->thread_ = std::thread([&trap = *trap] { trap.run(); });
  return trap;
}

ConnectionTrap::~ConnectionTrap() {
  if (!thread_.joinable()) return;
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t written = ::write(wake_.get(), &one, sizeof one);
  thread_.join();
}

void ConnectionTrap::add_to(CommandPlan& plan) const {
  plan.passed.push_back(child_end_.get());
  plan.connections_trapped = true;
}

void ConnectionTrap::run() {
  while (true) {
    std::array<pollfd, 3> ready = {pollfd{wake_.get(), POLLIN, 0},
                                   pollfd{own_end_.get(), POLLIN, 0},
                                   pollfd{listener_.get(), POLLIN, 0}};
    if (::poll(ready.data(), ready.size(), -1) < 0) continue;
    if (ready[0].revents != 0) return;

    if ((ready[2].revents & POLLIN) != 0) {
      decide();
    } else if (ready[2].revents != 0) {
      listener_.reset();  // the program has ended
    }
    if (ready[1].revents != 0) receive_listener();
  }
}

// A second one if the program is a script without an interpreter, which is then started again.
void ConnectionTrap::receive_listener() {
  Packet packet = receive_packet(own_end_.get());
  if (packet.fds.size() == 1) listener_ = std::move(packet.fds[0]);
}

void ConnectionTrap::decide() const {
  seccomp_notif call{};
  if (::ioctl(listener_.get(), SECCOMP_IOCTL_NOTIF_RECV, &call) != 0) return;

  seccomp_notif_resp answer{};
  answer.id = call.id;
  answer.flags = SECCOMP_USER_NOTIF_FLAG_CONTINUE;
  const auto peer = peer_of(call);
  // The number of the process may be that of another one by now, if the first is gone.
  const bool valid = ::ioctl(listener_.get(), SECCOMP_IOCTL_NOTIF_ID_VALID, &call.id) == 0;
  if (peer && valid) {
    const auto socket = socket_for_(*peer);
    if (socket && replace_socket(listener_.get(), call, *socket)) answer.flags = 0;
  }
  ::ioctl(listener_.get(), SECCOMP_IOCTL_NOTIF_SEND, &answer);
}

void report_connections(const CommandPlan& plan) {
  if (!plan.connections_trapped || plan.passed.empty()) return;
  const base::UniqueFd child_end(kFirstPassedFd + static_cast<int>(plan.passed.size()) - 1);

  std::array<sock_filter, 6> steps = {{
      {BPF_LD | BPF_W | BPF_ABS, 0, 0, word(offsetof(seccomp_data, arch))},
      {BPF_JMP | BPF_JEQ | BPF_K, 0, 3, AUDIT_ARCH_X86_64},
      {BPF_LD | BPF_W | BPF_ABS, 0, 0, word(offsetof(seccomp_data, nr))},
      {BPF_JMP | BPF_JEQ | BPF_K, 0, 1, SYS_connect},
      {BPF_RET | BPF_K, 0, 0, SECCOMP_RET_USER_NOTIF},
      {BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ALLOW},
  }};
  const sock_fprog program = {static_cast<unsigned short>(steps.size()), steps.data()};

  // Without the last flag a signal would begin the call anew, perhaps behind the new socket.
  constexpr unsigned long kFlags = SECCOMP_FILTER_FLAG_NEW_LISTENER |
                                   SECCOMP_FILTER_FLAG_SPEC_ALLOW |
                                   SECCOMP_FILTER_FLAG_WAIT_KILLABLE_RECV;
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return;
  const base::UniqueFd listener(
      static_cast<int>(::syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, kFlags, &program)));
  if (listener) send_packet(child_end.get(), "listener", {listener.get()});
}

}  // namespace cls::process

// unshare(), setns() and the maps of users; sockets over SCM_RIGHTS.
#include "process/namespace_maker.h"

#include <fcntl.h>
#include <net/if.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "base/system/tcp_connect.h"
#include "base/system/udp_socket.h"
#include "process/packet.h"

namespace cls::process {
namespace {

constexpr int kOfEachProgram = CLONE_NEWNS | CLONE_NEWPID | CLONE_NEWIPC | CLONE_NEWUTS;

bool write_file(const char* path, const std::string& text) {
  const base::UniqueFd file(::open(path, O_WRONLY | O_CLOEXEC));
  return file && ::write(file.get(), text.data(), text.size()) >= 0;
}

// Users and groups keep their numbers, so that files look as they do outside.
bool make_user_namespace() {
  const std::string user = std::to_string(::geteuid());
  const std::string group = std::to_string(::getegid());
  return ::unshare(CLONE_NEWUSER) == 0 && write_file("/proc/self/setgroups", "deny") &&
         write_file("/proc/self/uid_map", user + " " + user + " 1") &&
         write_file("/proc/self/gid_map", group + " " + group + " 1");
}

bool make_network() {
  if (::unshare(CLONE_NEWNET) != 0) return false;
  const base::UniqueFd socket(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  ifreq loopback{};
  std::strcpy(loopback.ifr_name, "lo");
  if (!socket || ::ioctl(socket.get(), SIOCGIFFLAGS, &loopback) != 0) return false;
  loopback.ifr_flags |= IFF_UP;
  return ::ioctl(socket.get(), SIOCSIFFLAGS, &loopback) == 0;
}

// The exit code of a child that runs `body`; 255 if there is none.
template <class Body>
int result_of_child(const Body& body) {
  const pid_t pid = ::fork();
  if (pid == 0) ::_exit(body());
  int status = 0;
  if (pid < 0 || ::waitpid(pid, &status, 0) != pid || !WIFEXITED(status)) return 255;
  return WEXITSTATUS(status);
}

// 0, or the errno of what a program would need here: containers may forbid a /proc of its own.
int try_mounts() {
  return result_of_child([] {
    if (::unshare(kOfEachProgram) != 0) return errno;
    return result_of_child([] {
      const bool mounted =
          ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
          ::mount("tmpfs", "/tmp", "tmpfs", MS_NOSUID | MS_NODEV, nullptr) == 0 &&
          ::mount("proc", "/proc", "proc", MS_NOSUID | MS_NODEV | MS_NOEXEC, nullptr) == 0;
      return mounted ? 0 : errno;
    });
  });
}

NamespaceReply make(const NamespaceRequest& request) {
  if (!make_user_namespace()) return {errno, NamespaceStep::kUser};
  if (!make_network()) return {errno, NamespaceStep::kNetwork};
  if (request.tried) return {try_mounts(), NamespaceStep::kMounts};
  return {};
}

// -1: `errno` says why.
void reply(int control, int socket) {
  const SocketReply error = socket < 0 ? errno : 0;
  send_plain(control, error, socket < 0 ? std::vector<int>() : std::vector<int>{socket});
}

void open_sockets(int control) {
  while (true) {
    const Packet packet = receive_packet(control);  // empty when `control` is closed
    const auto request = read_plain<SocketRequest>(packet);
    if (!request) return;

    if (request->tcp) {
      reply(control, base::make_tcp_socket(request->local.family()).get());
    } else {
      const auto socket = base::UdpSocket::bind(request->local);
      reply(control, socket ? socket->fd() : -1);
    }
  }
}

}  // namespace

void run_namespace_maker(base::UniqueFd control, const NamespaceRequest& request) {
  const NamespaceReply made = make(request);
  if (made.error != 0) {
    send_plain(control.get(), made);
    ::_exit(0);
  }

  const base::UniqueFd user(::open("/proc/self/ns/user", O_RDONLY | O_CLOEXEC));
  const base::UniqueFd network(::open("/proc/self/ns/net", O_RDONLY | O_CLOEXEC));
  send_plain(control.get(), made, {user.get(), network.get()});
  open_sockets(control.get());
  ::_exit(0);
}

bool enter_namespaces(int user, int network) {
  return ::setns(user, CLONE_NEWUSER) == 0 && ::setns(network, CLONE_NEWNET) == 0 &&
         ::unshare(kOfEachProgram) == 0;
}

}  // namespace cls::process

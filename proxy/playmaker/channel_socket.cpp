// gRPC shows each new socket to a "mutator", which puts another one in its place.
#include "proxy/playmaker/channel_socket.h"

#include <fcntl.h>
#include <grpc/support/sync.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <memory>
#include <utility>

// The library exports the type that ChannelArguments::SetSocketMutator() takes, without a header.
struct grpc_fd_info;
struct grpc_socket_mutator_vtable {
  bool (*mutate_fd)(int fd, grpc_socket_mutator* mutator);
  int (*compare)(grpc_socket_mutator* a, grpc_socket_mutator* b);
  void (*destroy)(grpc_socket_mutator* mutator);
  bool (*mutate_fd_2)(const grpc_fd_info* info, grpc_socket_mutator* mutator);
};
struct grpc_socket_mutator {
  const grpc_socket_mutator_vtable* vtable;
  gpr_refcount references;
};
void grpc_socket_mutator_init(grpc_socket_mutator* mutator,
                              const grpc_socket_mutator_vtable* vtable);

namespace cls::proxy {
namespace {

struct Replacement : grpc_socket_mutator {
  base::TcpSocketMaker make;
};

// As gRPC sets its own: addresses of IPv4 over sockets of IPv6, small messages at once.
void set_options(int fd, int family) {
  constexpr int kOff = 0;
  constexpr int kOn = 1;
  if (family == AF_INET6) ::setsockopt(fd, IPPROTO_IPV6, IPV6_V6ONLY, &kOff, sizeof kOff);
  ::setsockopt(fd, IPPROTO_TCP, TCP_NODELAY, &kOn, sizeof kOn);
}

// Flags of the file, such as O_NONBLOCK, are those of the new socket.
bool replace(int fd, grpc_socket_mutator* mutator) {
  int family = AF_UNSPEC;
  socklen_t size = sizeof family;
  if (::getsockopt(fd, SOL_SOCKET, SO_DOMAIN, &family, &size) != 0) return false;

  const base::UniqueFd made = static_cast<Replacement*>(mutator)->make(family);
  if (!made) return false;
  set_options(made.get(), family);
  return ::dup3(made.get(), fd, O_CLOEXEC) >= 0;
}

int compare(grpc_socket_mutator* a, grpc_socket_mutator* b) { return a < b ? -1 : a > b ? 1 : 0; }

void destroy(grpc_socket_mutator* mutator) {
  const std::unique_ptr<Replacement> last(static_cast<Replacement*>(mutator));
}

constexpr grpc_socket_mutator_vtable kReplacing = {replace, compare, destroy, nullptr};

}  // namespace

void connect_over(base::TcpSocketMaker make, grpc::ChannelArguments& arguments) {
  auto replacement = std::make_unique<Replacement>();
  grpc_socket_mutator_init(replacement.get(), &kReplacing);
  replacement->make = std::move(make);
  arguments.SetSocketMutator(replacement.release());  // which counts the references to it
}

}  // namespace cls::proxy

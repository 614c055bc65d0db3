// Replaces the two FILE objects: fmt throws when a FILE fails, gRPC and CLI11 write to them as
// well.
#include "base/io/standard_streams.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/types.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>

namespace cls::base {
namespace {

/// The target of a stream's cookie. It is used until the last flush in exit().
struct Target {
  int descriptor;
  std::atomic<int> error{0};
};

bool closed_input = false;
Target output{STDOUT_FILENO};
Target errors{STDERR_FILENO};

Target& target(StandardStream stream) {
  return stream == StandardStream::kOutput ? output : errors;
}

// A caller may have made the descriptor non-blocking: gives its reader a second.
bool wait_until_writable(int descriptor) {
  constexpr int kReaderTimeoutMs = 1000;
  pollfd wait{descriptor, POLLOUT, 0};
  return ::poll(&wait, 1, kReaderTimeoutMs) > 0;
}

void write_all(int descriptor, std::string_view bytes, std::atomic<int>& error) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written > 0) {
      bytes.remove_prefix(static_cast<std::size_t>(written));
      continue;
    }

    const int cause = written == 0 ? EIO : errno;
    if (cause == EINTR) continue;
    if (cause == EAGAIN && wait_until_writable(descriptor)) continue;

    int none = 0;
    error.compare_exchange_strong(none, cause);
    return;
  }
}

ssize_t write_cookie(void* cookie, const char* bytes, std::size_t size) {
  auto* to = static_cast<Target*>(cookie);
  write_all(to->descriptor, {bytes, size}, to->error);
  return static_cast<ssize_t>(size);
}

std::FILE* open_stream(Target& to, int buffering) {
  cookie_io_functions_t functions{};
  functions.write = write_cookie;
  std::FILE* stream = ::fopencookie(&to, "w", functions);
  if (stream != nullptr) std::setvbuf(stream, nullptr, buffering, BUFSIZ);
  return stream;
}

}  // namespace

// Opened such that use in the wrong direction fails as on a closed descriptor.
void open_standard_descriptors() {
  closed_input = ::fcntl(STDIN_FILENO, F_GETFD) < 0;
  while (true) {
    const int descriptor = ::open("/dev/null", O_RDONLY);
    if (descriptor < 0) return;
    if (descriptor > STDERR_FILENO) {
      ::close(descriptor);
      return;
    }
  }
}

void protect_standard_streams() {
  // A pipe without a reader, or a file at the size limit, is a failed write like any other.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);

  const int buffering = ::isatty(STDOUT_FILENO) == 1 ? _IOLBF : _IOFBF;
  if (std::FILE* stream = open_stream(output, buffering)) stdout = stream;
  if (std::FILE* stream = open_stream(errors, _IONBF)) stderr = stream;
}

bool input_was_closed() { return closed_input; }

int write_error(StandardStream stream) { return target(stream).error; }

void write_to_duplicate(int descriptor, StandardStream stream, std::string_view bytes) {
  write_all(descriptor, bytes, target(stream).error);
}

}  // namespace cls::base

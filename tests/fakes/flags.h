// `--NAME VALUE` pairs at the start of a fake program's command line, and common faults.
#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sched.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

namespace cls::fakes {

class Flags {
 public:
  /// Reads pairs that begin with "--"; `rest()` has the remaining arguments.
  Flags(int argc, char** argv) {
    int i = 1;
    for (; i + 1 < argc && std::string(argv[i]).substr(0, 2) == "--"; i += 2) {
      values_[argv[i]] = argv[i + 1];
    }
    for (; i < argc; ++i) rest_.emplace_back(argv[i]);
  }

  bool has(const std::string& name) const { return values_.count("--" + name) != 0; }
  std::string text(const std::string& name) const {
    const auto found = values_.find("--" + name);
    return found == values_.end() ? "" : found->second;
  }
  int number(const std::string& name, int otherwise = 0) const {
    return has(name) ? std::atoi(text(name).c_str()) : otherwise;
  }
  const std::vector<std::string>& rest() const { return rest_; }

 private:
  std::map<std::string, std::string> values_;
  std::vector<std::string> rest_;
};

[[noreturn]] inline void hang() {
  while (true) ::pause();
}

/// An orphan in its own session that ignores SIGTERM.
inline void leave_grandchild() {
  const pid_t child = ::fork();
  if (child == 0) {
    ::setsid();
    if (::fork() != 0) ::_exit(0);
    ::signal(SIGTERM, SIG_IGN);
    hang();
  }
  ::waitpid(child, nullptr, 0);
}

/// Prints its affinity: "cpus: 0 1".
inline void print_affinity() {
  cpu_set_t set;
  ::sched_getaffinity(0, sizeof set, &set);
  std::string text = "cpus:";
  for (std::size_t cpu = 0; cpu < CPU_SETSIZE; ++cpu) {
    if (CPU_ISSET(cpu, &set)) text += " " + std::to_string(cpu);
  }
  std::printf("%s\n", text.c_str());
  std::fflush(stdout);
}

/// Flags of all fakes.
inline void misbehave_at_start(const Flags& flags) {
  if (flags.has("print-cpus")) print_affinity();
  if (flags.has("ignore-term")) ::signal(SIGTERM, SIG_IGN);
  if (flags.has("grandchild")) leave_grandchild();
}

/// Binds a port of the loopback interface and never replies.
inline void open_silently(int type, int port) {
  const int fd = ::socket(AF_INET, type, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  if (::bind(fd, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0) std::exit(98);
  if (type == SOCK_STREAM) ::listen(fd, 16);
}

/// Ends this program by a signal; sanitizers handle some of them otherwise.
inline void die_of(int signal) {
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace cls::fakes

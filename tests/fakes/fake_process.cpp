// A program that executes its arguments in sequence: prints, hangs, crashes, forks, ...
#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sched.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "tests/fakes/flags.h"

namespace {

/// The remaining arguments.
class Script {
 public:
  Script(int argc, char** argv) : words_(argv + 1, argv + argc) {}

  bool done() const { return next_ == words_.size(); }
  std::string word() {
    if (done()) {
      std::fprintf(stderr, "fake_process: an argument is missing\n");
      std::exit(99);
    }
    return words_[next_++];
  }
  int number() { return std::atoi(word().c_str()); }
  double seconds() { return std::atof(word().c_str()); }
  std::vector<std::string> rest() {
    std::vector<std::string> left(words_.begin() + static_cast<long>(next_), words_.end());
    next_ = words_.size();
    return left;
  }

 private:
  std::vector<std::string> words_;
  std::size_t next_ = 0;
};

void say(const std::string& text) {
  std::printf("%s\n", text.c_str());
  std::fflush(stdout);
}

[[noreturn]] void hang() {
  while (true) ::pause();
}

// A daemon: an orphan in its own session.
void leave_grandchild(bool ignores_term) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::setsid();
    if (::fork() != 0) ::_exit(0);
    if (ignores_term) ::signal(SIGTERM, SIG_IGN);
    hang();
  }
  ::waitpid(child, nullptr, 0);
}

void burn(double seconds) {
  const auto until = static_cast<std::clock_t>(seconds * CLOCKS_PER_SEC) + std::clock();
  volatile unsigned work = 0;
  while (std::clock() < until) work = work + 1;
}

int open_port(int type, int port, bool shared = false) {
  const int fd = ::socket(AF_INET, type, 0);
  const int on = shared ? 1 : 0;
  ::setsockopt(fd, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  if (::bind(fd, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0) {
    std::perror("fake_process: bind");
    std::exit(1);
  }
  if (type == SOCK_STREAM) ::listen(fd, 16);
  return fd;
}

// From a connected socket.
void send_udp(Script& script) {
  const int port = script.number();
  const std::string text = script.word();
  const int fd = ::socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  if (::connect(fd, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0) {
    return say("connect: " + std::string(std::strerror(errno)));
  }
  const bool sent = ::send(fd, text.data(), text.size(), 0) >= 0;
  say(sent ? "sent" : "send: " + std::string(std::strerror(errno)));
}

// By a thread with descriptors of its own, which /proc/PID/fd does not show.
void open_hidden_port(int port) {
  std::thread([port] {
    ::unshare(CLONE_FILES);
    open_port(SOCK_DGRAM, port);
    say("open");
    hang();
  }).detach();
}

void become_orphan() {
  if (::fork() != 0) ::_exit(0);
  ::setsid();
  if (::fork() != 0) ::_exit(0);
}

void print_descriptors() {
  std::string text = "fds:";
  for (int fd = 0; fd < 256; ++fd) {
    if (::fcntl(fd, F_GETFD) >= 0) text += " " + std::to_string(fd);
  }
  say(text);
}

// Ignored and blocked signals, which exec preserves.
void print_signals() {
  std::string text = "signals:";
  sigset_t blocked;
  ::sigprocmask(SIG_BLOCK, nullptr, &blocked);
  for (int signal = 1; signal < NSIG; ++signal) {
    struct sigaction action = {};
    if (::sigaction(signal, nullptr, &action) != 0) continue;
    if (action.sa_handler == SIG_IGN) text += " ignored " + std::to_string(signal);
    if (::sigismember(&blocked, signal) == 1) text += " blocked " + std::to_string(signal);
  }
  say(text);
}

void spoil_signals() {
  for (const int signal : {SIGCHLD, SIGPIPE, SIGHUP, SIGUSR1}) ::signal(signal, SIG_IGN);
  sigset_t all;
  ::sigfillset(&all);
  ::sigprocmask(SIG_SETMASK, &all, nullptr);
}

void become(const std::vector<std::string>& words) {
  std::vector<char*> argv;
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  ::execv(argv.front(), argv.data());
  std::perror("fake_process: exec");
  std::exit(98);
}

using Action = std::function<void(Script&)>;

// Prints what the process inherited.
const std::map<std::string, Action>& questions() {
  static const std::map<std::string, Action> table = {
      {"print-fds", [](Script&) { print_descriptors(); }},
      {"print-signals", [](Script&) { print_signals(); }},
      {"print-cpus", [](Script&) { cls::fakes::print_affinity(); }},
      {"print-folder", [](Script&) { say("folder: " + std::filesystem::current_path().string()); }},
      {"print-variable",
       [](Script& script) {
         const char* value = std::getenv(script.word().c_str());
         say(value == nullptr ? "unset" : "value: " + std::string(value));
       }},
      {"print-group", [](Script&) { say(::getpgrp() == ::getpid() ? "leader" : "member"); }},
      {"print-input", [](Script&) { say(std::getchar() == EOF ? "no input" : "input"); }},
  };
  return table;
}

const std::map<std::string, Action>& actions() {
  static const std::map<std::string, Action> table = {
      {"print", [](Script& script) { say(script.word()); }},
      {"print-part", [](Script& script) { std::printf("%s", script.word().c_str()); }},
      {"print-error", [](Script& script) { std::fprintf(stderr, "%s\n", script.word().c_str()); }},
      {"repeat",
       [](Script& script) {
         const int times = script.number();
         const std::string text = script.word();
         for (int i = 0; i < times; ++i) std::printf("%s\n", text.c_str());
         std::fflush(stdout);
       }},
      {"count",
       [](Script& script) {
         const int times = script.number();
         for (int i = 1; i <= times; ++i) std::printf("line %d\n", i);
         std::fflush(stdout);
       }},
      {"flood",
       [](Script&) {
         for (unsigned long i = 0;; ++i) std::printf("flood %lu of a line that continues\n", i);
       }},
      {"sleep",
       [](Script& script) {
         std::this_thread::sleep_for(std::chrono::duration<double>(script.seconds()));
       }},
      {"hang", [](Script&) { hang(); }},
      {"burn", [](Script& script) { burn(script.seconds()); }},
      {"exit", [](Script& script) { std::exit(script.number()); }},
      {"signal", [](Script& script) { cls::fakes::die_of(script.number()); }},
      {"stop", [](Script&) { ::raise(SIGSTOP); }},
      {"ignore-term", [](Script&) { ::signal(SIGTERM, SIG_IGN); }},
      {"exit-on-term", [](Script&) { ::signal(SIGTERM, [](int) { ::_exit(0); }); }},
      {"grandchild", [](Script&) { leave_grandchild(false); }},
      {"stubborn-grandchild", [](Script&) { leave_grandchild(true); }},
      {"burning-child",
       [](Script& script) {
         const double seconds = script.seconds();
         const pid_t child = ::fork();
         if (child == 0) {
           burn(seconds);
           ::_exit(0);
         }
         ::waitpid(child, nullptr, 0);
       }},
      {"listen-tcp", [](Script& script) { open_port(SOCK_STREAM, script.number()); }},
      {"bind-udp", [](Script& script) { open_port(SOCK_DGRAM, script.number()); }},
      {"share-udp", [](Script& script) { open_port(SOCK_DGRAM, script.number(), true); }},
      {"send-udp", [](Script& script) { send_udp(script); }},
      {"hide-udp", [](Script& script) { open_hidden_port(script.number()); }},
      {"in-orphan", [](Script&) { become_orphan(); }},
      {"close", [](Script& script) { ::close(script.number()); }},
      {"spoil-signals", [](Script&) { spoil_signals(); }},
      {"exec", [](Script& script) { become(script.rest()); }},
  };

  return table;
}

}  // namespace

int main(int argc, char** argv) {
  Script script(argc, argv);
  while (!script.done()) {
    const std::string word = script.word();
    if (const auto question = questions().find(word); question != questions().end()) {
      question->second(script);
    } else if (const auto action = actions().find(word); action != actions().end()) {
      action->second(script);
    } else {
      std::fprintf(stderr, "fake_process: unknown action %s\n", word.c_str());
      return 99;
    }
  }
  return 0;
}

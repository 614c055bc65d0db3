// Matches and programs that cannot start: taken ports, and programs that are not Playmakers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <string>
#include <thread>

#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

// A port of this process on loopback; for TCP it replies with `answer` to each connection.
class TakenPort {
 public:
  explicit TakenPort(int type, std::string answer = {}) : answer_(std::move(answer)) {
    fd_ = ::socket(AF_INET, type, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    ::bind(fd_, reinterpret_cast<sockaddr*>(&address), sizeof address);
    socklen_t size = sizeof address;
    ::getsockname(fd_, reinterpret_cast<sockaddr*>(&address), &size);
    port_ = ntohs(address.sin_port);
    if (type != SOCK_STREAM) return;
    ::listen(fd_, 16);
    thread_ = std::thread([this] { serve(); });
  }
  TakenPort(const TakenPort&) = delete;
  TakenPort& operator=(const TakenPort&) = delete;
  ~TakenPort() {
    stop_ = true;
    ::shutdown(fd_, SHUT_RDWR);
    if (thread_.joinable()) thread_.join();
    ::close(fd_);
  }

  std::string number() const { return std::to_string(port_); }
  std::string owner(const char* protocol) const {
    return std::string(protocol) + " port " + number() + " is taken by ";
  }

 private:
  void serve() {
    while (!stop_) {
      const int client = ::accept(fd_, nullptr, nullptr);
      if (client < 0) continue;
      char request[256];
      if (::recv(client, request, sizeof request, 0) > 0) {
        ::send(client, answer_.data(), answer_.size(), MSG_NOSIGNAL);
      }
      ::close(client);
    }
  }

  std::string answer_;
  int fd_ = -1;
  int port_ = 0;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

std::string this_process() { return "(process " + std::to_string(::getpid()) + ")"; }

void expect_taken(const CommandResult& result, const TakenPort& port, const char* protocol) {
  EXPECT_EQ(result.exit_code, 75) << result.err;
  EXPECT_THAT(result.err, HasSubstr(port.owner(protocol)));
  EXPECT_THAT(result.err, HasSubstr(this_process()));
  EXPECT_THAT(result.err, Not(HasSubstr("chttp2")));
  EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
}

TEST(TakenPorts, AreNamedByMock) {
  const TakenPort port(SOCK_STREAM);
  expect_taken(run({cls_binary(), "mock", "--port", port.number()}), port, "TCP");
}

TEST(TakenPorts, AreNamedByServer) {
  const TakenPort port(SOCK_DGRAM);
  expect_taken(run({cls_binary(), "server", "--port", port.number()}), port, "UDP");
}

TEST(TakenPorts, AreNamedByMatchForMonitors) {
  const TakenPort port(SOCK_DGRAM);
  for (const char* mode : {"lockstep", "synch"}) {
    const TemporaryFolder folder;
    expect_taken(run({cls_binary(), "match", "mock", "mock", "--cycles", "5", "--mode", mode,
                      "--monitor-port", port.number(), "--dir", folder.path() / "match"}),
                 port, "UDP");
  }
}

TEST(Refusals, SayThatAnHttpServerAnswers) {
  const TakenPort port(SOCK_STREAM, "HTTP/1.1 400 Bad Request\r\nContent-Length: 0\r\n\r\n");
  const TemporaryFolder folder;
  const auto start = std::chrono::steady_clock::now();
  const auto match = folder.path() / "match";
  const CommandResult result =
      run({cls_binary(), "match", "mock", "127.0.0.1:" + port.number(), "--dir", match});
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
  EXPECT_EQ(result.exit_code, 69);
  EXPECT_THAT(result.err, HasSubstr("an HTTP server answers at 127.0.0.1:" + port.number() +
                                    ", it does not speak gRPC, which needs HTTP/2 without TLS "
                                    "(in ASP.NET Core: options.Listen(..., o => o.Protocols = "
                                    "HttpProtocols.Http2))"));
  // No figures, no score and no logs of a match that did not begin.
  EXPECT_THAT(result.out, Not(HasSubstr(" 0 : 0 ")));

  EXPECT_THAT(result.out, Not(HasSubstr("decisions")));
  EXPECT_THAT(result.out, HasSubstr("invalid match: refused"));
  EXPECT_FALSE(std::filesystem::exists(match / "match.rcg"));
  EXPECT_FALSE(std::filesystem::exists(match / "match.rcl"));

  const auto document = base::Json::parse(read_file(match / "result.json"));
  EXPECT_TRUE(document["log_files"]["rcg"].is_null());
  EXPECT_EQ(document["fault"], "right");
}

TEST(Refusals, SayThatNothingListens) {
  const TemporaryFolder folder;
  EXPECT_THAT(run({cls_binary(), "match", "127.0.0.1:9", "mock", "--start-timeout", "1", "--dir",
                   folder.path() / "match"}),
              Exits(69, HasSubstr("nothing listens at 127.0.0.1:9")));
}

}  // namespace
}  // namespace cls::tests

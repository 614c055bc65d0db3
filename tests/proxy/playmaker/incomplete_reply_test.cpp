// Replies with the status OK that contain no whole message: no library makes them, a program can.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <string>
#include <thread>
#include <utility>

#include "base/system/unique_fd.h"
#include "proxy/playmaker/grpc_playmaker.h"
#include "tests/proxy/playmaker/playmaker_server.h"

namespace cls::proxy {
namespace {

using testing::HasSubstr;
using namespace std::chrono_literals;
using namespace std::string_literals;

constexpr std::uint8_t kData = 0;
constexpr std::uint8_t kHeaders = 1;
constexpr std::uint8_t kSettings = 4;
constexpr std::uint8_t kPing = 6;
constexpr std::uint8_t kEndOfStream = 1;  // of data and headers; acknowledgement of the others
constexpr std::uint8_t kEndOfHeaders = 4;

/// An HTTP/2 server on one connection: it answers each request with these bytes of data, if any,
/// and with the status OK. Headers are not compressed.
class BareServer {
 public:
  BareServer(std::string content_type, std::string data)
      : content_type_(std::move(content_type)),
        data_(std::move(data)),
        listener_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    ::bind(listener_.get(), reinterpret_cast<sockaddr*>(&address), size);
    ::listen(listener_.get(), 1);
    ::getsockname(listener_.get(), reinterpret_cast<sockaddr*>(&address), &size);
    port_ = ntohs(address.sin_port);
    thread_ = std::thread([this] { serve(); });
  }
  ~BareServer() {
    ::shutdown(listener_.get(), SHUT_RDWR);
    thread_.join();
  }
  BareServer(const BareServer&) = delete;
  BareServer& operator=(const BareServer&) = delete;

  int port() const { return port_; }

 private:
  bool read(std::size_t size, std::string& bytes) const {
    bytes.resize(size);
    return size == 0 ||
           ::recv(connection_.get(), bytes.data(), size, MSG_WAITALL) == static_cast<ssize_t>(size);
  }

  void send(std::uint8_t type, std::uint8_t flags, const std::string& stream,
            const std::string& payload) const {
    std::string frame = {static_cast<char>(payload.size() >> 16),
                         static_cast<char>(payload.size() >> 8), static_cast<char>(payload.size()),
                         static_cast<char>(type), static_cast<char>(flags)};
    frame += stream + payload;
    ::send(connection_.get(), frame.data(), frame.size(), MSG_NOSIGNAL);
  }

  void answer(const std::string& stream) const {
    const std::string ok = "\x88";                // :status 200
    const std::string content_type = "\x0f\x10";  // without an index
    send(kHeaders, kEndOfHeaders, stream,
         ok + content_type + static_cast<char>(content_type_.size()) + content_type_);
    if (!data_.empty()) send(kData, 0, stream, data_);
    send(kHeaders, kEndOfHeaders | kEndOfStream, stream, "\0\x0bgrpc-status\x01\x30"s);
  }

  void serve() {
    const std::string none(4, '\0');
    connection_ = base::UniqueFd(::accept(listener_.get(), nullptr, nullptr));
    std::string bytes;
    if (!connection_ || !read(24, bytes)) return;
    send(kSettings, 0, none, "");

    while (read(9, bytes)) {
      const auto byte = [&bytes](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
      const std::size_t size = std::size_t{byte(0)} << 16 | std::size_t{byte(1)} << 8 | byte(2);
      const std::uint8_t type = byte(3);
      const bool flag = (byte(4) & kEndOfStream) != 0;
      const std::string stream = bytes.substr(5);
      if (!read(size, bytes)) return;
      if (type == kSettings && !flag) send(kSettings, kEndOfStream, none, "");
      if (type == kPing && !flag) send(kPing, kEndOfStream, none, bytes);
      if ((type == kData || type == kHeaders) && flag) answer(stream);
    }
  }

  std::string content_type_;
  std::string data_;
  base::UniqueFd listener_;
  base::UniqueFd connection_;
  int port_ = 0;
  std::thread thread_;
};

RpcStatus status_of(const std::string& content_type, const std::string& data,
                    RpcTimeout limit = 5s) {
  const BareServer server(content_type, data);
  const auto playmaker = make_grpc_playmaker(tests::loopback(server.port()));
  playmaker->begin(1, proto::Rpc::kGetPlayerActions, protos::State(), limit);
  return playmaker->next_reply().value_or(Reply{}).status;
}

TEST(IncompleteReply, IsNotADecision) {
  for (const auto& [content_type, data] : {std::pair("application/grpc", ""s),
                                           {"application/grpc", "\0\0\0\0\x64ten!"s},
                                           {"application/grpc", "\0\xff\xff\xff\xff\x0a"s},
                                           {"application/grpc", "\0\0"s},
                                           {"text/html", ""s}}) {
    const RpcStatus status = status_of(content_type, data);
    EXPECT_FALSE(status.ok()) << content_type << ' ' << data.size();
    EXPECT_THAT(status.message, HasSubstr("GetPlayerActions"));
  }
}

TEST(IncompleteReply, SaysThatTheMessageIsMissing) {
  const RpcStatus status = status_of("application/grpc", "");
  EXPECT_EQ(status.outcome, RpcOutcome::kProtocolError);
  EXPECT_EQ(status.message, "GetPlayerActions: a reply with the status OK, but without a message");
}

TEST(IncompleteReply, IsUnlikeAnEmptyMessage) {
  EXPECT_TRUE(status_of("application/grpc", std::string(5, '\0')).ok());
}

// gRPC waits for the status of such a call up to its deadline.
TEST(IncompleteReply, OfTwoMessagesIsNamedAtItsDeadline) {
  const RpcStatus status = status_of("application/grpc", std::string(10, '\0'), 300ms);
  EXPECT_EQ(status.outcome, RpcOutcome::kDeadline);
  EXPECT_THAT(status.message, HasSubstr("a message came, but not the end of the reply"));
}

}  // namespace
}  // namespace cls::proxy

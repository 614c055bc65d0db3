// Thrift's binary protocol, compared with bytes of Thrift's Python library, and calls over it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <array>
#include <chrono>
#include <memory>
#include <string>
#include <thread>

#include "base/system/unique_fd.h"
#include "proto/playmaker.pb.h"
#include "proxy/playmaker/thrift_playmaker.h"
#include "proxy/playmaker/thrift_wire.h"
#include "tests/support/files.h"

namespace cls::proxy {
namespace {

using proto::Rpc;
using testing::HasSubstr;
using Kind = ThriftReply::Kind;
using namespace std::chrono_literals;

std::string recorded(const std::string& name) {
  return tests::read_file(tests::fixture("thrift/" + name));
}

protos::RegisterRequest coach() {
  protos::RegisterRequest request;
  request.set_agent_type(protos::CoachT);
  request.set_team_name("Reds");
  request.set_uniform_number(12);
  request.set_rpc_version(3);
  return request;
}

TEST(ThriftWire, WritesCallsAsTheLibraryDoes) {
  std::string bytes;
  append_thrift_call("Register", 7, coach(), bytes);
  EXPECT_EQ(bytes, recorded("register-call.bin"));
}

TEST(ThriftWire, ReadsRepliesOfTheLibrary) {
  protos::PlayerActions actions;
  const std::string bytes = recorded("actions-reply.bin");
  const ThriftReply reply = read_thrift_reply(bytes + "more", actions);

  ASSERT_EQ(reply.kind, Kind::kReply) << reply.error;
  EXPECT_EQ(reply.sequence, 9);
  EXPECT_EQ(reply.size, bytes.size());
  EXPECT_TRUE(actions.ignore_preprocess());
  ASSERT_EQ(actions.actions_size(), 5);
  EXPECT_EQ(actions.actions(0).dash().power(), 60.5F);
  EXPECT_EQ(actions.actions(0).dash().relative_direction(), -12.25F);
  EXPECT_EQ(actions.actions(1).body_go_to_point().target_point().y(), -3.5F);
  EXPECT_EQ(actions.actions(2).debug_client().message(), "h\xc3\xa9llo");
  EXPECT_EQ(actions.actions(3).say().ball_message().ball_velocity().x(), 0.5F);
  EXPECT_EQ(actions.actions(4).log().add_text().level(), protos::PASS);
}

TEST(ThriftWire, ReadsExceptionsOfTheLibrary) {
  protos::TrainerActions actions;
  const ThriftReply reply = read_thrift_reply(recorded("unknown-method.bin"), actions);
  EXPECT_EQ(reply.kind, Kind::kException);
  EXPECT_EQ(reply.exception_type, ThriftReply::kUnknownMethod);
  EXPECT_EQ(reply.error, "Unknown function GetTrainerActions");
}

// A reply that has not arrived completely is not an error, and no byte of it may crash the reader.
TEST(ThriftWire, WaitsForTheRestOfAReply) {
  const std::string bytes = recorded("actions-reply.bin");
  protos::PlayerActions actions;
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_EQ(read_thrift_reply(bytes.substr(0, size), actions).kind, Kind::kIncomplete) << size;
  }

  for (std::size_t i = 0; i < bytes.size(); ++i) {
    for (const char wrong : {'\x00', '\x0f', '\x7f', '\xff'}) {
      std::string changed = bytes;
      changed[i] = wrong;
      const ThriftReply reply = read_thrift_reply(changed, actions);
      EXPECT_LE(reply.size, changed.size());
    }
  }

  EXPECT_EQ(read_thrift_reply("HTTP/1.1 400 Bad Request\r\n\r\n", actions).kind, Kind::kInvalid);
}

TEST(ThriftWire, SkipsWhatItDoesNotKnow) {
  protos::RegisterResponse response;
  // Field 0, a struct: an unknown list of i16, a map, a set, field 1 of another type, then field 2.
  constexpr char kBytes[] =
      "\x80\x01\x00\x02\x00\x00\x00\x01R\x00\x00\x00\x05\x0c\x00\x00"
      "\x0f\x00\x63\x06\x00\x00\x00\x02\x00\x01\x00\x02"
      "\x0d\x00\x64\x08\x02\x00\x00\x00\x01\x00\x00\x00\x01\x01"
      "\x0e\x00\x65\x04\x00\x00\x00\x00"
      "\x0b\x00\x01\x00\x00\x00\x01x"
      "\x08\x00\x02\x00\x00\x00\x01\x00\x00";

  const std::string bytes(kBytes, sizeof kBytes - 1);
  const ThriftReply reply = read_thrift_reply(bytes, response);

  ASSERT_EQ(reply.kind, Kind::kReply) << reply.error;
  EXPECT_EQ(reply.sequence, 5);
  EXPECT_EQ(response.client_id(), 0);
  EXPECT_EQ(response.agent_type(), protos::CoachT);
}

// Python's structs have None for a field that did not come.
TEST(ThriftWire, WritesDefaultsButNoMembersOfOneofs) {
  std::string state;
  append_thrift_call("GetPlayerActions", 1, protos::State(), state);
  EXPECT_GT(state.size(), 1000U) << "an empty State has an empty world";
  std::string action;
  append_thrift_call("x", 1, protos::PlayerAction(), action);
  std::string nothing;
  append_thrift_call("x", 1, protos::Empty(), nothing);
  EXPECT_EQ(action.size(), nothing.size());
}

/// A server on loopback that answers every call by a function of its bytes.
class FakeServer {
 public:
  FakeServer() : listener_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    EXPECT_EQ(::bind(listener_.get(), reinterpret_cast<sockaddr*>(&address), size), 0);
    EXPECT_EQ(::listen(listener_.get(), 16), 0);
    EXPECT_EQ(::getsockname(listener_.get(), reinterpret_cast<sockaddr*>(&address), &size), 0);
    port_ = ntohs(address.sin_port);
  }

  int port() const { return port_; }

  base::UniqueFd accept() const {
    return base::UniqueFd(::accept(listener_.get(), nullptr, nullptr));
  }

  /// Waits for some bytes of a call; its sequence number.
  static std::int32_t sequence_of_call(const base::UniqueFd& client) {
    std::array<char, 65536> buffer;
    const ssize_t size = ::recv(client.get(), buffer.data(), buffer.size(), 0);
    if (size < 12) return -1;
    const auto byte = [&](std::size_t at) {
      return static_cast<std::int32_t>(static_cast<unsigned char>(buffer.at(at)));
    };
    const auto name = static_cast<std::size_t>(byte(7));
    return byte(8 + name + 3);
  }

  /// A reply without a value.
  static void reply(const base::UniqueFd& client, std::int32_t sequence) {
    std::string bytes("\x80\x01\x00\x02\x00\x00\x00\x01R\x00\x00\x00", 12);
    bytes += static_cast<char>(sequence);
    bytes += '\0';
    EXPECT_EQ(::send(client.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL),
              static_cast<ssize_t>(bytes.size()));
  }

 private:
  base::UniqueFd listener_;
  int port_ = 0;
};

std::unique_ptr<Playmaker> client_of(const FakeServer& server) {
  GrpcTarget target;
  target.host = "127.0.0.1";
  target.port = server.port();
  return make_thrift_playmaker(target);
}

TEST(ThriftPlaymaker, CallsAndDropsLateReplies) {
  const FakeServer server;
  const auto playmaker = client_of(server);
  std::thread serving([&server] {
    const base::UniqueFd client = server.accept();
    FakeServer::reply(client, FakeServer::sequence_of_call(client));
    const std::int32_t late = FakeServer::sequence_of_call(client);
    const std::int32_t next = FakeServer::sequence_of_call(client);
    FakeServer::reply(client, late);
    FakeServer::reply(client, next);
  });

  EXPECT_TRUE(playmaker->call(12, Rpc::kRegister, coach(), 5s).status.ok());
  playmaker->begin(12, Rpc::kGetCoachActions, protos::State(), 50ms);
  const auto missed = playmaker->next_reply();
  ASSERT_TRUE(missed);
  EXPECT_EQ(missed->status.outcome, RpcOutcome::kDeadline);
  playmaker->begin(12, Rpc::kGetCoachActions, protos::State(), 5s);
  const auto reply = playmaker->next_reply();

  ASSERT_TRUE(reply);
  EXPECT_TRUE(reply->status.ok()) << reply->status.message;
  EXPECT_NE(reply->as<protos::CoachActions>(), nullptr);
  EXPECT_FALSE(playmaker->next_reply());

  const Reply team = playmaker->call(0, Rpc::kRegisterTeam, coach(), 5s);
  EXPECT_EQ(team.status.outcome, RpcOutcome::kUnimplemented);

  playmaker->cancel();
  EXPECT_EQ(playmaker->call(12, Rpc::kRegister, coach(), 5s).status.outcome,
            RpcOutcome::kCancelled);
  serving.join();
}

TEST(ThriftPlaymaker, ReportsLostConnections) {
  const FakeServer server;
  const auto playmaker = client_of(server);
  std::thread serving([&server] {
    base::UniqueFd client = server.accept();
    FakeServer::reply(client, FakeServer::sequence_of_call(client));
    FakeServer::sequence_of_call(client);
    client = base::UniqueFd();
    const base::UniqueFd garbage = server.accept();
    FakeServer::sequence_of_call(garbage);
    ::send(garbage.get(), "HTTP/1.1 400\r\n\r\n", 16, MSG_NOSIGNAL);
  });

  EXPECT_TRUE(playmaker->call(3, Rpc::kRegister, coach(), 5s).status.ok());
  playmaker->begin(3, Rpc::kGetPlayerActions, protos::State(), 5s);
  const auto broken = playmaker->next_reply();

  ASSERT_TRUE(broken);
  EXPECT_EQ(broken->status.outcome, RpcOutcome::kUnavailable);
  EXPECT_TRUE(playmaker->take_connection_loss(3));
  EXPECT_FALSE(playmaker->take_connection_loss(3)) << "once";

  const Reply garbage = playmaker->call(3, Rpc::kRegister, coach(), 5s);
  EXPECT_EQ(garbage.status.outcome, RpcOutcome::kProtocolError);
  EXPECT_THAT(garbage.status.message, HasSubstr("not a reply in Thrift's binary protocol"));
  serving.join();
}

TEST(ThriftPlaymaker, SaysThatNothingListens) {
  GrpcTarget target;
  target.host = "127.0.0.1";
  {
    const FakeServer closed;
    target.port = closed.port();
  }
  const Reply reply =
      make_thrift_playmaker(target)->call(1, Rpc::kRegister, protos::RegisterRequest(), 300ms);
  EXPECT_EQ(reply.status.outcome, RpcOutcome::kUnavailable);
  EXPECT_THAT(reply.status.message, HasSubstr("127.0.0.1:" + std::to_string(target.port)));
}

}  // namespace
}  // namespace cls::proxy

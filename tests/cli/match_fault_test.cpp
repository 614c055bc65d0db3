// Faulty Playmakers: end reason, exit code and error line of each fault.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <future>
#include <mutex>
#include <thread>

#include "tests/proxy/playmaker/playmaker_server.h"
#include "tests/support/command.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using json = base::Json;
using testing::HasSubstr;

struct Played {
  CommandResult command;
  json result;
};

// The mock against the Playmaker under test, which plays on the right.
Played play_against(int port, const std::vector<std::string>& more) {
  TemporaryFolder folder;
  const std::vector<std::string> arguments =
      joined({cls_binary(), "match", "mock", "127.0.0.1:" + std::to_string(port), "--seed", "7",
              "--right-name", "brain", "--set", "server::kick_off_wait=3", "--quiet", "--dir",
              folder.path()},
             more);
  Played played;
  played.command = run(arguments);
  played.result = json::parse(read_file(folder.path() / "result.json"));
  return played;
}

// One line with team, address and `what`.
void expect_line(const Played& played, int port, const std::string& what) {
  const std::string& err = played.command.err;
  EXPECT_EQ(std::ranges::count(err, '\n'), 1) << err;
  EXPECT_EQ(err.rfind("cls: brain (127.0.0.1:" + std::to_string(port) + "): ", 0), 0u) << err;
  EXPECT_THAT(err, HasSubstr(what));
}

void expect_invalid(const Played& played, const std::string& end_reason, int exit_code) {
  EXPECT_EQ(played.command.exit_code, exit_code) << played.command.err;
  EXPECT_EQ(played.result["end_reason"], end_reason);
  EXPECT_EQ(played.result["valid"], false);
  EXPECT_TRUE(played.result["winner"].is_null());
  EXPECT_THAT(played.command.out, HasSubstr("invalid match: " + end_reason));
  EXPECT_THAT(played.command.out, HasSubstr("see `cls explain " + end_reason + "`"));
}

TEST(MatchFaults, ReportsCrashOfPlaymaker) {
  GameService service;
  std::atomic<int> calls{0};
  std::condition_variable changed;
  std::mutex mutex;
  service.on_player = [&](const protos::State&, protos::PlayerActions&) {
    if (++calls == 300) changed.notify_one();
    return grpc::Status::OK;
  };

  PlaymakerServer server(service);
  const int port = server.port();
  std::thread killer([&] {
    std::unique_lock lock(mutex);
    changed.wait_for(lock, std::chrono::seconds(30), [&] { return calls >= 300; });
    server.stop();
  });

  const Played played = play_against(port, {"--max-missed", "5", "--reconnect-within", "0"});
  killer.join();
  expect_invalid(played, "crashed", 1);
  expect_line(played, port, "had no usable reply to 6 calls in a row, at cycle ");
  EXPECT_GT(played.result["steps"], 20);
}

TEST(MatchFaults, RefusesWithoutReplyToRegister) {
  std::promise<void> end;
  const std::shared_future<void> ended = end.get_future().share();
  GameService service;
  service.on_register = [ended](const protos::RegisterRequest&, protos::RegisterResponse&) {
    ended.wait_for(std::chrono::seconds(30));
    return grpc::Status::OK;
  };
  PlaymakerServer server(service);
  const auto start = std::chrono::steady_clock::now();
  const Played played = play_against(server.port(), {"--start-timeout", "2"});
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
  end.set_value();
  expect_invalid(played, "refused", 69);
  expect_line(played, server.port(), "");
}

TEST(MatchFaults, RefusesAfterErrorOfRegister) {
  GameService service;
  service.on_register = [](const protos::RegisterRequest&, protos::RegisterResponse&) {
    return grpc::Status(grpc::StatusCode::PERMISSION_DENIED, "not today");
  };
  PlaymakerServer server(service);
  const Played played = play_against(server.port(), {});
  expect_invalid(played, "refused", 69);
  expect_line(played, server.port(), "not today");
}

TEST(MatchFaults, StallsWhenRepliesStop) {
  GameService service;
  std::atomic<int> calls{0};
  std::atomic<bool> over{false};
  service.on_player = [&](const protos::State&, protos::PlayerActions&) {
    while (calls.fetch_add(1) >= 100 && !over) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return grpc::Status::OK;
  };
  PlaymakerServer server(service);
  const Played played = play_against(server.port(), {"--stall-after", "2"});
  over = true;
  expect_invalid(played, "stalled", 1);
  expect_line(played, server.port(), "no new cycle for 2 s");
}

TEST(MatchFaults, EndsAsLateWhenEveryReplyIsLate) {
  GameService service;
  service.on_player = [](const protos::State&, protos::PlayerActions&) {
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
    return grpc::Status::OK;
  };
  PlaymakerServer server(service);
  const Played played = play_against(server.port(), {"--rpc-deadline", "20", "--max-missed", "5"});
  expect_invalid(played, "late", 1);
  expect_line(played, server.port(), "had no usable reply to 6 calls in a row");
  EXPECT_EQ(played.result["deterministic"], false);
  EXPECT_GE(played.result["right"]["players"][0]["late"], 5);
  EXPECT_EQ(played.result["left"]["players"][0]["missed"], 0);
}

TEST(MatchFaults, ContinuesAfterSingleLateReply) {
  GameService service;
  std::atomic<int> calls{0};
  service.on_player = [&](const protos::State&, protos::PlayerActions&) {
    if (++calls == 200) std::this_thread::sleep_for(std::chrono::milliseconds(900));
    return grpc::Status::OK;
  };

  PlaymakerServer server(service);
  const Played played = play_against(server.port(), {"--rpc-deadline", "400", "--cycles", "60"});
  EXPECT_EQ(played.command.exit_code, 0) << played.command.err;
  EXPECT_EQ(played.result["end_reason"], "finished");
  EXPECT_EQ(played.result["deterministic"], false);

  int missed = 0;
  for (const json& player : played.result["right"]["players"]) {
    missed += player["missed"].get<int>();
  }
  EXPECT_EQ(missed, 1);
}

TEST(MatchFaults, ReportsProtocolErrorAfterErrorReplies) {
  GameService service;
  service.on_player = [](const protos::State&, protos::PlayerActions&) {
    return grpc::Status(grpc::StatusCode::UNKNOWN, "Exception calling application: oops");
  };
  PlaymakerServer server(service);
  const Played played = play_against(server.port(), {"--max-missed", "3"});
  expect_invalid(played, "protocol_error", 1);
  expect_line(played, server.port(), "oops");
}

// Invalid bytes from the nth call of a method on.
class Garbage : public grpc::CallbackGenericService {
 public:
  explicit Garbage(std::string method) : method_(std::move(method)) {}

 private:
  class Reactor : public grpc::ServerGenericBidiReactor {
   public:
    explicit Reactor(std::string_view answer) {
      const grpc::Slice slice(answer.data(), answer.size());
      answer_ = grpc::ByteBuffer(&slice, 1);
      StartRead(&request_);
    }
    void OnReadDone(bool ok) override {
      if (ok) StartWriteAndFinish(&answer_, grpc::WriteOptions(), grpc::Status::OK);
    }
    void OnDone() override { delete this; }

   private:
    grpc::ByteBuffer request_;
    grpc::ByteBuffer answer_;
  };

  grpc::ServerGenericBidiReactor* CreateReactor(
      grpc::GenericCallbackServerContext* context) override {
    const bool garbage = context->method() == "/protos.Game/" + method_;
    return new Reactor(garbage ? std::string_view("\x0a\x7f garbage") : std::string_view());
  }

  std::string method_;
};

TEST(MatchFaults, ReportsProtocolErrorForInvalidActions) {
  Garbage service("GetPlayerActions");
  PlaymakerServer server(service);
  const Played played = play_against(server.port(), {"--max-missed", "3"});
  expect_invalid(played, "protocol_error", 1);
  expect_line(played, server.port(), "had no usable reply to 4 calls in a row");
}

TEST(MatchFaults, ReportsProtocolErrorForInvalidRegisterReply) {
  Garbage service("Register");
  PlaymakerServer server(service);
  const Played played = play_against(server.port(), {});
  expect_invalid(played, "protocol_error", 1);
  expect_line(played, server.port(), "Register");
  EXPECT_EQ(played.result["steps"], 0);
}

}  // namespace
}  // namespace cls::tests

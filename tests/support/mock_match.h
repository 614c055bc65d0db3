// A match between two mock teams without match/, for measurements.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>

#include "base/io/byte_sink.h"
#include "mock-server/server.h"
#include "proxy/agent/team.h"
#include "proxy/playmaker/playmaker.h"
#include "simulator/server/lockstep_server.h"

namespace cls::tests {

/// How a team calls its mock.
enum class MockCalls { kDirect, kGrpcInProcess };

/// Embedded server in lockstep and two cls teams, each with a mock Playmaker.
class MockMatch {
 public:
  /// `threads` 1: both teams in the caller's thread, their calls in flight together. 2: the right
  /// team in its own thread. Throws std::runtime_error on failure.
  MockMatch(std::uint64_t seed, int threads, MockCalls calls = MockCalls::kDirect);
  ~MockMatch();

  /// Plays up to `steps` more steps; false when the match is over.
  bool play(int steps);

  simulator::LockstepServer& server() { return *server_; }
  const proxy::Team& team(int side) const { return *teams_.at(static_cast<std::size_t>(side)); }
  const mock_server::Server& mock(int side) const {
    return *mocks_.at(static_cast<std::size_t>(side));
  }
  const std::string& game_log() const { return game_log_.bytes(); }
  double simulator_seconds() const { return simulator_seconds_; }

 private:
  void run_teams();

  base::StringSink game_log_;
  base::StringSink text_log_;
  std::unique_ptr<simulator::LockstepServer> server_;
  std::array<std::unique_ptr<mock_server::Server>, 2> mocks_;
  std::array<std::unique_ptr<proxy::Playmaker>, 2> playmakers_;
  std::array<std::unique_ptr<proxy::Team>, 2> teams_;
  class Worker;
  std::unique_ptr<Worker> worker_;
  double simulator_seconds_ = 0.0;
};

}  // namespace cls::tests

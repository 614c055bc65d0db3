// `--record-rpc`: every request and reply of a match in a file (proto/rpc_recording.proto).
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "orchestration/match/hooks/match_director.h"
#include "proto/recording_file.h"

namespace cls::orchestration::match {

/// Calls are written by cycle, side and agent, not as their answers came: the same match gives the
/// same recording.
class RpcRecorder : public MatchDirector {
 public:
  /// The error names the file.
  static base::Result<std::unique_ptr<RpcRecorder>> create(
      const std::filesystem::path& file, const recording::RecordingHeader& header);

  proxy::RpcListener* listener(soccer::Side side) override;
  void arrange(simulator::World& world, simulator::Events& events) override;
  bool after_cycle(const simulator::World& world) override;

  /// Writes what is left. Empty, or what could not be written.
  std::string close();

 private:
  class Ear : public proxy::RpcListener {
   public:
    Ear(int side, const int& step) : side_(side), step_(step) {}
    void on_call(const proxy::RpcCall& call) override;
    void write_to(proto::RecordingWriter& writer);

   private:
    int side_;
    const int& step_;
    std::vector<recording::RecordedCall> calls_;
  };

  explicit RpcRecorder(std::unique_ptr<proto::RecordingWriter> writer)
      : writer_(std::move(writer)) {}
  void flush();

  std::unique_ptr<proto::RecordingWriter> writer_;
  int step_ = 0;
  std::array<Ear, 2> ears_ = {Ear(1, step_), Ear(2, step_)};
};

}  // namespace cls::orchestration::match

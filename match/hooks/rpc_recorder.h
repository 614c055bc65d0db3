// `--record-rpc`: every request and reply of a match in a file (proto/rpc_recording.proto).
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <mutex>
#include <vector>

#include "base/result.h"
#include "match/hooks/match_hooks.h"
#include "proto/recording_file.h"

namespace cls::match {

/// Calls are written by cycle and agent, not in the order of their replies. In lockstep the left
/// side's calls of a cycle come first, and the same match gives the same bytes; over UDP the sides
/// write a cycle when they have finished it.
class RpcRecorder : public MatchHooks {
 public:
  /// The error names the file.
  static base::Result<std::unique_ptr<RpcRecorder>> create(
      const std::filesystem::path& file, const recording::RecordingHeader& header);

  SideListener* listener(soccer::Side side) override;

  /// Writes the remaining calls. Returns the error, or an empty string.
  std::string close();

 private:
  class SideRecorder : public SideListener {
   public:
    SideRecorder(int side, RpcRecorder& recorder) : side_(side), recorder_(recorder) {}
    void on_call(const proxy::RpcCall& call) override;
    void end_cycle() override;
    void flush();

   private:
    bool has_call(int agent, proto::Rpc rpc) const;

    int side_;
    RpcRecorder& recorder_;
    int step_ = 0;
    std::vector<recording::RecordedCall> calls_;
  };

  explicit RpcRecorder(std::unique_ptr<proto::RecordingWriter> writer)
      : writer_(std::move(writer)) {}
  void write(const std::vector<recording::RecordedCall>& calls);

  std::mutex mutex_;  ///< of the writer: over UDP each side has a thread of its own
  std::unique_ptr<proto::RecordingWriter> writer_;
  std::array<SideRecorder, 2> sides_ = {SideRecorder(1, *this), SideRecorder(2, *this)};
};

}  // namespace cls::match

// `--record-rpc`: every request and reply of a match in a file (proto/rpc_recording.proto).
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "match/hooks/side_hooks.h"
#include "proto/recording_file.h"
#include "proxy/playmaker/playmaker_errors.h"

namespace cls::match {

class RpcRecorder;

/// Collects the calls of a cycle of one side.
class CallsOfSide : public SideListener {
 public:
  CallsOfSide(soccer::Side side, RpcRecorder& recorder) : side_(side), recorder_(recorder) {}

  void on_call(const proxy::RpcCall& call) override;
  void end_cycle() override;
  /// Writes them in the order of the agents.
  void flush();

 private:
  bool has_call(int agent, proto::Rpc rpc) const;

  soccer::Side side_;
  RpcRecorder& recorder_;
  int step_ = 0;
  std::vector<recording::RecordedCall> calls_;
};

/// Calls are written by cycle and agent, not in the order of their replies. In lockstep the left
/// side's calls of a cycle come first, and the same match gives the same bytes; over UDP the sides
/// write a cycle when they have finished it.
class RpcRecorder : public SideHooks<CallsOfSide> {
 public:
  /// The error names the file.
  static base::Result<std::unique_ptr<RpcRecorder>> create(
      const std::filesystem::path& file, const recording::RecordingHeader& header);

  void write(const std::vector<recording::RecordedCall>& calls);
  std::string close() override;

 private:
  explicit RpcRecorder(std::unique_ptr<proto::RecordingWriter> writer)
      : SideHooks(
            {CallsOfSide(soccer::Side::kLeft, *this), CallsOfSide(soccer::Side::kRight, *this)}),
        writer_(std::move(writer)) {}

  std::mutex mutex_;  ///< of the writer: over UDP each side has a thread of its own
  std::unique_ptr<proto::RecordingWriter> writer_;
};

/// Writes the handshake of an agent and its failed call, to be sent again. `header` names the
/// match, `side` is left or right. The error names the file.
base::Result<void> write_error_recording(const std::filesystem::path& file,
                                         const recording::RecordingHeader& header,
                                         soccer::Side side, const proxy::PlaymakerError& error);

}  // namespace cls::match

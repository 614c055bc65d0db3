// The game log of one episode of a world.
#pragma once

#include <memory>
#include <string>

#include "base/io/byte_sink.h"
#include "simulator/sessions/match_recorder.h"
#include "training/episode/episode.h"

namespace cls::training {

class Recording {
 public:
  /// Creates the file. The error names it.
  static base::Result<std::unique_ptr<Recording>> create(const std::string& path);

  /// Writes the start of the episode: from now on pass recorder() to its steps.
  void begin(const Episode& episode);
  bool running() const { return running_; }
  simulator::MatchRecorder& recorder() { return recorder_; }
  /// Writes the result and closes the file.
  base::Result<void> finish(const Episode& episode);

 private:
  explicit Recording(std::unique_ptr<base::ByteSink> sink) : sink_(std::move(sink)) {}

  std::unique_ptr<base::ByteSink> sink_;
  simulator::MatchRecorder recorder_;
  bool running_ = false;
};

}  // namespace cls::training

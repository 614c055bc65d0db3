// The logs of one episode of a world.
#pragma once

#include <memory>
#include <string>

#include "base/io/byte_sink.h"
#include "simulator/sessions/match_recorder.h"
#include "training/episode/episode.h"

namespace cls::training {

class Recording {
 public:
  /// Creates the game log and, if its name ends in ".rcg" or ".rcg.gz", a text log with the
  /// commands of the episode, whose name ends in ".rcl". The error names the file.
  static base::Result<std::unique_ptr<Recording>> create(const std::string& path);

  /// Writes the start of the episode: from now on pass recorder() to its steps.
  void begin(const Episode& episode);
  bool running() const { return running_; }
  simulator::MatchRecorder& recorder() { return recorder_; }
  /// Writes the result and closes the file.
  base::Result<void> finish(const Episode& episode);

 private:
  Recording(std::unique_ptr<base::ByteSink> game, std::unique_ptr<base::ByteSink> text)
      : game_(std::move(game)), text_(std::move(text)) {}

  std::unique_ptr<base::ByteSink> game_;
  std::unique_ptr<base::ByteSink> text_;  ///< null: none
  simulator::MatchRecorder recorder_;
  bool running_ = false;
};

}  // namespace cls::training

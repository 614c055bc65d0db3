// Files of recorded rpcs: see rpc_recording.proto.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "proto/rpc_recording.pb.h"

namespace cls::proto {

/// Writes one recording. The first thing that goes wrong is kept and told by close().
class RecordingWriter {
 public:
  /// Creates the file; null, with the reason in `error`, when that is not possible.
  static std::unique_ptr<RecordingWriter> create(const std::string& path,
                                                 const recording::RecordingHeader& header,
                                                 std::string& error);
  ~RecordingWriter();

  void write(const recording::RecordedCall& call);

  /// Empty when every byte was written.
  std::string close();

 private:
  class File;
  explicit RecordingWriter(std::unique_ptr<File> file);

  std::unique_ptr<File> file_;
};

/// Reads one recording, call by call.
class RecordingReader {
 public:
  /// Null, with the reason in `error`, when the file cannot be read or is no recording.
  static std::unique_ptr<RecordingReader> open(const std::string& path, std::string& error);
  ~RecordingReader();

  const recording::RecordingHeader& header() const { return header_; }

  /// False at the end of the file, and where it is damaged: then damage() says so.
  bool next(recording::RecordedCall& call);
  const std::string& damage() const { return damage_; }

 private:
  class File;
  RecordingReader(std::string path, std::unique_ptr<File> file);

  std::string path_;
  std::unique_ptr<File> file_;
  recording::RecordingHeader header_;
  std::string damage_;
  std::int64_t calls_ = 0;
};

}  // namespace cls::proto

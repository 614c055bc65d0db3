// Reads and writes files of recorded RPCs (rpc_recording.proto).
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "proto/rpc_recording.pb.h"

namespace cls::proto {

/// Writes one recording. close() reports the first error.
class RecordingWriter {
 public:
  /// Creates the file; null on failure, with the reason in `error`.
  static std::unique_ptr<RecordingWriter> create(const std::string& path,
                                                 const recording::RecordingHeader& header,
                                                 std::string& error);
  ~RecordingWriter();

  void write(const recording::RecordedCall& call);

  /// Empty, or the first write error.
  std::string close();

 private:
  class File;
  explicit RecordingWriter(std::unique_ptr<File> file);

  std::unique_ptr<File> file_;
};

/// The version of the recordings that are written; those of newer versions are refused.
constexpr int kRecordingVersion = 1;

/// Reads one recording call by call.
class RecordingReader {
 public:
  /// Null when the file cannot be read or is not a recording, with the reason in `error`.
  static std::unique_ptr<RecordingReader> open(const std::string& path, std::string& error);
  ~RecordingReader();

  const recording::RecordingHeader& header() const { return header_; }

  /// False at the end of the file, and where it is corrupt or truncated: see parse_error().
  bool next(recording::RecordedCall& call);
  /// Empty: the file was intact so far.
  const std::string& parse_error() const { return parse_error_; }

 private:
  class File;
  RecordingReader(std::string path, std::unique_ptr<File> file);

  std::string path_;
  std::unique_ptr<File> file_;
  recording::RecordingHeader header_;
  std::string parse_error_;
  std::int64_t calls_ = 0;
};

}  // namespace cls::proto

// Gzip-compressed output.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "base/io/byte_sink.h"
#include "base/result.h"

namespace cls::base {

/// Compresses to gzip and writes to `inner`. The output depends on the input bytes only: its header
/// has no name and no time. Without close() the output is truncated.
class GzipSink : public ByteSink {
 public:
  static constexpr int kDefaultLevel = 6;

  explicit GzipSink(std::unique_ptr<ByteSink> inner, int level = kDefaultLevel);
  ~GzipSink() override;
  GzipSink(const GzipSink&) = delete;
  GzipSink& operator=(const GzipSink&) = delete;

  void write(std::string_view bytes) override;
  Result<void> close() override;

 private:
  struct Stream;
  void compress(std::string_view bytes, bool finish);

  std::unique_ptr<ByteSink> inner_;
  std::unique_ptr<Stream> stream_;
};

/// A new file, compressed if its name ends in ".gz"; "-" is standard output.
Result<std::unique_ptr<ByteSink>> create_sink(const std::string& path);

}  // namespace cls::base

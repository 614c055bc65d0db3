// A log in memory that its reader takes in pieces.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "base/io/byte_sink.h"

namespace cls::playground {

/// Collects what was written since the last take(), and passes a copy to `copies`, if there is one.
class LogBuffer : public base::ByteSink {
 public:
  /// `copies` must outlive the buffer.
  void copy_to(base::ByteSink& copies) { copies_ = &copies; }

  void write(std::string_view bytes) override {
    bytes_ += bytes;
    if (copies_ != nullptr) copies_->write(bytes);
  }
  base::Result<void> close() override { return {}; }

  std::string take() { return std::exchange(bytes_, {}); }

 private:
  std::string bytes_;
  base::ByteSink* copies_ = nullptr;
};

}  // namespace cls::playground

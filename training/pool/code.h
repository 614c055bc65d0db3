// Results of operations on pools: a code for programs and a text for people.
#pragma once

#include <string>
#include <utility>

namespace cls::training {

/// Numbers are part of the C interface (training/c_api/cls_training.h describes them).
enum class Code : int {
  kOk = 0,
  kBadPointer = -1,
  kBadHandle = -2,
  kBadConfig = -3,
  kBadSize = -4,
  kBadIndex = -5,
  kBadAction = -6,
  kBadOrder = -7,
  kBadFile = -8,
  kSmallBuffer = -9,
  kForked = -10,
  kInternal = -11,
};

/// `text` is empty for kOk.
struct [[nodiscard]] Outcome {
  Code code = Code::kOk;
  std::string text{};

  bool ok() const { return code == Code::kOk; }
};

}  // namespace cls::training

// A short list without allocation.
#pragma once

#include <array>
#include <cstddef>

namespace cls::player {

/// At most kMax items; more are left out.
template <typename T, std::size_t kMax>
class Few {
 public:
  void add(const T& item) {
    if (count_ < kMax) items_[count_++] = item;
  }
  const T* begin() const { return items_.data(); }
  const T* end() const { return items_.data() + count_; }

 private:
  std::array<T, kMax> items_{};
  std::size_t count_ = 0;
};

}  // namespace cls::player

// A list with inline storage for N elements: no allocation, copied as a value.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>

namespace cls::base {

/// Elements of a list.
template <typename T, std::size_t N, bool kPlain>
struct FixedListItems {
  std::array<T, N> items{};
};

/// Plain elements stay unset until they are added: lists are made often and rarely filled.
template <typename T, std::size_t N>
struct FixedListItems<T, N, true> {
  FixedListItems() {}  // NOLINT(modernize-use-equals-default): a default would set the elements
  union {
    std::array<T, N> items;
  };
};

template <typename T, std::size_t N>
class FixedList {
 public:
  FixedList() = default;
  FixedList(const FixedList& other) { *this = other; }
  FixedList& operator=(const FixedList& other) {
    if (this != &other) std::copy(other.begin(), other.end(), begin());
    size_ = other.size_;
    return *this;
  }

  static constexpr std::size_t capacity() { return N; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  bool full() const { return size_ == N; }

  T* begin() { return storage_.items.data(); }
  T* end() { return begin() + size_; }
  const T* begin() const { return storage_.items.data(); }
  const T* end() const { return begin() + size_; }
  T& operator[](std::size_t i) { return begin()[i]; }
  const T& operator[](std::size_t i) const { return begin()[i]; }
  T& back() { return begin()[size_ - 1]; }

  void clear() { size_ = 0; }
  /// False without change when the list is full.
  bool push_back(const T& item) {
    if (full()) return false;
    begin()[size_++] = item;
    return true;
  }
  /// Preserves the order of the other elements.
  void erase(std::size_t index) {
    std::copy(begin() + index + 1, end(), begin() + index);
    --size_;
  }

 private:
  FixedListItems<T, N, std::is_trivially_copyable_v<T>> storage_;
  std::size_t size_ = 0;
};

}  // namespace cls::base

// How much the server takes in of one client.
#pragma once

#include <cstddef>

namespace cls::simulator {

/// What a client may send between two steps of the match. The rest is dropped: nobody who plays
/// needs more, and whoever floods the server must take neither its memory nor the others' time.
class Allowance {
 public:
  static constexpr int kDatagrams = 256;
  static constexpr std::size_t kPlayerBytes = 16 << 10;
  /// Pieces of pictures are long, and a coach has one command a datagram.
  static constexpr std::size_t kCoachBytes = 128 << 10;

  explicit Allowance(std::size_t bytes) : bytes_(bytes) {}

  /// False if the datagram is beyond it.
  bool take(std::size_t datagram_bytes) {
    if (datagrams_used_ == kDatagrams || datagram_bytes > bytes_ - bytes_used_) return false;
    ++datagrams_used_;
    bytes_used_ += datagram_bytes;
    return true;
  }

  void renew() {
    datagrams_used_ = 0;
    bytes_used_ = 0;
  }

 private:
  std::size_t bytes_;
  std::size_t bytes_used_ = 0;
  int datagrams_used_ = 0;
};

}  // namespace cls::simulator

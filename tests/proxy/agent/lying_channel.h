// A connection on which a faulty network or a hostile server loses, repeats and changes messages.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "soccer/channel.h"
#include "tests/support/text_mutator.h"

namespace cls::tests {

enum class Lies : std::uint8_t {
  kNone,
  kNetwork,  ///< messages are lost, cut, repeated, late, in another order
  kServer,   ///< they are also changed, invented, old, of other protocol versions
};

/// State that all connections of a team share.
struct Liar {
  explicit Liar(std::uint64_t seed) : random(seed), mutator(seed) {}

  std::size_t below(std::size_t end) { return static_cast<std::size_t>(random() % end); }

  Lies lies = Lies::kNone;
  std::int64_t messages = 0;  ///< delivered while lying
  std::int64_t told = 0;      ///< lies
  /// Messages of this server to other clients, which speak other versions of the protocol.
  std::vector<std::string> foreign;
  std::function<void(std::string_view)> on_send;  ///< what the client sends
  std::mt19937_64 random;
  TextMutator mutator;
};

/// The client's end of a connection to an honest server.
class LyingChannel : public soccer::Channel {
 public:
  /// `liar` must outlive the channel.
  LyingChannel(std::unique_ptr<soccer::Channel> server, Liar& liar)
      : server_(std::move(server)), liar_(liar) {}

  bool send(std::string_view message) override;
  bool receive(std::string& message) override;

 private:
  struct Late {
    std::string message;
    std::size_t after = 0;  ///< further messages
  };

  void deliver(std::string message);
  void distort(std::string message);
  void invent(const std::string& message);

  std::unique_ptr<soccer::Channel> server_;
  Liar& liar_;
  std::deque<std::string> waiting_;
  std::vector<Late> late_;
  std::vector<std::string> old_;  ///< the first messages, which introduce the match, and some more
};

}  // namespace cls::tests

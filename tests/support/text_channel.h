// A channel in memory as agents of a server elsewhere have it.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "soccer/channel.h"

namespace cls::tests {

/// Carries text only, as over a network: no peer is asked for values, whose bytes are not checked.
class TextChannel : public soccer::Channel {
 public:
  explicit TextChannel(std::unique_ptr<soccer::Channel> inner) : inner_(std::move(inner)) {}
  bool send(std::string_view message) override { return inner_->send(message); }
  bool receive(std::string& message) override { return inner_->receive(message); }

 private:
  std::unique_ptr<soccer::Channel> inner_;
};

}  // namespace cls::tests

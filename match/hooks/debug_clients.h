// soccerwindow2's view of both sides.
#pragma once

#include <array>
#include <string>

#include "match/hooks/match_hooks.h"
#include "proxy/agent/debug_client.h"

namespace cls::match {

/// A proxy::DebugClient for each side.
class DebugClients : public MatchHooks {
 public:
  explicit DebugClients(const proxy::DebugOptions& options)
      : sides_{SideClient(options), SideClient(options)} {}

  SideListener* listener(soccer::Side side) override {
    return &sides_[side == soccer::Side::kRight ? 1 : 0];
  }

  /// Writes the rest of the files. Returns the error, or an empty string.
  std::string close() {
    const std::string left = sides_[0].client.close();
    const std::string right = sides_[1].client.close();
    return left.empty() ? right : left;
  }

 private:
  struct SideClient : SideListener {
    explicit SideClient(const proxy::DebugOptions& options) : client(options) {}
    proxy::DecisionListener* decisions() override { return &client; }
    bool needs_calls() const override { return false; }
    void on_call(const proxy::RpcCall& /*call*/) override {}

    proxy::DebugClient client;
  };

  std::array<SideClient, 2> sides_;
};

}  // namespace cls::match

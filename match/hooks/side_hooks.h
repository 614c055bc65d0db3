// Hooks that hear each side by a listener of its own.
#pragma once

#include <string>
#include <utility>

#include "match/hooks/match_hooks.h"
#include "soccer/per_side.h"

namespace cls::match {

/// A listener for each side.
template <class Listener>
class SideHooks : public FolderHooks {
 public:
  explicit SideHooks(soccer::PerSide<Listener> sides) : sides_(std::move(sides)) {}

  SideListener* listener(soccer::Side side) override { return &sides_[side]; }

  std::string close() override {
    if constexpr (requires(Listener & side) { side.close(); }) {
      const std::string left = sides_.left.close();
      const std::string right = sides_.right.close();
      return left.empty() ? right : left;
    }
    return {};
  }

 protected:
  soccer::PerSide<Listener> sides_;
};

/// Hears the decisions of a side, but not its calls.
class SideDecisions : public SideListener, public proxy::DecisionListener {
 public:
  proxy::DecisionListener* decisions() override { return this; }
  bool needs_calls() const override { return false; }
  void on_call(const proxy::RpcCall& /*call*/) override {}
};

}  // namespace cls::match

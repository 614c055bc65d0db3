// What Playmakers say by `log` and `debug_client` actions, by cycle, where a person can read it.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/io/byte_sink.h"
#include "orchestration/match/hooks/match_director.h"

namespace cls::orchestration::match {

/// Names inside a match folder; there only when a side says something.
inline constexpr const char* kLeftDebugFile = "left-debug.jsonl";
inline constexpr const char* kRightDebugFile = "right-debug.jsonl";

/// One JSON object a line: {"t": 120, "unum": 7, "kind": "text", "level": "TEAM", "message": ...},
/// in the order of cycle and number. Shapes have their fields as on the wire.
class DebugLog : public MatchDirector {
 public:
  explicit DebugLog(const std::filesystem::path& folder);

  proxy::RpcListener* listener(soccer::Side side) override;
  void before_decisions(const simulator::World& world) override;
  bool after_cycle(const simulator::World& world) override;

  /// Empty, or what could not be written.
  std::string close();

 private:
  class Ear : public proxy::RpcListener {
   public:
    Ear(std::filesystem::path file, const int& time) : file_(std::move(file)), time_(time) {}
    bool needs_requests() const override { return false; }
    void on_call(const proxy::RpcCall& call) override;
    void flush();
    std::string close();

   private:
    std::filesystem::path file_;
    const int& time_;
    std::vector<std::pair<int, std::string>> lines_;  ///< of this cycle, by number
    std::unique_ptr<base::FileSink> sink_;
    std::string problem_;
  };

  int time_ = 0;
  std::array<Ear, 2> ears_;
};

}  // namespace cls::orchestration::match

// `log` and `debug_client` actions of Playmakers, by cycle, as JSON lines.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/io/byte_sink.h"
#include "orchestration/match/hooks/match_hooks.h"
#include "proxy/actions/debug_log.h"

namespace cls::orchestration::match {

/// Names inside a match folder; created with the first action of that side.
inline constexpr const char* kLeftDebugFile = "left-debug.jsonl";
inline constexpr const char* kRightDebugFile = "right-debug.jsonl";

/// One JSON object a line: {"t": 120, "unum": 7, "kind": "text", "level": "TEAM", "message": ...},
/// in the order of cycle and number. Shapes have their fields as on the wire. After
/// proxy::kMaxDebugBytes nothing more is written until the last line, {"kind": "omitted", "count":
/// 12}.
class DebugLog : public MatchHooks {
 public:
  explicit DebugLog(const std::filesystem::path& folder);

  SideListener* listener(soccer::Side side) override;

  /// Writes the remaining lines. Returns the error, or an empty string.
  std::string close();

 private:
  class SideLog : public SideListener {
   public:
    explicit SideLog(std::filesystem::path file) : file_(std::move(file)) {}
    bool needs_requests() const override { return false; }
    void on_call(const proxy::RpcCall& call) override;
    void begin_cycle(int cycle) override { cycle_ = cycle; }
    void end_cycle() override;
    std::string close();

   private:
    void write(std::string_view line);

    std::filesystem::path file_;
    int cycle_ = 0;
    std::size_t room_ = proxy::kMaxDebugBytes;
    std::int64_t omitted_ = 0;
    std::vector<std::pair<int, std::string>> lines_;  ///< of this cycle, with uniform number
    std::unique_ptr<base::FileSink> sink_;
    std::string error_;
  };

  std::array<SideLog, 2> sides_;
};

}  // namespace cls::orchestration::match

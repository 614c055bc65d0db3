// `log` and `debug_client` actions of Playmakers, by cycle, as JSON lines.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/io/byte_sink.h"
#include "match/hooks/side_hooks.h"
#include "proxy/actions/debug_lines.h"

namespace cls::match {

/// The actions of one side.
class DebugActionsOfSide : public SideDecisions {
 public:
  explicit DebugActionsOfSide(std::filesystem::path file) : file_(std::move(file)) {}

  void on_decision(const proxy::Decision& decision) override;
  void end_cycle() override;
  /// Writes the remaining lines. Returns the error, or an empty string.
  std::string close();

 private:
  void write(std::string_view line);

  std::filesystem::path file_;
  std::size_t room_ = proxy::kMaxDebugBytes;
  std::int64_t omitted_ = 0;
  std::vector<std::pair<int, std::string>> lines_;  ///< of this cycle, with uniform number
  std::unique_ptr<base::FileSink> sink_;
  std::string error_;
};

/// Writes viewer::kLeftDebugFile and kRightDebugFile into the match folder, each with the first
/// action of its side. One JSON object a line: {"t": 120, "unum": 7, "kind": "text", "level":
/// "TEAM", "message": ...}, with "stopped" after "t" while the clock is stopped, in the order of
/// cycle and number. Shapes have their fields as on the wire. The lines of a cycle are in the file
/// when it ends, for pages of running matches. After proxy::kMaxDebugBytes nothing more is written
/// until the last line, {"kind": "omitted", "count": 12}.
class DebugActionLog : public SideHooks<DebugActionsOfSide> {
 public:
  explicit DebugActionLog(const std::filesystem::path& folder);
};

}  // namespace cls::match

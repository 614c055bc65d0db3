// Reads .proto files line by line.
#include "cli/explain/proto_text.h"

#include <regex>
#include <sstream>

#include "base/text/number_text.h"

namespace cls::cli {
namespace {

constexpr const char* kBlockForm = R"(^(message|enum) (\w+) \{(\})?$)";
constexpr const char* kFieldForm =
    R"(^ +((?:repeated )?[\w.]+|map<[^>]*>) (\w+) = (\d+);(?:\s*// (.*))?$)";
constexpr const char* kValueForm = R"(^ +(\w+) = (\d+);(?:\s*// (.*))?$)";
constexpr const char* kCommentForm = R"(^ *// (.*)$)";

void add_line(std::string& comment, const std::string& line) {
  if (!comment.empty()) comment += ' ';
  comment += line;
}

}  // namespace

std::vector<ProtoBlock> read_proto(std::string_view text) {
  static const std::regex block(kBlockForm);
  static const std::regex field(kFieldForm);
  static const std::regex value(kValueForm);
  static const std::regex comment(kCommentForm);

  std::vector<ProtoBlock> blocks;
  std::string pending;  // comment lines above the next block or field
  bool inside = false;

  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (std::regex_match(line, match, block)) {
      blocks.push_back({match[1] == "enum", match[2], pending, {}});
      inside = !match[3].matched;
    } else if (inside && std::regex_match(line, match, blocks.back().is_enum ? value : field)) {
      const bool is_enum = blocks.back().is_enum;
      ProtoField one;
      if (!is_enum) one.type = match[1];
      one.name = match[is_enum ? 1 : 2];
      one.number = base::parse_int(match.str(is_enum ? 2 : 3)).value();
      // A comment above belongs to the next line, unless it heads several.
      if (!pending.ends_with(":")) one.comment = pending;
      if (match[is_enum ? 3 : 4].matched) add_line(one.comment, match[is_enum ? 3 : 4]);
      blocks.back().fields.push_back(std::move(one));
    } else if (std::regex_match(line, match, comment)) {
      add_line(pending, match[1]);
      continue;
    } else if (line == "}") {
      inside = false;
    }

    pending.clear();
  }

  return blocks;
}

}  // namespace cls::cli

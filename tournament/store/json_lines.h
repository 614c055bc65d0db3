// Files with a JSON document in each line.
#pragma once

#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/catch_as_error.h"
#include "base/io/whole_file.h"
#include "base/result.h"
#include "base/text/json.h"
#include "base/text/json_codec.h"
#include "base/text/json_text.h"
#include "tournament/store/folder.h"

namespace cls::tournament {

/// A document on one line, with its line feed.
template <typename Document>
std::string format_json_line(const Document& document) {
  return base::json_line(base::JsonEncoder::encode(document)) + "\n";
}

template <typename Document>
base::Result<Document> parse_json(std::string_view text) {
  return base::catch_as_error<std::exception>("", [&] {
    Document document;
    base::JsonDecoder::decode(base::Json::parse(text), document);
    return document;
  });
}

/// The documents of the lines; nothing without the file. The error names the line that is none.
template <typename Document>
base::Result<std::vector<Document>> read_json_lines(const std::filesystem::path& file) {
  std::vector<Document> documents;
  TRY_INIT(const std::string text, read_if_there(file));
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    auto document = parse_json<Document>(line);
    if (!document) {
      return base::Error{fmt::format("{}:{}: {}", file.string(), number, document.error().message)};
    }
    documents.push_back(*std::move(document));
  }
  return documents;
}

/// Replaces the file, synced to disk.
template <typename Document>
base::Result<void> write_json_lines(const std::filesystem::path& file,
                                    const std::vector<Document>& documents) {
  std::string text;
  for (const Document& document : documents) text += format_json_line(document);
  return base::write_file_durably(file, text);
}

}  // namespace cls::tournament

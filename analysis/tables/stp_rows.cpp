// Finds the columns in the heading, then reads their cells.
#include "analysis/tables/stp_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "base/index.h"
#include "base/io/input_buffer.h"
#include "base/text/csv_line.h"
#include "base/text/number_text.h"
#include "base/text/printable.h"
#include "soccer/side.h"

namespace cls::analysis {
namespace {

using base::Error;
using base::InputBuffer;
using base::Result;

constexpr double kMaxNumber = 9e15;
constexpr double kMaxRow = 1e15;
constexpr std::size_t kMaxQuoted = 40;

bool is_row_number(std::optional<double> value) {
  return value && std::trunc(*value) == *value && std::abs(*value) <= kMaxRow;
}

// Where the cells of a row go.
class RowReader {
 public:
  explicit RowReader(const std::vector<std::string_view>& heading)
      : names_(heading.begin(), heading.end()) {}

  Result<void> select(StpColumns columns) {
    TRY(add("#", [this](double value) { row_.number = static_cast<std::int64_t>(value); }));
    if (columns == StpColumns::kModeAndCycle) {
      TRY_INIT(mode_, column("playmode"));
      return add("cycle", [this](double value) {
        row_.cycle = std::isnan(value) ? 0 : static_cast<int>(std::clamp(value, -1e9, 1e9));
      });
    }

    if (columns == StpColumns::kNumber) return {};
    for (std::size_t agent = 0; agent < kStpAgents; ++agent) {
      const bool is_right = agent >= 11 && agent != kStpBall;
      if (is_right && columns == StpColumns::kLeftAndBall) continue;
      TRY(add_point(agent, "", row_.place[agent]));
      if (columns == StpColumns::kMotion) TRY(add_point(agent, "v", row_.motion[agent]));
    }
    return {};
  }

  Result<const StpRow*> read(const std::vector<std::string_view>& cells) {
    if (cells.size() != names_.size()) {
      return Error{fmt::format("has {} cells, but {} columns", cells.size(), names_.size())};
    }

    for (const Number& number : numbers_) {
      const std::string_view text = cells[number.column];
      const auto value = base::parse_number(text);
      const bool is_index = number.column == numbers_.front().column;
      if (is_index ? !is_row_number(value) : !value && !text.empty()) {
        return Error{fmt::format("{}: '{}' must be {}", names_[number.column],
                                 base::printable(text.substr(0, kMaxQuoted)),
                                 is_index ? "an integer" : "a number")};
      }

      const double limited = std::clamp(value.value_or(0.0), -kMaxNumber, kMaxNumber);
      number.store(value ? limited : std::numeric_limits<double>::quiet_NaN());
    }

    if (mode_) row_.mode = cells[*mode_];
    return &row_;
  }

 private:
  struct Number {
    std::size_t column;
    std::function<void(double)> store;
  };

  Result<std::size_t> column(const std::string& name) const {
    const auto found = std::ranges::find(names_, name);
    if (found == names_.end()) return Error{fmt::format("has no column {}", name)};
    return base::index(found - names_.begin());
  }

  Result<void> add(const std::string& name, std::function<void(double)> store) {
    TRY_INIT(const std::size_t at, column(name));
    numbers_.push_back({at, std::move(store)});
    return {};
  }

  Result<void> add_point(std::size_t agent, const std::string& kind, soccer::Vec2& to) {
    const std::string name = stp_agent(agent) + "_" + kind;
    TRY(add(name + "x", [&to](double value) { to.x = value; }));
    return add(name + "y", [&to](double value) { to.y = value; });
  }

  std::vector<std::string> names_;
  std::vector<Number> numbers_;  // the first is `#`
  std::optional<std::size_t> mode_;
  StpRow row_;
};

}  // namespace

std::string stp_agent(std::size_t agent) {
  if (agent == kStpBall) return "b";
  return fmt::format("{}{}", agent < 11 ? 'l' : 'r', soccer::unum_of_slot(static_cast<int>(agent)));
}

Result<void> read_stp_rows(base::ByteSource& table, StpColumns columns,
                           const std::function<void(const StpRow&)>& on_row) {
  InputBuffer input(table);
  std::vector<std::string_view> cells;
  std::optional<RowReader> reader;
  std::string_view line;

  for (;;) {
    const InputBuffer::Line kind = input.next_line(line);
    if (kind == InputBuffer::Line::kEnd) break;
    const auto error_at = [&](const std::string& what) {
      return Error{fmt::format("line {}: {}", input.line_number(), what)};
    };
    if (kind == InputBuffer::Line::kTooLong) return error_at("is too long");

    base::split_csv_line(line, cells);
    if (!reader) {
      reader.emplace(cells);
      if (const auto selected = reader->select(columns); !selected) {
        return error_at(selected.error().message);
      }
      continue;
    }

    if (line.empty()) continue;
    const auto row = reader->read(cells);
    if (!row) return error_at(row.error().message);
    on_row(**row);
  }

  if (!table.error().empty()) return Error{table.error()};
  if (!reader) return Error{"is empty"};
  return {};
}

}  // namespace cls::analysis

// Provides predictions of velocities from the columns before them.
#include "viewer/stream/stream_state.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace cls::viewer {
namespace {

bool same_columns(const std::vector<StreamColumn>& a, const std::vector<StreamColumn>& b) {
  const auto form = [](const StreamColumn& column) {
    return std::tuple(column.spec, column.coding, column.series, column.scale, column.of);
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&form](const StreamColumn& one, const StreamColumn& other) {
                      return form(one) == form(other);
                    });
}

}  // namespace

void StreamState::set_header(StreamHeader header) {
  const bool continues = same_columns(header_.columns, header.columns);
  header_ = std::move(header);
  if (continues) return;

  states_.clear();
  for (const StreamColumn& column : header_.columns) states_.emplace_back(column.series);
  integers_.assign(states_.size(), {});
  before_.assign(states_.size(), {});
}

void StreamState::begin_frames() {
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (header_.columns[i].keeps_integers) before_[i] = states_[i].previous;
  }
}

CodingInput StreamState::input(std::size_t index, std::size_t frames) {
  const StreamColumn& column = header_.columns[index];
  CodingInput input{column.coding, 180 * column.scale, nullptr};
  if (column.coding != Coding::kVelocity) return input;

  Integers decays(frames * column.series, header_.decays.ball);
  if (column.series > 1) {
    std::ranges::transform(integers_[header_.type], decays.begin(),
                           [&](std::int64_t id) { return header_.decays.of_type(id); });
  }

  predictions_ = predicted_velocities(integers_[column.of], before_[column.of], decays);
  input.predictions = &predictions_;
  return input;
}

void StreamState::keep(std::size_t index, Integers integers) {
  if (header_.columns[index].keeps_integers) integers_[index] = std::move(integers);
}

}  // namespace cls::viewer

// Collects samples until the end of their cycle.
#include "match/hooks/world_model_recorder.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "base/io/gzip_sink.h"
#include "base/text/decimal_text.h"
#include "base/text/number_text.h"
#include "match/hooks/action_text.h"
#include "match/hooks/drawing_text.h"
#include "match/hooks/world_model_sample.h"
#include "viewer/decisions/decision_files.h"

namespace cls::match {
namespace {

using soccer::Side;
using viewer::DecisionSample;

char letter_of(player::ActionOutcome outcome) {
  constexpr std::array<char, 5> kLetters = {'e', 'f', 's', 'i', 'u'};
  return kLetters.at(static_cast<std::size_t>(outcome));
}

std::string reply_text(const protos::PlayerActions& reply, const player::DecisionTrace& trace) {
  std::string text;
  for (int i = 0; i < reply.actions_size(); ++i) {
    if (is_drawing(reply.actions(i))) continue;
    const auto index = static_cast<std::size_t>(i);
    const bool tried = trace.by == player::DecidedBy::kActions && index < trace.outcomes.size();
    text += tried ? letter_of(trace.outcomes[index]) : '-';
    text += ' ' + action_text(reply.actions(i)) + '\n';
  }
  return text;
}

/// Removes a command that begins like this.
void remove_command(std::string_view start, std::string& text) {
  const std::size_t at = text.find(start);
  if (at == std::string::npos) return;
  text.erase(at, text.find(')', at) + 1 - at);
}

/// The commands with numbers of one decimal, without the (done) of synchronous mode and
/// without the focus and what was said.
std::string command_text(const std::string& datagram) {
  std::string text;
  double value = 0.0;
  bool quoted = false;
  for (std::size_t at = 0; at < datagram.size();) {
    const char c = datagram[at];
    if (c == '"') quoted = !quoted;
    const bool starts = at > 0 && datagram[at - 1] == ' ';
    const std::size_t length =
        quoted || !starts ? 0
                          : base::parse_number_prefix(std::string_view(datagram).substr(at), value);
    if (length > 0) {
      text += base::decimal_text(value, 1);
      at += length;
    } else {
      text += c;
      ++at;
    }
  }
  remove_command("(done)", text);
  // One in nearly each decision, following from the turn of the neck.
  remove_command("(change_focus ", text);
  // Encoded; the text log has it.
  if (const std::size_t said = text.find(" \""); said != std::string::npos) {
    text.erase(said, text.find('"', said + 2) + 1 - said);
  }
  return text;
}

}  // namespace

WorldModelRecorder::WorldModelRecorder(const std::filesystem::path& folder,
                                       const std::string& left_name, const std::string& right_name)
    : sides_{SideRecorder(Side::kLeft, left_name, folder / viewer::kLeftWorldModelsFile),
             SideRecorder(Side::kRight, right_name, folder / viewer::kRightWorldModelsFile)} {}

SideListener* WorldModelRecorder::listener(Side side) {
  return &sides_[side == Side::kRight ? 1 : 0];
}

void WorldModelRecorder::SideRecorder::on_decision(const proxy::Decision& decision) {
  const proxy::PlayerAgent& agent = decision.agent;
  DecisionSample sample = sample_of(agent.world());
  sample.maker = static_cast<viewer::DecisionMaker>(agent.trace().by);
  sample.call = static_cast<int>(decision.status.outcome);
  if (decision.reply != nullptr) {
    sample.reply = reply_text(*decision.reply, agent.trace());
    std::string drawings = drawings_text(*decision.reply);
    if (drawings.size() <= room_) {
      room_ -= drawings.size();
      sample.drawings = std::move(drawings);
    }
  }
  sample.commands = command_text(agent.sent_commands());
  sample.plan = plan_text(agent.plan());
  sample.latency_us = decision.latency.count();
  waiting_.at(static_cast<std::size_t>(agent.unum() - 1)).push_back(std::move(sample));
}

// Replies arrive in any order, the file has the players in theirs.
void WorldModelRecorder::SideRecorder::write() {
  const bool any = std::any_of(waiting_.begin(), waiting_.end(),
                               [](const auto& samples) { return !samples.empty(); });
  if (!any || !error_.empty()) return;
  if (sink_ == nullptr) {
    auto file = base::FileSink::create(file_.string());
    if (!file) {
      error_ = file.error().message;
      return;
    }
    sink_ = std::make_unique<base::GzipSink>(*std::move(file));
    writer_.append_header(side_, team_, bytes_);
  }
  for (std::size_t i = 0; i < waiting_.size(); ++i) {
    for (const DecisionSample& sample : waiting_[i]) {
      writer_.append(static_cast<int>(i) + 1, sample, bytes_);
    }
    waiting_[i].clear();
  }
  if (bytes_.empty()) return;
  sink_->write(bytes_);
  bytes_.clear();
}

void WorldModelRecorder::SideRecorder::end_cycle() { write(); }

std::string WorldModelRecorder::SideRecorder::close() {
  write();
  if (sink_ == nullptr || !error_.empty()) return error_;
  writer_.append_end(bytes_);
  sink_->write(bytes_);
  const auto closed = sink_->close();
  return closed ? std::string() : closed.error().message;
}

std::string WorldModelRecorder::close() {
  const std::string left = sides_[0].close();
  const std::string right = sides_[1].close();
  return left.empty() ? right : left;
}

}  // namespace cls::match

// Collects samples until the end of their cycle.
#include "match/hooks/decision_stream.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "base/index.h"
#include "base/text/decimal_text.h"
#include "base/text/number_text.h"
#include "match/hooks/reply_text.h"
#include "match/hooks/world_model_sample.h"

namespace cls::match {
namespace {

using viewer::DecisionSample;

char letter_of(player::ActionOutcome outcome) {
  constexpr std::array<char, 5> kLetters = {'e', 'f', 's', 'i', 'u'};
  return kLetters.at(base::index(outcome));
}

std::string reply_text(const protos::PlayerActions& reply, const player::DecisionTrace& trace) {
  std::string text;
  for (int i = 0; i < reply.actions_size(); ++i) {
    if (is_drawing(reply.actions(i))) continue;

    const bool tried = trace.by == player::DecidedBy::kActions && i < std::ssize(trace.outcomes);
    text += tried ? letter_of(trace.outcomes[base::index(i)]) : '-';
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

void DecisionStream::on_decision(const proxy::Decision& decision) {
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
  waiting_.at(base::index(agent.unum() - 1)).push_back(std::move(sample));
}

// Replies arrive in any order, the stream has the players in theirs.
void DecisionStream::end_cycle(std::string& out) {
  using Samples = std::vector<DecisionSample>;
  const auto nothing = [](const Samples& samples) { return samples.empty(); };
  if (std::ranges::all_of(waiting_, nothing)) return;
  if (!begun_) writer_.append_header(side_, team_, out);
  begun_ = true;

  int unum = 0;
  for (Samples& samples : waiting_) {
    ++unum;
    for (const DecisionSample& sample : samples) writer_.append(unum, sample, out);
    samples.clear();
  }
}

void DecisionStream::end(std::string& out) {
  end_cycle(out);
  if (begun_) writer_.append_end(out);
}

}  // namespace cls::match

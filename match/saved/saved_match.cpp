// Options to and from saved matches.
#include "match/saved/saved_match.h"

#include <fmt/format.h>

#include <bit>
#include <utility>
#include <variant>

#include "base/system/version.h"
#include "base/text/fnv1a.h"
#include "match/terms/match_settings.h"
#include "proto/saved_match_file.h"

namespace cls::match {
namespace {

using base::Error;
using base::Result;

// The parameters that are not `usual`, in the form of --set. Logs are not part of the match.
template <typename Params>
void add_settings(std::string_view module, const Params& params, const Params& usual,
                  const soccer::ParameterTable<Params>& table, saved::SavedMatch& out) {
  for (const auto& row : table) {
    if (is_log_parameter(row.name)) continue;
    std::visit(
        [&](auto member) {
          if (params.*member == usual.*member) return;
          out.add_settings(fmt::format("{}::{}={}", module, row.name, params.*member));
        },
        row.member);
  }
}

// The bytes of numbers, the lowest one first.
class Bytes {
 public:
  void add(std::uint64_t bits) {
    for (int shift = 0; shift < 64; shift += 8) text_ += static_cast<char>(bits >> shift);
  }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(soccer::Vec2 v) {
    add(v.x);
    add(v.y);
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace

saved::SavedMatch describe_match(const MatchOptions& options, std::uint64_t seed,
                                 const TeamNames& names) {
  saved::SavedMatch match;
  match.set_cls(std::string(base::kVersion));
  match.set_seed(seed);
  match.set_left_name(names.left);
  match.set_right_name(names.right);
  match.set_left_endpoint(options.left.text);
  match.set_right_endpoint(options.right.text);
  add_settings("server", options.server, match_server_params(), soccer::server_param_table(),
               match);
  add_settings("player", options.player, soccer::PlayerParams(), soccer::player_param_table(),
               match);
  match.set_coach(options.coach);
  match.set_protocol(options.protocol);
  match.set_on_late(static_cast<int>(options.on_late));
  return match;
}

Result<std::shared_ptr<const saved::SavedMatch>> read_saved_match(
    const std::filesystem::path& file) {
  auto match = std::make_shared<saved::SavedMatch>();
  const std::string error = proto::read_saved_match(file.string(), *match);
  if (!error.empty()) return Error{error};
  return std::shared_ptr<const saved::SavedMatch>(std::move(match));
}

Result<void> resume_from(std::shared_ptr<const saved::SavedMatch> match, MatchOptions& options) {
  options.server = match_server_params();
  options.player = {};
  for (const std::string& setting : match->settings()) TRY(apply_setting(options, setting));
  if (match->on_late() < 0 || match->on_late() > static_cast<int>(proxy::OnLate::kDefault)) {
    return Error{fmt::format("on_late {}: unknown in this version", match->on_late())};
  }

  options.branch_seed = options.seed;
  options.seed = match->seed();
  options.names = {match->left_name(), match->right_name()};
  options.coach = match->coach();
  options.protocol = match->protocol();
  options.on_late = static_cast<proxy::OnLate>(match->on_late());
  options.resumed = std::move(match);
  return {};
}

proxy::SavedReplies replies_of(const saved::SavedMatch& match, soccer::Side side) {
  const int number = side_number(side);
  proxy::SavedReplies replies;
  for (const saved::SavedReply& one : match.replies()) {
    const auto rpc = proto::rpc_from_name(one.rpc());
    const bool known = one.outcome() >= 0 && one.outcome() < proxy::kRpcOutcomes;
    if (one.side() != number || !rpc || !known) continue;
    replies[one.agent()].push_back(
        {*rpc,
         {static_cast<proxy::RpcOutcome>(one.outcome()), one.code(), one.message()},
         one.reply()});
  }
  return replies;
}

std::uint64_t situation_of(const simulator::World& world) {
  Bytes bytes;
  bytes.add(static_cast<std::uint64_t>(world.clock.time));
  bytes.add(static_cast<std::uint64_t>(world.clock.stoppage));
  for (const simulator::Team& team : world.teams) bytes.add(static_cast<std::uint64_t>(team.score));

  bytes.add(world.ball.position);
  bytes.add(world.ball.velocity);
  for (const simulator::Player& player : world.players) {
    bytes.add(player.position);
    bytes.add(player.velocity);
    bytes.add(player.body);
  }
  return base::fnv1a(bytes.text());
}

}  // namespace cls::match

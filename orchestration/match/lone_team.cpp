// The life of one team, from the search for its server to its goodbye.
#include "orchestration/match/lone_team.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "orchestration/match/sides/match_side.h"
#include "proxy/agent/team_driver.h"
#include "proxy/playmaker/grpc_playmaker.h"

namespace cls::orchestration::match {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int kRightPortOffset = 20;

/// Cancels what a team waits for when a signal comes: the team's own thread cannot look.
class Canceller {
 public:
  Canceller(proxy::Playmaker& playmaker, const std::atomic<int>& signal)
      : thread_([this, &playmaker, &signal] {
          while (!over_) {
            if (signal.load() != 0) playmaker.cancel();
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
          }
        }) {}
  Canceller(const Canceller&) = delete;
  Canceller& operator=(const Canceller&) = delete;
  ~Canceller() {
    over_ = true;
    thread_.join();
  }

 private:
  std::atomic<bool> over_{false};
  std::thread thread_;
};

class LoneTeam {
 public:
  LoneTeam(const LoneTeamOptions& options, MatchObserver& observer,
           const std::atomic<int>& stop_signal)
      : options_(options),
        observer_(observer),
        signal_(stop_signal),
        playmaker_(proxy::make_grpc_playmaker(options.playmaker)),
        team_(options.team, *playmaker_) {}

  LoneTeamResult run() {
    auto clients = soccer::UdpClients::create(options_.server_host, options_.server_port);
    if (!clients) {
      end(EndReason::kRefused, clients.error().message);
      return result_;
    }
    proxy::DriverOptions settings;
    settings.leave_at_time_over = false;
    settings.coach_port = options_.coach_port;
    settings.trainer_port = options_.trainer_port;
    proxy::TeamDriver driver(team_, **clients, settings);
    if (join(driver, **clients) && introduce()) play(driver);
    {
      const Canceller canceller(*playmaker_, signal_);
      team_.leave();
    }
    take_figures();
    return result_;
  }

 private:
  void end(EndReason reason, std::string message) {
    const bool interrupted = signal_.load() != 0;
    result_.end_reason = interrupted ? EndReason::kInterrupted : reason;
    result_.message = interrupted ? "interrupted" : std::move(message);
    result_.signal = signal_.load();
  }

  bool join(proxy::TeamDriver& driver, soccer::UdpClients& clients) {
    const std::string where = fmt::format("{}:{}", options_.server_host, options_.server_port);
    const auto limit = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                          std::chrono::duration<double>(options_.start_timeout_s));
    const proxy::GoOn go_on = [&] { return signal_.load() == 0 && Clock::now() < limit; };
    observer_.on_phase(fmt::format("waiting for the soccer server at {}", where));
    if (!proxy::wait_for_server(clients, go_on)) {
      end(EndReason::kRefused, fmt::format("no soccer server answers at {} within {} s", where,
                                           options_.start_timeout_s));
      return false;
    }
    const auto connected = driver.connect(go_on);
    if (!connected) end(EndReason::kRefused, connected.error().message);
    return connected.ok();
  }

  // The side is known by now, and with it the Playmaker's port.
  bool introduce() {
    result_.right_side = team_.side() == soccer::Side::kRight;
    proxy::GrpcTarget target = options_.playmaker;
    if (options_.add_20_for_right && result_.right_side) {
      target.port += kRightPortOffset;
      playmaker_ = proxy::make_grpc_playmaker(target);
      team_.set_playmaker(*playmaker_);
    }
    const std::string where =
        address(target, team_.players().empty() ? team_.coach()->number()
                                                : team_.players().front()->unum());
    observer_.on_phase(fmt::format("waiting for the Playmaker at {}", where));
    const Canceller canceller(*playmaker_, signal_);
    const proxy::RpcStatus status = team_.introduce();
    for (const std::string& line : team_.take_warnings()) observer_.on_warning(line);
    if (!status.ok()) end(EndReason::kRefused, status.message);
    return status.ok();
  }

  void play(proxy::TeamDriver& driver) {
    observer_.on_phase("playing");
    if (options_.on_ready) options_.on_ready(team_);
    const Canceller canceller(*playmaker_, signal_);
    const proxy::DriveEnd reason = driver.run([this] {
      for (const std::string& line : team_.take_warnings()) observer_.on_warning(line);
      const proxy::GameState& game = team_.world().game;
      observer_.on_cycle({game.time.cycle, 0, game.our_score, game.their_score, game.mode});
      over_ = over_ || game.mode == soccer::PlayMode::kTimeOver;
      return signal_.load() == 0;
    });
    if (reason == proxy::DriveEnd::kStopped) end(EndReason::kInterrupted, "interrupted");
    if (reason == proxy::DriveEnd::kServerSilent && !over_) {
      end(EndReason::kServerFailed, "the soccer server fell silent before the end of the match");
    }
  }

  void take_figures() {
    if (const proxy::CoachAgent* coach = team_.coach()) take_figures(*coach);
    for (const auto& player : team_.players()) {
      result_.players.push_back(result_of(player->unum(), player->statistics()));
      const proxy::GameState& game = player->world().game;
      result_.cycles = std::max(result_.cycles, game.time.cycle);
      result_.our_score = game.our_score;
      result_.their_score = game.their_score;
    }
  }

  void take_figures(const proxy::CoachAgent& coach) {
    result_.players.push_back(result_of(coach.number(), coach.statistics()));
    result_.players.back().commands = coach.commands();
    const proxy::GameState& game = coach.world().game;
    result_.cycles = std::max(result_.cycles, game.time.cycle);
    result_.our_score = game.our_score;
    result_.their_score = game.their_score;
  }

  const LoneTeamOptions& options_;
  MatchObserver& observer_;
  const std::atomic<int>& signal_;
  std::unique_ptr<proxy::Playmaker> playmaker_;
  proxy::Team team_;
  LoneTeamResult result_;
  bool over_ = false;
};

}  // namespace

std::string to_json(const LoneTeamOptions& options, const LoneTeamResult& result) {
  using Json = nlohmann::ordered_json;
  const Json document = {{"schema", "cls.proxy/1"},
                         {"team", options.team.name.view()},
                         {"side", result.right_side ? "right" : "left"},
                         {"playmaker", address(options.playmaker, 0)},
                         {"end_reason", name(result.end_reason)},
                         {"message", result.message.empty() ? Json(nullptr) : Json(result.message)},
                         {"our_score", result.our_score},
                         {"their_score", result.their_score},
                         {"cycles", result.cycles},
                         {"players", Json::parse(to_json(result.players))}};
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

LoneTeamResult run_lone_team(const LoneTeamOptions& options, MatchObserver& observer,
                             const std::atomic<int>& stop_signal) {
  return LoneTeam(options, observer, stop_signal).run();
}

}  // namespace cls::orchestration::match

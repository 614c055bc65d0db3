// The items of each head as functions of agents in matches.
#include "training/senses/sense_choice.h"

#include <array>
#include <span>

#include "base/index.h"
#include "player/looking/looking.h"
#include "player/world/motion.h"

namespace cls::training {
namespace {

using player::CommandSlots;
using player::ViewMemory;
using player::WorldModel;

struct Item {
  std::string_view name;
  void (*set)(const WorldModel& world, const ViewMemory& view, CommandSlots& slots);
};

// Degrees from the body.
template <int kDegrees>
void turn_neck(const WorldModel& world, const ViewMemory&, CommandSlots& slots) {
  neck_turn_to_relative(world, slots, kDegrees);
}

template <soccer::ViewWidth kWidth>
void set_width(const WorldModel&, const ViewMemory&, CommandSlots& slots) {
  slots.change_view(kWidth);
}

// The default of agents in matches.
void watch_ball(const WorldModel& world, const ViewMemory&, CommandSlots& slots) {
  if (world.ball.position_valid()) focus_to_point(world, slots, ball_after(world, 1));
}

// In the direction of the face.
template <int kMeters>
void focus_ahead(const WorldModel& world, const ViewMemory&, CommandSlots& slots) {
  const player::Vec2 ahead = soccer::polar(kMeters, slots.next_face());
  focus_to_point(world, slots, slots.next_position() + ahead);
}

constexpr std::array kNecks = {
    Item{"default", [](const auto& world, const auto& view,
                       auto& slots) { neck_turn_to_ball_or_scan(world, view, slots, 0); }},
    Item{"ball", [](const auto& world, const auto& view,
                    auto& slots) { neck_turn_to_ball(world, view, slots); }},
    Item{"field", [](const auto& world, const auto& view,
                     auto& slots) { neck_scan_field(world, view, slots); }},
    Item{"players", [](const auto& world, const auto& view,
                       auto& slots) { neck_scan_players(world, view, slots); }},
    Item{"goalie", [](const auto& world, const auto& view,
                      auto& slots) { neck_turn_to_goalie_or_scan(world, view, slots, 0); }},
    Item{"mate", [](const auto& world, const auto& view,
                    auto& slots) { neck_turn_to_low_conf_teammate(world, view, slots); }},
    Item{"-90", turn_neck<-90>},
    Item{"-60", turn_neck<-60>},
    Item{"-30", turn_neck<-30>},
    Item{"0", turn_neck<0>},
    Item{"30", turn_neck<30>},
    Item{"60", turn_neck<60>},
    Item{"90", turn_neck<90>}};

constexpr std::array kViews = {Item{"default", [](const auto& world, const auto&,
                                                  auto& slots) { view_tactical(world, slots); }},
                               Item{"narrow", set_width<soccer::ViewWidth::kNarrow>},
                               Item{"normal", set_width<soccer::ViewWidth::kNormal>},
                               Item{"wide", set_width<soccer::ViewWidth::kWide>}};

constexpr std::array kFocuses = {
    Item{"default", watch_ball},
    Item{"self", [](const auto& world, const auto&, auto& slots) { focus_reset(world, slots); }},
    Item{"10", focus_ahead<10>}, Item{"20", focus_ahead<20>}, Item{"40", focus_ahead<40>}};

constexpr std::array<std::string_view, kSymbols + 1> kSays = {"default", "A", "B", "C", "D",
                                                              "E",       "F", "G", "H"};

// No message of cls agents and of helios teams begins with it.
constexpr char kSymbolMark = '<';

std::vector<std::string_view> names_of(std::span<const Item> items) {
  std::vector<std::string_view> names;
  for (const Item& item : items) names.push_back(item.name);
  return names;
}

// The symbol of a message; 0 for other messages.
int symbol_of(std::string_view text) {
  if (text.size() != 2 || text[0] != kSymbolMark) return 0;
  const int symbol = text[1] - 'A' + 1;
  return symbol >= 1 && symbol <= kSymbols ? symbol : 0;
}

}  // namespace

std::vector<SenseHead> sense_heads(const SenseOptions& options) {
  std::vector<SenseHead> heads;
  if (options.look) {
    heads.push_back({"neck", names_of(kNecks)});
    heads.push_back({"view", names_of(kViews)});
    heads.push_back({"focus", names_of(kFocuses)});
  }
  if (options.say) heads.push_back({"say", {kSays.begin(), kSays.end()}});
  return heads;
}

SenseChoice read_senses(const SenseOptions& options, const std::int32_t* numbers) {
  SenseChoice choice;
  if (options.look) {
    choice.neck = *numbers++;
    choice.view = *numbers++;
    choice.focus = *numbers++;
  }
  if (options.say) choice.say = *numbers;
  return choice;
}

void choose_senses(const SenseChoice& choice, const WorldModel& world, const ViewMemory& view,
                   CommandSlots& slots) {
  // The order of the executor for a list of the body action and Neck_TurnToBallOrScan; what
  // follows depends on what is set.
  kNecks[base::index(choice.neck)].set(world, view, slots);
  kViews[base::index(choice.view)].set(world, view, slots);
  kFocuses[base::index(choice.focus)].set(world, view, slots);

  if (choice.say == 0) return;
  slots.say(std::string{kSymbolMark, kSays[base::index(choice.say)][0]});
}

void update_heard_symbol(const WorldModel& world, HeardSymbol& heard) {
  ++heard.age;
  for (const player::HeardMessage& message : world.heard) {
    const bool mate =
        !message.coach && message.side == world.our_side && message.unum != world.unum;
    const int symbol = mate ? symbol_of(message.text) : 0;
    if (symbol != 0) heard = {symbol, message.unum, 0, message.direction};
  }
}

}  // namespace cls::training

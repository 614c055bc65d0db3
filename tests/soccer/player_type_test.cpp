// Player types compared with those of rcssserver 19 for player::random_seed = 1.
#include "soccer/parameters/player_type.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace cls::soccer {
namespace {

// stamina_inc_max, player_decay, inertia_moment, dash_power_rate, kickable_margin, kick_rand,
// extra_stamina, effort_max, effort_min, catchable_area_l_stretch as printed with six digits.
// clang-format off
constexpr double kSeedOne[17][10] = {
    {45.9054, 0.362655, 4.06637, 0.0058491, 0.688691, 0.0886906, 61.4789, 0.954085, 0.554085, 1.16032},
    {46.7135, 0.482792, 7.06981, 0.00571441, 0.68614, 0.0861397, 96.9564, 0.812174, 0.412174, 1.23352},
    {42.5669, 0.443194, 6.07985, 0.00640552, 0.61856, 0.0185602, 75.9076, 0.896369, 0.496369, 1.25951},
    {44.1402, 0.418613, 5.46533, 0.00614331, 0.682358, 0.0823576, 59.8775, 0.96049, 0.56049, 1.08689},
    {42.8002, 0.328424, 3.2106, 0.00636663, 0.682508, 0.0825078, 51.7086, 0.993166, 0.593166, 1.18721},
    {48.6181, 0.432127, 5.80318, 0.00539699, 0.689227, 0.0892269, 61.1062, 0.955575, 0.555575, 1.02201},
    {51.0459, 0.393848, 4.84619, 0.00499234, 0.780674, 0.180674, 55.9745, 0.976102, 0.576102, 1.15744},
    {41.1977, 0.316725, 2.91812, 0.00663372, 0.78209, 0.18209, 64.9465, 0.940214, 0.540214, 1.17532},
    {44.8327, 0.413182, 5.32956, 0.00602788, 0.791307, 0.191307, 63.0489, 0.947804, 0.547804, 1.0693},
    {40.8007, 0.40669, 5.16724, 0.00669988, 0.698612, 0.0986119, 77.03, 0.89188, 0.49188, 1.22965},
    {46.8242, 0.408158, 5.20394, 0.00569596, 0.778427, 0.178427, 68.8792, 0.924483, 0.524483, 1.16153},
    {47.8649, 0.43046, 5.76149, 0.00552252, 0.714202, 0.114202, 81.8918, 0.872433, 0.472433, 1.03789},
    {44.427, 0.438041, 5.95102, 0.0060955, 0.670788, 0.0707878, 88.1617, 0.847353, 0.447353, 1.10696},
    {42.9409, 0.452584, 6.3146, 0.00634319, 0.660272, 0.0602721, 88.637, 0.845452, 0.445452, 1.04588},
    {48.972, 0.393479, 4.83696, 0.005338, 0.766339, 0.166339, 77.5662, 0.889735, 0.489735, 1.02102},
    {43.2868, 0.394495, 4.86238, 0.00628553, 0.638391, 0.0383912, 73.2156, 0.907138, 0.507138, 1.06911},
    {49.6972, 0.40165, 5.04124, 0.00521714, 0.609861, 0.00986085, 75.9431, 0.896228, 0.496228, 1.05168}};
// clang-format on

// The expected values have six significant digits.
void expect_printed(double printed, double value) {
  EXPECT_NEAR(printed, value, std::fabs(printed) * 5.1e-6);
}

TEST(PlayerTypes, MatchRcssserverForSeedOne) {
  const auto types = draw_player_types(ServerParams{}, PlayerParams{}, 1);

  ASSERT_EQ(types.size(), 18u);

  for (std::size_t i = 1; i < types.size(); ++i) {
    SCOPED_TRACE(i);
    const PlayerType& type = types[i];
    EXPECT_EQ(type.id, static_cast<int>(i));
    const std::array<double, 10> drawn = {type.stamina_inc_max, type.player_decay,
                                          type.inertia_moment,  type.dash_power_rate,
                                          type.kickable_margin, type.kick_rand,
                                          type.extra_stamina,   type.effort_max,
                                          type.effort_min,      type.catchable_area_l_stretch};
    for (std::size_t k = 0; k < drawn.size(); ++k) expect_printed(kSeedOne[i - 1][k], drawn[k]);
  }
}

TEST(PlayerTypes, TypeZeroHasServerParameters) {
  ServerParams server;
  server.player_decay = 0.45;
  server.effort_init = 0.9;
  const auto types = draw_player_types(server, PlayerParams{}, 7);
  EXPECT_EQ(types[0].id, 0);
  EXPECT_EQ(types[0].player_decay, 0.45);
  EXPECT_EQ(types[0].effort_max, 0.9);
  EXPECT_EQ(types[0].catchable_area_l_stretch, 1.0);
}

TEST(PlayerTypes, UseDefaultTypeForImpossibleBounds) {
  PlayerParams player;
  player.player_decay_delta_min = player.player_decay_delta_max = -0.5;  // decay below zero
  const auto types = draw_player_types(ServerParams{}, player, 3);
  ASSERT_EQ(types.size(), 18u);
  EXPECT_EQ(types[5].id, 5);
  EXPECT_EQ(types[5].player_decay, 0.4);
}

TEST(PlayerTypes, MaximumViewDistanceIsPitchDiagonal) {
  EXPECT_DOUBLE_EQ(kPitchDiagonal, std::sqrt(105.0 * 105.0 + 68.0 * 68.0));
}

}  // namespace
}  // namespace cls::soccer

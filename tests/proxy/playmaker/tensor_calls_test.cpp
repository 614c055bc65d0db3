// Rows of numbers instead of States: what is sent, and what comes back.
#include "proxy/playmaker/tensor_calls.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace cls::proxy {
namespace {

namespace wire = cls::playmaker::v1;

/// Two features (uniform number, x), two ids, one value: the power of a dash.
class FakeCodec : public TensorCodec {
 public:
  std::shared_ptr<TensorCodec> clone() const override { return std::make_shared<FakeCodec>(); }
  std::vector<std::string> feature_sets() const override { return {"pair/1"}; }
  std::vector<std::string> action_sets() const override { return {"dashes/3"}; }
  base::Result<TensorSizes> choose(const TensorChoice& choice) override {
    if (choice.feature_set != "pair/1") return base::Error{"no such set"};
    return TensorSizes{2, 2, 2};
  }
  void encode(const player::WorldModel& world, std::vector<float>& features,
              std::vector<std::uint8_t>& masks) override {
    features.push_back(static_cast<float>(world.unum));
    features.push_back(static_cast<float>(world.self.position.x));
    masks.insert(masks.end(), {1, 0});
  }
  std::optional<soccer::PlayerCommand> decode(const player::WorldModel&,
                                              const float* row) override {
    if (!std::isfinite(row[1]) || row[0] > 1.0F) return std::nullopt;
    if (row[0] == 0.0F) return soccer::Turn{30.0};
    return soccer::Dash{static_cast<double>(row[1]), 45.0};
  }
};

class TensorCallsTest : public testing::Test {
 protected:
  TensorCallsTest() {
    team_.codec = std::make_shared<FakeCodec>();
    one_.unum = 1;
    two_.unum = 2;
    two_.self.position = {12.5, 0.0};
    response_.set_encoding(wire::TENSOR);
    response_.set_feature_set("pair/1");
    response_.set_action_set("dashes/3");
  }

  void set_actions(std::initializer_list<float> numbers, int rows, int columns) {
    actions_.mutable_actions()->add_shape(rows);
    actions_.mutable_actions()->add_shape(columns);
    actions_.mutable_actions()->set_data(
        std::string(reinterpret_cast<const char*>(numbers.begin()), numbers.size() * 4));
  }

  TeamRegistration team_;
  player::WorldModel one_;
  player::WorldModel two_;
  wire::RegisterTeamResponse response_;
  wire::GetTeamActionsResponse actions_;
  TensorCalls calls_;
};

TEST_F(TensorCallsTest, OffersSetsAndRating) {
  team_.rated = true;
  wire::RegisterTeamRequest request;
  TensorCalls::offer(team_, request);
  EXPECT_EQ(request.encodings(0), wire::TENSOR);
  EXPECT_EQ(request.feature_sets(0), "pair/1");
  EXPECT_EQ(request.action_sets(0), "dashes/3");
  EXPECT_TRUE(request.rated());
  team_.codec = nullptr;
  request.Clear();
  TensorCalls::offer(team_, request);
  EXPECT_EQ(request.encodings_size(), 0);
}

TEST_F(TensorCallsTest, RefusesWhatWasNotOffered) {
  response_.set_feature_set("other/1");
  EXPECT_EQ(calls_.choose(team_, response_).error().message, "it chose no such set");
  EXPECT_FALSE(calls_.active());
  team_.codec = nullptr;
  EXPECT_EQ(calls_.choose(team_, response_).error().message,
            "it chose encoding 2, which was not offered");
  response_.set_encoding(wire::LEAN_STATES);
  EXPECT_TRUE(calls_.choose(team_, response_));
  EXPECT_FALSE(calls_.active());
}

TEST_F(TensorCallsTest, WritesARowPerPlayer) {
  ASSERT_TRUE(calls_.choose(team_, response_));
  wire::GetTeamActionsRequest request;
  one_.game.mode = soccer::PlayMode::kKickOffLeft;
  calls_.add_player(one_, true, request);
  calls_.add_player(two_, false, request);

  EXPECT_EQ(request.play_mode(), "kick_off_l");
  ASSERT_EQ(request.features().shape_size(), 2);
  EXPECT_EQ(request.features().shape(0), 2);
  EXPECT_EQ(request.features().shape(1), 2);
  std::array<float, 4> numbers{};
  ASSERT_EQ(request.features().data().size(), sizeof numbers);

  std::memcpy(numbers.data(), request.features().data().data(), sizeof numbers);
  EXPECT_EQ(numbers, (std::array<float, 4>{1.0F, 0.0F, 2.0F, 12.5F}));
  EXPECT_EQ(request.masks().data(), std::string("\1\0\1\0", 4));
}

TEST_F(TensorCallsTest, TurnsRowsIntoActionLists) {
  ASSERT_TRUE(calls_.choose(team_, response_));
  set_actions({1.0F, 80.0F, 0.0F, 0.0F}, 2, 2);
  ASSERT_TRUE(calls_.read(actions_, 2));

  const protos::PlayerActions* list = calls_.actions(0, one_);
  ASSERT_NE(list, nullptr);
  EXPECT_EQ(list->actions(0).dash().power(), 80.0F);
  EXPECT_EQ(list->actions(0).dash().relative_direction(), 45.0F);
  EXPECT_TRUE(list->actions(1).has_neck_turn_to_ball_or_scan());
  EXPECT_TRUE(list->ignore_preprocess());

  list = calls_.actions(1, two_);
  ASSERT_NE(list, nullptr);
  EXPECT_EQ(list->actions(0).turn().relative_direction(), 30.0F);
}

TEST_F(TensorCallsTest, RefusesOtherShapesAndRowsThatAreNoAction) {
  ASSERT_TRUE(calls_.choose(team_, response_));
  set_actions({1.0F, 80.0F, 0.0F, 0.0F}, 2, 2);
  EXPECT_EQ(calls_.read(actions_, 3).error().message,
            "actions: 16 bytes of shape [2, 2] are not 3 x 2 float32");
  EXPECT_FALSE(calls_.has_rows());
  actions_.mutable_actions()->mutable_shape()->Set(0, 4);
  EXPECT_FALSE(calls_.read(actions_, 2));

  actions_.Clear();
  EXPECT_TRUE(calls_.read(actions_, 2));
  EXPECT_FALSE(calls_.has_rows());

  set_actions({1.0F, std::numeric_limits<float>::quiet_NaN(), 5.0F, 0.0F}, 2, 2);
  ASSERT_TRUE(calls_.read(actions_, 2));
  EXPECT_EQ(calls_.actions(0, one_), nullptr);
  EXPECT_EQ(calls_.actions(1, two_), nullptr);
}

}  // namespace
}  // namespace cls::proxy

"""Policies as Playmakers: rows in, actions out; what is refused."""
import pathlib
import tempfile
import unittest

import grpc
import numpy as np
from cls_playmaker import Playmaker, RowForm, TeamActions, TeamRows, proto, start
from cls_playmaker import team_playmaker_pb2 as wire
from cls_playmaker import team_playmaker_pb2_grpc as service

import cls_gym
from cls_gym import play
from cls_gym.policy import Policy, PolicyError, describe, load


def policy(obs="world_model", **config):
    """An untrained policy of a 1v1 environment."""
    with cls_gym.VectorEnv("cls/HFO-1v1-v0", 1, obs=obs, features="ego",
                           **{"actions": "low_discrete", **config}) as envs:
        about = describe(envs)
    random = np.random.default_rng(1)
    inputs, outputs = len(about["feature_names"]), len(about["action_names"])
    layers = [(random.standard_normal((inputs, 8)).astype(np.float32), np.zeros(8, np.float32)),
              (random.standard_normal((8, outputs)).astype(np.float32),
               np.zeros(outputs, np.float32))]
    return Policy(layers, about)


def rows(trained, players, play_mode="play_on", distances=None):
    """TeamRows in which player i is distances[i] from the ball."""
    names = trained.about["feature_names"]
    features = np.zeros((len(players), len(names)), "<f4")
    features[:, names.index("ball_seen")] = 1
    features[:, names.index("ball_distance")] = distances or np.arange(len(players)) / 60
    masks = np.ones((len(players), len(trained.about["action_names"])), np.uint8)
    return TeamRows(7, play_mode, list(players), features.tobytes(), masks.tobytes())


class Decisions(unittest.TestCase):
    def setUp(self):
        self.policy = policy()

    def decide(self, request, who="nearest"):
        return play.Decider(self.policy, proto, who).decide(request, TeamActions)

    def skill(self, actions, unum):
        return actions.replies[unum].actions[0].WhichOneof("action")

    def test_the_field_player_nearest_to_the_ball_plays_the_policy(self):
        request = rows(self.policy, [1, 2, 3], distances=[0.01, 0.3, 0.2])
        actions = self.decide(request)
        self.assertEqual(sorted(actions.replies), [1, 2])
        self.assertEqual(self.skill(actions, 1), "helios_goalie")
        self.assertEqual(self.skill(actions, 2), "helios_basic_move")
        ids = np.frombuffer(actions.rows, "<f4").reshape(3, actions.width)
        features = np.frombuffer(request.features, "<f4").reshape(3, -1)
        self.assertEqual(ids[2, 0], self.policy.act(features[2]))

    def test_all_field_players_play_the_policy(self):
        self.assertEqual(sorted(self.decide(rows(self.policy, [1, 2, 3]), "all").replies), [1])

    def test_set_plays_and_penalties_are_skills(self):
        for mode, skill in (("kick_off_l", "helios_set_play"), ("goal_kick_r", "helios_set_play"),
                            ("penalty_taken_l", "helios_penalty")):
            with self.subTest(mode):
                actions = self.decide(rows(self.policy, [1, 2], mode))
                self.assertEqual([self.skill(actions, unum) for unum in (1, 2)], [skill] * 2)
                self.assertEqual(actions.rows, b"")

    def test_no_player_plays_the_policy_while_none_sees_the_ball(self):
        request = rows(self.policy, [1, 2, 3])
        unseen = np.frombuffer(request.features, "<f4").reshape(3, -1).copy()
        unseen[:, self.policy.about["feature_names"].index("ball_seen")] = -1
        actions = self.decide(request._replace(features=unseen.tobytes()))
        self.assertEqual(sorted(actions.replies), [1, 2, 3])

    def test_the_mask_rules_actions_out(self):
        request = rows(self.policy, [2])
        masks = np.zeros((1, 81), np.uint8)
        masks[0, 5] = 1
        actions = self.decide(request._replace(masks=masks.tobytes()))
        self.assertEqual(np.frombuffer(actions.rows, "<f4")[0], 5)


class Files(unittest.TestCase):
    def test_a_policy_says_what_it_needs(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "policy.npz"
            policy().save(path)
            about = load(path).about
            play.check(load(path), str(path), "nearest")
        self.assertEqual((about["obs"], about["teammates"], about["opponents"]),
                         ("world_model", 0, 1))

    def test_a_later_version_is_refused(self):
        trained = policy()
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "policy.npz"
            for schema, error in (("cls.policy/2", r"schema cls\.policy/2 is newer than this cls_gym "
                                                   r"reads \(cls\.policy/1\); update cls$"),
                                  ("cls.match/1", r"schema is not cls\.policy/1$")):
                trained.about["schema"] = schema
                trained.save(path)
                with self.assertRaisesRegex(PolicyError, error):
                    load(path)

    def test_features_without_the_ball_need_all(self):
        trained = policy()
        trained.about["feature_names"] = ["x"] * len(trained.about["feature_names"])
        play.check(trained, "p.npz", "all")
        with self.assertRaisesRegex(PolicyError, "use --who all"):
            play.check(trained, "p.npz", "nearest")

    def test_rated_matches_are_for_the_world_model(self):
        self.assertEqual(play.refusal(policy().about, "p.npz", True), "")
        full = policy(obs="full_state").about
        self.assertEqual(play.refusal(full, "p.npz", False), "")
        self.assertIn("trained with obs='full_state'", play.refusal(full, "p.npz", True))


class Team(Playmaker):
    row_form = RowForm("ego/1", "low_discrete/1", 0, 1)

    def refuses(self, rated):
        return "only for fun" if rated else ""

    def GetTeamRows(self, rows):
        numbers = np.arange(len(rows.players), dtype="<f4")
        return TeamActions(numbers.tobytes(), 1, {2: proto.PlayerActions(ignore_preprocess=True)})


class Wire(unittest.TestCase):
    def setUp(self):
        self.server, self.port = start(Team())
        self.channel = grpc.insecure_channel(f"127.0.0.1:{self.port}")
        self.stub = service.TeamPlaymakerStub(self.channel)

    def tearDown(self):
        self.channel.close()
        self.server.stop(0).wait()

    def register(self, **fields):
        request = wire.RegisterTeamRequest(version=1, encodings=[wire.STATES, wire.TENSOR],
                                           feature_sets=["ego/1"], action_sets=["low_discrete/1"],
                                           server_params=b"", **fields)
        request.agents.add(agent=2, message=proto.RegisterRequest(
            uniform_number=2).SerializeToString())
        return self.stub.RegisterTeam(request, timeout=10)

    def test_chooses_its_form(self):
        response = self.register()
        self.assertEqual(response.agents[0].code, 0)
        self.assertEqual((response.encoding, response.feature_set, response.action_set,
                          response.teammates, response.opponents),
                         (wire.TENSOR, "ego/1", "low_discrete/1", 0, 1))

    def test_refuses_a_rated_match_and_one_without_its_form(self):
        response = self.register(rated=True)
        self.assertEqual((response.agents[0].code, response.agents[0].error),
                         (grpc.StatusCode.FAILED_PRECONDITION.value[0], "only for fun"))
        response = self.stub.RegisterTeam(wire.RegisterTeamRequest(
            version=1, agents=[wire.AgentMessage(agent=2)]), timeout=10)
        self.assertEqual(response.agents[0].error, "needs ego/1; the match has no such form")

    def test_refuses_calls_for_one_agent(self):
        game = proto.GameStub(self.channel)
        with self.assertRaises(grpc.RpcError) as raised:
            game.Register(proto.RegisterRequest(uniform_number=2), timeout=10)
        self.assertIn("needs the calls of a team", raised.exception.details())

    def test_answers_rows_with_rows_and_replies(self):
        request = wire.GetTeamActionsRequest(
            sequence=1, cycle=3, agents=[wire.AgentMessage(agent=unum) for unum in (1, 2)],
            features=wire.Tensor(shape=[2, 1], data=bytes(8)), masks=wire.Tensor(shape=[2, 0]),
            play_mode="play_on")
        response = self.stub.GetTeamActions(request, timeout=10)
        self.assertEqual(list(response.actions.shape), [2, 1])
        self.assertEqual(np.frombuffer(response.actions.data, "<f4").tolist(), [0.0, 1.0])
        self.assertEqual([one.agent for one in response.agents], [2])


if __name__ == "__main__":
    unittest.main()

"""Leagues: results, payoff table, sampling of opponents, self-play."""
import contextlib
import sqlite3
import tempfile
import unittest

import numpy as np

from cls_gym import ConfigError
from cls_gym.league import CONFIG, TASK, League, LeagueError, SelfPlay, play_episodes
from cls_gym.policy import Policy, PolicyError, describe
from cls_gym.vector import VectorEnv


def policy(seed):
    """An untrained policy for the worlds of a league."""
    with VectorEnv(TASK, 1, **CONFIG, agents="both") as envs:
        about = describe(envs)
    random = np.random.default_rng(seed)
    inputs, outputs = len(about["feature_names"]), len(about["action_names"])
    layers = [(random.standard_normal((inputs, 16)).astype(np.float32), np.zeros(16, np.float32)),
              (random.standard_normal((16, outputs)).astype(np.float32),
               np.zeros(outputs, np.float32))]
    return Policy(layers, about)


def chaser():
    """Runs to the ball and kicks it ahead: by the columns of "ego"."""
    with VectorEnv(TASK, 1, **CONFIG, agents="both") as envs:
        about = describe(envs)
    names, actions = about["feature_names"], about["action_names"]
    weight = np.zeros((len(names), len(actions)), np.float32)
    bias = np.full(len(actions), -10, np.float32)
    weight[names.index("ball_cos"), actions.index("dash_100_0")] = 2.0
    bias[actions.index("dash_100_0")] = -1.0
    weight[names.index("ball_sin"), actions.index("turn_30")] = 1.0
    weight[names.index("ball_sin"), actions.index("turn_-30")] = -1.0
    bias[[actions.index("turn_30"), actions.index("turn_-30")]] = 0.0
    weight[names.index("self_kickable"), actions.index("kick_100_8")] = 20.0
    return Policy([(weight, bias)], about)


class Leagues(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.league = League(folder.name, max_cycles=150)
        self.addCleanup(self.league.close)

    def test_a_snapshot_may_be_a_file(self):
        path = self.league.folder / "policy.npz"
        policy(1).save(path)
        self.assertEqual([self.league.add(path), self.league.add(str(path))], [1, 2])

    def test_a_policy_of_other_worlds_is_refused(self):
        with VectorEnv("cls/HFO-1v0-v0", 1, features="ego", actions="low_discrete") as envs:
            about = describe(envs)
        shape = len(about["feature_names"]), len(about["action_names"])
        other = Policy([(np.zeros(shape), np.zeros(shape[1]))], about)
        reason = r"trained with 0 teammates and 0 opponents \(31 features, \d+ actions\), not 1 and 2"
        with self.assertRaisesRegex(PolicyError, reason):
            self.league.add(other)
        with self.assertRaisesRegex(PolicyError, reason):
            SelfPlay([(other, 1)], num_envs=1)

    def test_a_later_version_is_refused(self):
        folder = self.league.folder
        self.league.close()
        League(folder).close()
        with contextlib.closing(sqlite3.connect(folder / "results.sqlite")) as results:
            self.assertEqual(results.execute("pragma user_version").fetchone(), (1,))
            results.execute("pragma user_version = 2")
        with self.assertRaisesRegex(LeagueError, r"results.sqlite: version 2 is newer than this "
                                                 r"cls_gym reads \(1\); update cls$"):
            League(folder)

    def test_payoff_is_an_independent_count(self):
        one, other = self.league.add(chaser()), self.league.add(policy(2))
        self.assertEqual((one, other), (1, 2))
        results = self.league.play(one, other, 200, seed=5)
        self.assertEqual(sum(results), 200)
        config = {**CONFIG, "max_cycles": 150}
        home = play_episodes(chaser(), policy(2), 100, 5, config)
        away = play_episodes(policy(2), chaser(), 100, 105, config)
        won = (home[:, 0] > home[:, 1]).sum() + (away[:, 1] > away[:, 0]).sum()
        drawn = (home[:, 0] == home[:, 1]).sum() + (away[:, 0] == away[:, 1]).sum()
        self.assertEqual((results.wins, results.draws), (won, drawn))
        points = (won + 0.5 * drawn) / 200
        np.testing.assert_allclose(self.league.payoff(), [[0.5, points], [1 - points, 0.5]])
        self.assertEqual(self.league.results(other, one), results[::-1])

    def test_results_outlive_the_object(self):
        for seed in (1, 2):
            self.league.add(policy(seed))
        results = self.league.play(1, 2, 3)
        again = League(self.league.folder)
        self.addCleanup(again.close)
        self.assertEqual(again.results(1, 2), results)
        self.assertEqual(again.numbers(), [1, 2])

    def test_pfsp_prefers_those_that_win(self):
        for seed in (1, 2, 3, 4):
            self.league.add(policy(seed))
        goals = {2: [(3, 0)] * 4, 3: [(0, 1), (1, 0)], 4: [(0, 2)] * 3}  # of 1 against them
        for number, games in goals.items():
            self.league._store(1, number, 1, np.array(games))
        np.testing.assert_allclose(self.league.weights(1), [0.0, 0.0, 0.2, 0.8])
        np.testing.assert_allclose(self.league.weights(1, "uniform"), [0, 1 / 3, 1 / 3, 1 / 3])
        self.assertEqual(self.league.opponent(1, "latest"), 4)
        self.assertEqual(self.league.opponent(4, "latest"), 3)
        drawn = [self.league.opponent(1, random=seed) for seed in range(200)]
        self.assertEqual(set(drawn), {3, 4})
        self.assertGreater(drawn.count(4), 120)
        with self.assertRaisesRegex(ValueError, "pfsp"):
            self.league.weights(1, "best")

    def test_an_opponent_needs_another_snapshot(self):
        self.league.add(policy(1))
        with self.assertRaisesRegex(LeagueError, "no snapshot but 1"):
            self.league.opponent(1)


class SelfPlays(unittest.TestCase):
    def test_learner_has_its_own_rows_and_rewards(self):
        worlds = SelfPlay(policy(1), 4, reward={"possession": 1})
        seen, infos = worlds.reset(1)
        self.assertEqual(seen.shape[:2], (4, 2))
        self.assertEqual(infos["action_mask"].shape, (4, 2, 81))
        for _ in range(30):
            seen, rewards, terminated, _, infos = worlds.step(np.zeros((4, 2), np.int64))
            both = worlds.envs.agent_rewards
            np.testing.assert_array_equal(rewards, both[:, :2])
            np.testing.assert_array_equal(both[:, 0], -both[:, 2])
        worlds.close()

    def test_one_call_per_policy_decides_for_all_its_players(self):
        calls = []

        def chooses(action):
            def act(seen, mask):
                calls.append((action, seen.shape, mask.shape))
                return np.full(len(seen), action)
            return act

        worlds = SelfPlay([(chooses(0), 1), (chooses(1), 3)], 40, task="cls/HalfFieldOffense-v0",
                          offense=2, defense=2, features="ego", actions="low_discrete")
        _, infos = worlds.reset(1)
        drawn = infos["opponent"]
        self.assertTrue(20 <= (drawn == 1).sum() < 40)
        worlds.step(np.zeros((40, 2), np.int64))
        features = worlds.envs.single_observation_space.shape[1]
        self.assertEqual(calls, [(number, (2 * (drawn == number).sum(), features),
                                  (2 * (drawn == number).sum(), 81)) for number in (0, 1)])
        # Each plays in its own worlds alone: standing players stay where they are.
        before = worlds.envs.state()
        for _ in range(5):
            worlds.step(np.zeros((40, 2), np.int64))
        names = [one.name for one in worlds.envs.spec_of_task.state_features]
        moved = np.abs(worlds.envs.state() - before)[:, names.index("right_1_x")] > 1e-6
        np.testing.assert_array_equal(moved, drawn == 1)
        worlds.close()

    def test_opponents_are_drawn_again_by_the_seed_of_the_episode(self):
        def stand(seen, _):
            return np.zeros(len(seen), np.int64)

        def play():
            worlds = SelfPlay([(stand, 1), (stand, 1)], 8, max_cycles=10)
            _, infos = worlds.reset(5)
            drawn = [infos["opponent"]]
            for _ in range(35):
                before = infos["opponent"]
                _, _, terminated, truncated, infos = worlds.step(np.zeros((8, 2), np.int64))
                ended = terminated | truncated
                if ended.any():
                    np.testing.assert_array_equal(infos["final_info"]["opponent"][ended],
                                                  before[ended])
                np.testing.assert_array_equal(infos["opponent"][~ended], before[~ended])
                drawn.append(infos["opponent"])
            worlds.close()
            return np.array(drawn)

        drawn = play()
        np.testing.assert_array_equal(drawn, play())
        self.assertTrue((drawn[0] != drawn[-1]).any())
        self.assertEqual(set(drawn.ravel()), {0, 1})

    def test_teammates_may_be_frozen_too(self):
        rows = []

        def teammate(seen, _):
            rows.append(len(seen))
            return np.ones(len(seen), np.int64)

        worlds = SelfPlay(lambda seen, _: np.zeros(len(seen), np.int64), 3, offense=3, defense=2,
                          task="cls/HalfFieldOffense-v0", features="ego", actions="low_discrete",
                          num_agents=1, teammates=teammate)
        seen, infos = worlds.reset(1)
        self.assertEqual((seen.shape[:2], infos["action_mask"].shape), ((3, 1), (3, 1, 81)))
        worlds.step(np.zeros((3, 1), np.int64))
        self.assertEqual(rows, [6])
        worlds.close()
        with self.assertRaisesRegex(ConfigError, "teammates"):
            SelfPlay(teammate, 3, num_agents=1)
        for pool in ([], [(teammate, 0)], [(teammate, -1), (teammate, 2)]):
            with self.assertRaisesRegex(ConfigError, "weights"):
                SelfPlay(pool, 3)

    def test_a_policy_that_chases_the_ball_scores(self):
        goals = play_episodes(chaser(), chaser(), 60, 1, {**CONFIG, "max_cycles": 300})
        wins = (goals[:, 0] > goals[:, 1]).sum(), (goals[:, 0] < goals[:, 1]).sum()
        self.assertGreater(sum(wins), 0)


if __name__ == "__main__":
    unittest.main()

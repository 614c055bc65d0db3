"""cls_gym with NumPy alone: conventions, determinism, snapshots, faults, rendering."""
import os
import signal
import sys
import tempfile
import threading
import time
import unittest
import warnings

import gym_support  # first: may hide gymnasium
import numpy as np
from gym_support import ACTION_SETS, FULL, TASKS, differences, of_set, seeded_actions

import cls_gym

HFO = "cls/HFO-1v0-v0"


def play(envs, steps, seed=1, action_seed=2):
    """Everything that a vector environment returns."""
    out = [envs.reset(seed=seed)]
    for action in seeded_actions(envs.action_space, action_seed, steps):
        out.append(envs.step(action))
    return out


class Conventions(unittest.TestCase):
    def test_every_task_follows_them(self):
        for task in TASKS:
            with self.subTest(task), cls_gym.Env(task) as env:
                self.check(env, 60)

    def test_every_action_set_follows_them(self):
        for actions in ACTION_SETS:
            with self.subTest(actions), cls_gym.Env(HFO, **of_set(actions)) as env:
                self.check(env, 120)

    def check(self, env, steps):
        space = env.observation_space
        self.assertTrue(np.isfinite(space.low).all() and np.isfinite(space.high).all())
        observation, info = env.reset(seed=3)
        self.assertIn(observation, space)
        self.assertEqual(observation.dtype, np.float32)
        for action in seeded_actions(env.action_space, 1, steps):
            self.assertIn(action, env.action_space)
            observation, reward, terminated, truncated, info = env.step(action)
            self.assertIn(observation, space)
            self.assertIs(type(reward), float)
            self.assertIs(type(terminated), bool)
            self.assertIs(type(truncated), bool)
            self.assertEqual(info["status"] != 0, terminated or truncated)
            self.assertEqual(env.state().shape, (len(env.spec_of_task.state_features),))
            if terminated or truncated:
                observation, info = env.reset()
                self.assertEqual(info["cycles"], 0)

    def test_observations_are_copies(self):
        with cls_gym.Env(HFO) as env:
            first, _ = env.reset(seed=1)
            before = first.copy()
            for action in seeded_actions(env.action_space, 1, 5):
                env.step(action)
            np.testing.assert_array_equal(first, before)

    def test_unknown_option_warns_and_known_one_holds(self):
        with cls_gym.Env(HFO) as env:
            with warnings.catch_warnings(record=True) as found:
                warnings.simplefilter("always")
                env.reset(seed=1, options={"dificulty": 0})
            self.assertIn("'dificulty'", str(found[0].message))
            easy, _ = env.reset(seed=1, options={"difficulty": 0.0})
            again, _ = env.reset(seed=1)
            np.testing.assert_array_equal(easy, again)
            hard, _ = env.reset(seed=1, options={"difficulty": 1.0})
            self.assertFalse(np.array_equal(easy, hard))

    def test_agents_side_by_side(self):
        with cls_gym.Env("cls/HFO-2v1-v0", actions="low_discrete") as env:
            self.assertEqual(env.observation_space.shape[0], 2)
            observation, info = env.reset(seed=1)
            self.assertEqual(info["action_mask"].shape, (2, 81))
            observation, reward, *_ = env.step(np.array([1, 2]))
            self.assertEqual(observation.shape, env.observation_space.shape)
            self.assertIs(type(reward), float)


class Determinism(unittest.TestCase):
    def test_same_seed_gives_same_bits(self):
        steps, seeds = (500, 20) if FULL else (100, 3)
        for task in TASKS:
            with self.subTest(task):
                envs = cls_gym.VectorEnv(task, 2)
                for seed in range(seeds):
                    first = play(envs, steps, seed)
                    self.assertEqual(differences(first, play(envs, steps, seed)), [])
                other = cls_gym.VectorEnv(task, 2)
                self.assertEqual(differences(first, play(other, steps, seeds - 1)), [])
                envs.close()
                other.close()

    def test_threads_do_not_show(self):
        results = []
        for threads in (1, 2, 7):
            with cls_gym.VectorEnv("cls/HFO-2v2-v0", 16, threads=threads) as envs:
                results.append(play(envs, 500 if FULL else 150))
        self.assertEqual(differences(results[0], results[1]), [])
        self.assertEqual(differences(results[0], results[2]), [])

    def test_seeds_differ(self):
        with cls_gym.VectorEnv(HFO, 2) as envs:
            observations, infos = envs.reset(seed=1)
            self.assertFalse(np.array_equal(observations[0], observations[1]))
            self.assertNotEqual(infos["seed"][0], infos["seed"][1])

    def test_reset_without_seed_continues_the_sequence(self):
        with cls_gym.Env(HFO) as env:
            def three():
                return [env.reset(seed=123)[0], env.reset()[0], env.reset()[0]]
            first = three()
            self.assertEqual(differences(first, three()), [])
            self.assertFalse(np.array_equal(first[0], first[1]))


class VectorEqualsSingle(unittest.TestCase):
    """VectorEnv against Env, in the three modes of the end of an episode."""

    COUNT = 5
    STEPS = 10_000 if FULL else 400

    def singles(self, **config):
        return [cls_gym.Env(HFO, **config) for _ in range(self.COUNT)]

    def compare(self, mode, **config):
        config = dict(config, max_cycles=40)
        singles = self.singles(**config)
        envs = cls_gym.VectorEnv(HFO, self.COUNT, autoreset_mode=mode, **config)
        seen, _ = envs.reset(seed=7)
        for i, env in enumerate(singles):
            self.assertEqual(differences(env.reset(seed=7 + i)[0], seen[i]), [])
        ended, ends = np.zeros(self.COUNT, np.bool_), 0
        for batch in seeded_actions(envs.action_space, 4, self.STEPS):
            if mode == "disabled" and ended.any():
                seen, _ = envs.reset(options={"reset_mask": ended})
                for i in np.flatnonzero(ended):
                    self.assertEqual(differences(singles[i].reset()[0], seen[i]), [])
            got = envs.step(batch)
            for i, env in enumerate(singles):
                if mode == "next_step" and ended[i]:
                    observation, info = env.reset()
                    expected = (observation, 0.0, False, False)
                else:
                    action = tuple(part[i] for part in batch) if isinstance(batch, tuple) \
                        else batch[i]
                    observation, reward, *over, info = env.step(action)
                    expected = (observation, reward, *over)
                    if any(over) and mode == "same_step":
                        self.assertEqual(differences(observation, got[4]["final_obs"][i]), [])
                        last = got[4]["final_info"]
                        for key, value in info.items():
                            self.assertEqual(differences(value, last[key][i], key), [])
                        observation, info = env.reset()
                        expected = (observation, reward, *over)
                self.assertEqual(differences(expected[0], got[0][i]), [])
                self.assertEqual(expected[1:], (got[1][i], got[2][i], got[3][i]))
                for key, value in info.items():
                    if not isinstance(value, tuple):  # "action_mask": a vector has "id_mask" alone
                        self.assertEqual(differences(value, got[4][key][i], key), [])
            ended = got[2] | got[3]
            ends += int(ended.sum())
        self.assertGreater(ends, 10)
        for env in (*singles, envs):
            env.close()

    def test_next_step(self):
        self.compare("next_step", actions="low")

    def test_same_step(self):
        self.compare("same_step", actions="low_discrete", features="ego")

    def test_disabled(self):
        self.compare("disabled", actions="low_flat")


class Copies(unittest.TestCase):
    def test_restored_episode_continues_with_the_same_bits(self):
        for task in ("cls/HFO-2v2-v0", "cls/Match-v0"):
            with self.subTest(task), cls_gym.VectorEnv(task, 2) as envs:
                play(envs, 20)
                actions = seeded_actions(envs.action_space, 9, 200)
                saved = [envs.snapshot(0), envs.snapshot(1)]
                first = [envs.step(action)[:4] for action in actions[:1]]
                for index, snapshot in enumerate(saved):
                    envs.restore(index, snapshot)
                self.assertEqual(differences(first, [envs.step(actions[0])[:4]]), [])

    def test_single_episode_is_restored(self):
        with cls_gym.Env(HFO, actions="low_discrete") as env, cls_gym.Env(HFO) as other:
            env.reset(seed=5)
            actions = seeded_actions(env.action_space, 3, 60)
            for action in actions[:20]:
                env.step(action)
            snapshot = env.snapshot()
            first = [env.step(action) for action in actions[20:]]
            for _ in range(2):
                env.restore(snapshot)
                self.assertEqual(differences(first, [env.step(a) for a in actions[20:]]), [])
            other.reset(seed=5)
            other.snapshot()
            self.assertRaisesRegex(cls_gym.EngineError, "another", other.restore, snapshot)

    def test_worlds_of_a_vector_fork(self):
        with cls_gym.VectorEnv(HFO, 3, actions="low_discrete") as envs:
            play(envs, 10)
            envs.fork(0, [1, 2])
            seen = envs.step(np.array([1, 1, 9]))[0]
            np.testing.assert_array_equal(seen[0], seen[1])
            self.assertFalse(np.array_equal(seen[0], seen[2]))

    def test_restored_episode_keeps_its_seed_and_opponent(self):
        with cls_gym.VectorEnv("cls/HFO-1v1-v0", 2, actions="low_discrete", max_cycles=5,
                               opponent={"hold": 1, "scripted": 1},
                               autoreset_mode="same_step") as envs:
            for seed in range(20):
                _, infos = envs.reset(seed=seed)
                if infos["opponent"][0] != infos["opponent"][1]:
                    break
            envs.fork(0, [1])
            last = None
            for _ in range(5):
                step = envs.step(np.zeros(2, np.int64))
                if (step[2] | step[3]).any():
                    last = step[4]["final_info"]
            self.assertEqual(last["seed"].tolist(), [infos["seed"][0]] * 2)
            self.assertEqual(last["opponent"].tolist(), [infos["opponent"][0]] * 2)

    def test_recorded_episode_is_a_game_log(self):
        with tempfile.TemporaryDirectory() as folder, cls_gym.Env(HFO, max_cycles=30) as env:
            path = os.path.join(folder, "episode.rcg")
            env.record(path)
            env.reset(seed=1)
            over = False
            for action in seeded_actions(env.action_space, 1, 40):
                if not over:
                    *_, terminated, truncated, _ = env.step(action)
                    over = terminated or truncated
            env.reset()
            with open(path, "rb") as log:
                self.assertTrue(log.read(4).startswith(b"ULG"))
            self.assertRaises(OSError, lambda: (env.record(os.path.join(folder, "no/way.rcg")),
                                                env.reset(), env.reset()))
            self.assertRaises(ValueError, env.record, os.path.join(folder, "a\0b"))


    @unittest.skipUnless(os.path.exists("/dev/full"), "needs /dev/full")
    def test_recording_that_cannot_be_written_is_an_error_of_close(self):
        env = cls_gym.Env(HFO)
        env.record("/dev/full")
        env.reset(seed=1)
        env.step(env.action_space.sample())
        self.assertRaises(OSError, env.close)
        env.close()


class Faults(unittest.TestCase):
    def test_settings_are_named(self):
        for config, text in (({"obss": "x"}, "obs"), ({"actions": "lo"}, "low"),
                             ({"offense": 99}, "offense"), ({"obs": "all"}, "full_state")):
            with self.subTest(config):
                with self.assertRaisesRegex(cls_gym.ConfigError, text):
                    cls_gym.Env("cls/HalfFieldOffense-v0", **config)
        with self.assertRaisesRegex(cls_gym.ConfigError, "did you mean cls/Half"):
            cls_gym.Env("cls/HalfFieldOfense-v0")
        with self.assertRaisesRegex(cls_gym.ConfigError, "v0 only"):
            cls_gym.Env("cls/HalfFieldOffense-v7")
        with self.assertRaisesRegex(ValueError, "rgb_array"):
            cls_gym.Env(HFO, render_mode="rgb")
        for count in (0, -1, 2.5, True):
            with self.assertRaisesRegex(ValueError, "num_envs"):
                cls_gym.VectorEnv(HFO, count)
        with self.assertRaisesRegex(ValueError, "next_step"):
            cls_gym.VectorEnv(HFO, 2, autoreset_mode="never")

    def test_actions_are_checked(self):
        with cls_gym.Env(HFO, actions="low_flat") as env:
            before, _ = env.reset(seed=1)
            shape = env.action_space.shape
            for action in (np.full(shape, np.nan, np.float32), np.full(shape, np.inf, np.float32),
                           np.zeros((3,), np.float32), np.array(["a"] * shape[0]), None):
                with self.subTest(action), self.assertRaises(cls_gym.ActionError):
                    env.step(action)
            env.step(np.zeros(shape, np.float64))
        with cls_gym.Env(HFO, actions="low_discrete") as env:
            env.reset(seed=1)
            for action in (-1, 81, 2.0, [1, 2], 2**32 + 1, -2**32):
                with self.subTest(action), self.assertRaises(cls_gym.ActionError):
                    env.step(action)
        with cls_gym.Env(HFO, actions="low") as env:
            env.reset(seed=1)
            self.assertRaises(cls_gym.ActionError, env.step, 0)

    def test_order_of_calls(self):
        env = cls_gym.Env(HFO, actions="low_discrete", max_cycles=3)
        self.assertRaises(cls_gym.ResetNeeded, env.step, 0)
        self.assertRaises(cls_gym.ResetNeeded, env.snapshot)
        env.reset(seed=1)
        for _ in range(3):
            over = env.step(0)[3]
        self.assertTrue(over)
        self.assertRaises(cls_gym.ResetNeeded, env.step, 0)
        env.close()
        env.close()
        for call in (lambda: env.step(0), env.reset, env.state, env.snapshot):
            self.assertRaises(cls_gym.ClosedEnvironmentError, call)

    def test_seeds_are_checked(self):
        with cls_gym.VectorEnv(HFO, 2) as envs:
            self.assertRaises(ValueError, envs.reset, seed=[1])
            self.assertRaises(ValueError, envs.reset, seed=[1, -1])
            envs.reset(seed=[4, None])
            self.assertRaises(TypeError, envs.reset, options={"reset_mask": [True, False]})
            self.assertRaises(ValueError, envs.reset,
                              options={"reset_mask": np.zeros(2, np.bool_)})

    def test_child_of_a_fork_needs_its_own(self):
        with cls_gym.VectorEnv(HFO, 4, actions="low_discrete", threads=2) as envs:
            envs.reset(seed=1)
            envs.step(np.zeros(4, np.int64))
            child = os.fork()
            if child == 0:
                code = 1
                try:
                    envs.step(np.zeros(4, np.int64))
                except cls_gym.EngineError as error:
                    code = 0 if "fork" in str(error) or "process" in str(error) else 2
                finally:
                    os._exit(code)
            self.assertEqual(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), 0)
            envs.step(np.zeros(4, np.int64))

    def test_threads_that_share_an_environment_end(self):
        self.addCleanup(sys.setswitchinterval, sys.getswitchinterval())
        sys.setswitchinterval(1e-6)  # between any two bytecodes
        for threads in (1, 2):
            with self.subTest(threads), cls_gym.VectorEnv(HFO, 64, threads=threads) as envs:
                envs.reset(seed=1)
                action = seeded_actions(envs.action_space, 1, 1)[0]
                steps, refused = [0] * 4, [0] * 4

                def play_some(own):
                    for _ in range(300):
                        try:
                            envs.step(action)
                            steps[own] += 1
                        except cls_gym.EngineError as error:
                            self.assertIn("another thread", str(error))
                            refused[own] += 1

                players = [threading.Thread(target=play_some, args=(own,)) for own in range(4)]
                for player in players:
                    player.start()
                for player in players:
                    player.join(60)
                self.assertFalse(any(player.is_alive() for player in players))
                self.assertEqual(sum(steps) + sum(refused), 1200)

    def test_a_step_of_another_thread_is_refused_while_one_runs(self):
        entered, leave = threading.Event(), threading.Event()

        class SlowAction:
            """An array that takes its time."""

            def __array__(self, *_, **__):
                entered.set()
                leave.wait(60)
                return np.zeros(2, np.int64)

        with cls_gym.VectorEnv(HFO, 2, actions="low_discrete") as envs:
            envs.reset(seed=1)
            first = threading.Thread(target=envs.step, args=(SlowAction(),))
            first.start()
            self.assertTrue(entered.wait(60))
            for call in (lambda: envs.step(np.zeros(2, np.int64)), envs.reset):
                self.assertRaisesRegex(cls_gym.EngineError, "another thread", call)
            leave.set()
            first.join(60)
            self.assertEqual(envs.step(np.zeros(2, np.int64))[4]["cycles"].tolist(), [2, 2])

    def test_interrupt_ends_a_loop_and_leaves_the_worlds_whole(self):
        with cls_gym.VectorEnv("cls/Match-v0", 8) as envs:
            envs.reset(seed=1)
            action = seeded_actions(envs.action_space, 1, 1)[0]
            timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
            timer.start()
            with self.assertRaises(KeyboardInterrupt):
                end = time.monotonic() + 60
                while time.monotonic() < end:
                    envs.step(action)
            envs.step(action)

    def test_two_environments_are_independent(self):
        one, other = cls_gym.VectorEnv(HFO, 3), cls_gym.VectorEnv(HFO, 3)
        alone = play(one, 50)
        self.assertEqual(differences(alone, play(other, 50)), [])
        one.close()
        play(other, 50)
        other.close()


class WorldModel(unittest.TestCase):
    """What agents perceive themselves, obs="world_model"."""

    def test_every_feature_set_keeps_its_bounds(self):
        for features in ("ego", "hfo_low", "hfo_high"):
            with self.subTest(features), cls_gym.Env(
                    "cls/HFO-2v2-v0", obs="world_model", features=features, actions="hfo") as env:
                self.assertEqual(env.spec_of_task.document["obs"], "world_model")
                Conventions.check(self, env, 60)

    def test_same_seed_gives_same_bits_on_any_number_of_threads(self):
        results = []
        for threads in (1, 2, 3):
            with cls_gym.VectorEnv("cls/HFO-2v2-v0", 6, obs="world_model", threads=threads) as envs:
                results.append(play(envs, 60))
                self.assertEqual(differences(results[-1], play(envs, 60)), [])
        self.assertEqual(differences(results[0], results[1]), [])
        self.assertEqual(differences(results[0], results[2]), [])

    def test_snapshots_have_the_world_model(self):
        with cls_gym.Env("cls/HFO-2v2-v0", obs="world_model", actions="low_discrete") as env:
            env.reset(seed=4)
            actions = seeded_actions(env.action_space, 1, 40)
            for action in actions[:15]:
                env.step(action)
            snapshot = env.snapshot()
            first = [env.step(action) for action in actions[15:]]
            env.restore(snapshot)
            self.assertEqual(differences(first, [env.step(a) for a in actions[15:]]), [])

    def test_agents_know_less_than_the_full_state(self):
        observed = {}
        for obs in ("full_state", "world_model"):
            with cls_gym.VectorEnv("cls/HFO-2v2-v0", 8, obs=obs, features="ego") as envs:
                observed[obs], _ = envs.reset(seed=1)
                names = [feature.name for feature in envs.spec_of_task.features]
        others = [names.index(f"{who}_seen") for who in ("teammate1", "opponent1", "opponent2")]
        self.assertTrue((observed["full_state"][..., others] == 1).all())
        self.assertTrue((observed["world_model"][..., others] == -1).any())
        own = slice(0, 4)  # place and direction: noisy, and near the truth
        error = np.abs(observed["full_state"][..., own] - observed["world_model"][..., own])
        self.assertGreater(error.max(), 0.0)
        self.assertLess(error.max(), 0.05)


class Rendering(unittest.TestCase):
    def test_images(self):
        with cls_gym.Env("cls/HFO-2v1-v0", render_mode="ansi") as env:
            env.reset(seed=1)
            lines = env.render().splitlines()
            self.assertEqual(len(lines), 28)
            self.assertLessEqual(max(map(len, lines)), 80)
            self.assertIn("o", env.render())
        with cls_gym.VectorEnv("cls/Match-v0", 2, render_mode="rgb_array") as envs:
            envs.reset(seed=1)
            images = envs.render()
            self.assertEqual([image.shape for image in images], [(608, 904, 3)] * 2)
            self.assertEqual(images[0].dtype, np.uint8)


class Until(unittest.TestCase):
    CONFIG = {"features": "ego", "actions": "skills", "num_agents": 3, "opponent": "scripted"}

    def test_step_ends_where_something_is_to_decide(self):
        one = cls_gym.Env("cls/Match-v0", state=2, **self.CONFIG)
        many = cls_gym.Env("cls/Match-v0", state=2, frame_skip=20, until="decision", **self.CONFIG)
        names = [feature.name for feature in one.spec_of_task.features]
        can_kick = names.index("self_kickable")
        lengths = []
        for env in (one, many):
            env.reset(seed=3)
        for action in seeded_actions(one.action_space, 1, 80):
            reward, length = 0.0, 0
            before = many.view().cycle
            seen, total, ended, cut, info = many.step(action)
            while length < info["cycles"] - before:
                mode = one.view().play_mode
                plain, part, *_ = one.step(action)
                reward, length = reward + part, length + 1
                due = plain[:, can_kick].max() > 0 or one.view().play_mode != mode
                if due:
                    self.assertEqual(length, info["cycles"] - before, "the step ends here")
            lengths.append(length)
            np.testing.assert_array_equal(plain, seen)
            self.assertAlmostEqual(reward, total, 5)
            if ended or cut:
                break
        self.assertLess(min(lengths), 20)
        self.assertGreater(np.mean(lengths), 2)

    def test_it_is_part_of_what_an_episode_depends_on(self):
        with cls_gym.Env("cls/HFO-2v1-v0", frame_skip=20, until="decision") as env:
            self.assertEqual(env.spec_of_task.document["until"], "decision")
        for config, text in (({"until": "decision"}, "'until' = 'decision' needs 'frame_skip'"),
                             ({"until": "decisions"}, "until.*decision")):
            with self.assertRaisesRegex(cls_gym.ConfigError, text):
                cls_gym.Env("cls/HFO-2v1-v0", **config)


if __name__ == "__main__":
    unittest.main()

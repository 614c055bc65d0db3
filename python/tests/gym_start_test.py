"""Where episodes start: situations of a book by seed, and states that the caller gives."""
import copy
import json
import os
import pathlib
import pickle
import tempfile
import unittest

import gym_support  # first: may hide gymnasium
import numpy as np
from gym_support import differences, seeded_actions

import cls_gym

MATCH = "cls/Match-v0"
EXAMPLE = pathlib.Path(__file__).resolve().parents[2] / "fixtures/fuzz/user_file/book"
WARM_UP = 3
SITUATIONS = 12


def frame(number, step):
    """Ball and players of a situation: at places that its number and the step tell."""
    ball = [float(number), 5.0 + 0.5 * step, 0.0, 0.5]
    players = []
    for slot in range(22):
        side = 1 if slot < 11 else -1
        players += [side * (-40 + 3.0 * (slot % 11)), -20 + 3.5 * (slot % 11), 0.1 * side, 0.0,
                    float(slot)]
    return ball + players


def book():
    """The text of a book, whose situation k has the ball at x = k at the moment."""
    with open(EXAMPLE, encoding="utf-8") as file:
        header = json.loads(file.readline().lstrip("b"))
    header.update(warm_up=WARM_UP, logs=header["logs"][:1])
    lines = [header]
    for number in range(SITUATIONS):
        lines.append({"class": "attack", "log": 0, "time": 100 + number, "score": [2, 1],
                      "mode": "corner_kick_l" if number == 0 else "play_on",
                      "players": [[0, 4000.0 + slot, 0.9, 0.95, 100000.0] for slot in range(22)],
                      "frames": [frame(number, step) for step in range(WARM_UP + 1)]})
    return "".join(json.dumps(line) + "\n" for line in lines)


def members(world):
    """A World as numbers and texts by name."""
    own = {name: getattr(world, name) for name, *_ in world._fields_
           if name not in ("players", "score", "struct_size")}
    own["score"] = tuple(world.score)
    for slot, player in enumerate(world.players):
        own.update({f"{slot}.{name}": getattr(player, name) for name, _ in player._fields_})
    return own


class Case(unittest.TestCase):
    def assert_same_world(self, a, b):
        a, b = members(a), members(b)
        for name, value in a.items():
            if name.endswith((".body", ".neck")):
                self.assertAlmostEqual(value, b[name], 10, name)
            else:
                self.assertEqual(value, b[name], name)


class Books(Case):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.file = os.path.join(folder.name, "moments.book")
        pathlib.Path(self.file).write_text(book(), "utf-8")
        self.start = "book:" + self.file

    def env(self, **more):
        env = cls_gym.Env(MATCH, start=self.start, **{"actions": "low_discrete", **more})
        self.addCleanup(env.close)
        return env

    def drawn(self, env, seed):
        env.reset(seed=seed)
        return env.view().ball_x

    def test_seed_draws_a_situation(self):
        env, other = self.env(), self.env()
        first = [self.drawn(env, seed) for seed in range(60)]
        self.assertEqual(first, [self.drawn(other, seed) for seed in range(60)])
        self.assertEqual(set(first), set(range(SITUATIONS)), "all situations are drawn")
        self.assertEqual(env.spec_of_task.document["start"], self.start)

    def test_episode_starts_as_recorded(self):
        env = self.env()
        observation, info = env.reset(seed=next(s for s in range(99) if self.drawn(env, s) == 4))
        world = env.view()
        self.assertEqual((world.ball_x, world.ball_y), (4.0, 5.0 + 0.5 * WARM_UP))
        self.assertEqual((world.play_mode, tuple(world.score)), (b"play_on", (0, 0)))
        player = world.players[12]
        self.assertEqual((player.x, player.y, player.vx), (37.0, -16.5, -0.1))
        self.assertAlmostEqual(player.body, 12.0, 10)
        self.assertEqual((player.stamina, player.effort, player.capacity), (4012, 0.9, 100000))
        self.assertEqual((int(info["cycles"]), info["score"].tolist()), (0, [0, 0]))
        self.assertIn(observation, env.observation_space)

    def test_set_play_is_in_its_mode(self):
        env = self.env()
        while self.drawn(env, None) != 0:
            pass
        self.assertEqual(env.view().play_mode, b"corner_kick_l")

    def test_automatic_resets_draw_too(self):
        for mode in ("next_step", "same_step"):
            with cls_gym.VectorEnv(MATCH, 3, start=self.start, actions="low_discrete", max_cycles=2,
                                   autoreset_mode=mode) as envs:
                envs.reset(seed=1)
                seen = set()
                for action in seeded_actions(envs.action_space, 1, 40):
                    infos = envs.step(action)[4]
                    seen |= {envs.view(i).ball_x for i in range(3) if infos["cycles"][i] == 0}
            self.assertGreater(len(seen), 6, mode)

    def test_those_who_perceive_know_what_led_to_the_moment(self):
        env = self.env(obs="world_model", opponent="planner", features="ego/2")
        again = self.env(obs="world_model", opponent="planner", features="ego/2")
        seed = next(s for s in range(99) if self.drawn(env, s) == 4)
        full = self.env(features="ego/2").reset(seed=seed)[0]
        observation, _ = env.reset(seed=seed)
        self.assertFalse(differences(observation, again.reset(seed=seed)[0]))
        self.assertEqual(env.view().ball_x, 4.0)
        names = [one.name for one in env.spec_of_task.features]
        seen = [i for i, name in enumerate(names) if name.startswith(("teammate", "opponent"))
                and name.endswith("_seen")]
        play_on = next((i for i, name in enumerate(names) if "play_on" in name), None)
        self.assertIsNotNone(play_on, names)
        np.testing.assert_array_equal(observation[:, play_on], full[:, play_on])
        if seen:
            self.assertGreater(observation[:, seen].mean(), 0.5)
        for action in seeded_actions(env.action_space, 1, 30):
            self.assertFalse(differences(env.step(action), again.step(action)))

    def test_copies_start_there(self):
        env = self.env()
        env.reset(seed=3)
        for action in seeded_actions(env.action_space, 1, 5):
            env.step(action)
        twin = pickle.loads(pickle.dumps(env))
        self.addCleanup(twin.close)
        self.assert_same_world(env.view(), twin.view())
        for action in seeded_actions(env.action_space, 2, 5):
            self.assertFalse(differences(env.step(action), twin.step(action)))

    def test_faults_name_the_keyword(self):
        for task, start, text in (
                (MATCH, "book", "'start' must be 'task' or 'book:FILE', not 'book'"),
                (MATCH, "book:none.book", "none.book"),
                ("cls/HFO-1v0-v0", self.start, "'start': the task HalfFieldOffense has")):
            with self.assertRaisesRegex(cls_gym.ConfigError, text):
                cls_gym.Env(task, start=start)
        pathlib.Path(self.file).write_text(book().replace("corner_kick_l", "time_over"), "utf-8")
        with self.assertRaisesRegex(ValueError, "start.*moments.book: line 2: 'mode'"):
            cls_gym.Env(MATCH, start=self.start)


class States(Case):
    def played(self, task, steps=25, **config):
        env = cls_gym.Env(task, actions="low_discrete", features="ego", **config)
        self.addCleanup(env.close)
        env.reset(seed=5)
        for action in seeded_actions(env.action_space, 1, steps):
            if env.step(action)[2]:
                break
        return env

    def test_round_trip(self):
        for task, config in (("cls/HFO-2v1-v0", {}), (MATCH, {}), (MATCH, {"types": "random"}),
                             ("cls/HFO-2v1-v0", {"obs": "world_model", "opponent": "mock"})):
            with self.subTest(task, **config):
                env = self.played(task, **config)
                world = env.view()
                other = cls_gym.Env(task, actions="low_discrete", features="ego", **config)
                self.addCleanup(other.close)
                observation, info = other.set_state(world)
                self.assert_same_world(world, other.view())
                self.assertEqual(info["cycles"], world.cycle)
                np.testing.assert_allclose(other.state(), env.state(), atol=1e-6)
                if not config.get("obs"):
                    np.testing.assert_allclose(observation, env._worlds.observe(0), atol=1e-5)

    def test_same_state_and_actions_give_the_same_bits(self):
        env = self.played("cls/HFO-2v1-v0")
        world = env.view()
        a, b = (cls_gym.Env("cls/HFO-2v1-v0", actions="low_discrete", features="ego") for _ in range(2))
        self.assertFalse(differences(a.set_state(world), b.set_state(world)))
        for action in seeded_actions(a.action_space, 3, 20):
            self.assertFalse(differences(a.step(action), b.step(action)))

    def test_changed_members_hold(self):
        env = self.played(MATCH, steps=60)
        world = copy.copy(env.view())
        world.ball_x, world.ball_y, world.ball_vx, world.ball_vy = 51.0, 0.0, 2.5, 0.0
        world.play_mode, world.last_touch, world.players[21].on_pitch = b"play_on", 10, 0
        for player in world.players:
            player.y = abs(player.y) + 10
        env.set_state(world)
        self.assertEqual(env.view().players[21].on_pitch, 0)
        stand = np.zeros_like(env.action_space.sample())
        _, reward, *_, info = env.step(stand)
        self.assertEqual((reward, info["score"].tolist()), (1.0, [1, 0]))

    def test_copies_and_snapshots_start_there(self):
        env = self.played("cls/HFO-2v1-v0")
        world = env.view()
        world.ball_x = 40.0
        env.set_state(world)
        for action in seeded_actions(env.action_space, 3, 4):
            env.step(action)
        twin = pickle.loads(pickle.dumps(env))
        third = cls_gym.Env("cls/HFO-2v1-v0", actions="low_discrete", features="ego")
        third.reset(seed=1)
        third.restore(pickle.loads(pickle.dumps(env.snapshot())))
        for action in seeded_actions(env.action_space, 4, 4):
            step = env.step(action)
            self.assertFalse(differences(step, twin.step(action)))
            self.assertFalse(differences(step, third.step(action)))
        env.reset(seed=9)
        plain = cls_gym.Env("cls/HFO-2v1-v0", actions="low_discrete", features="ego")
        plain.reset(seed=9)
        self.assert_same_world(env.view(), plain.view())

    def test_end_of_an_episode_is_a_start(self):
        env = cls_gym.Env("cls/HFO-2v1-v0", actions="low_discrete", max_cycles=5)
        self.addCleanup(env.close)
        env.reset(seed=1)
        for action in seeded_actions(env.action_space, 1, 5):
            ended = any(env.step(action)[2:4])
        self.assertTrue(ended)
        world = env.view()
        world.cycle = 2
        env.set_state(world)
        self.assertEqual((env.view().status, env.view().cycle), (0, 2))
        self.assertEqual(env.step(action)[4]["cycles"], 3)

    def test_one_world_of_many(self):
        env = self.played("cls/HFO-2v1-v0")
        world = env.view()
        with cls_gym.VectorEnv("cls/HFO-2v1-v0", 3, actions="low_discrete") as envs:
            observations, _ = envs.reset(seed=1)
            row = envs.set_state(1, world)
            self.assert_same_world(world, envs.view(1))
            np.testing.assert_array_equal(row, envs._worlds.observations[1])
            np.testing.assert_array_equal(observations[2], envs._worlds.observations[2])

    def test_faults_name_the_member(self):
        env = self.played("cls/HFO-2v1-v0")
        before = env.state()
        for change, text in ((lambda w: setattr(w, "ball_x", float("nan")), "ball_x: nan"),
                             (lambda w: setattr(w.players[10], "stamina", 9000.0),
                              r"players\[10\].stamina: 9000 is not between 0 and 8000"),
                             (lambda w: setattr(w, "play_mode", b"corner_kick_l"),
                              "play_mode: an episode of HalfFieldOffense cannot start in corner"),
                             (lambda w: setattr(w, "play_mode", b"soccer"), "'soccer' is not a"),
                             (lambda w: setattr(w, "cycle", 10 ** 6), "cycle")):
            world = env.view()
            change(world)
            with self.assertRaisesRegex(cls_gym.ConfigError, "set_state: .*" + text):
                env.set_state(world)
        np.testing.assert_array_equal(env.state(), before)
        with self.assertRaisesRegex(TypeError, "a World, as view"):
            env.set_state({"ball_x": 1})
        with self.assertRaises(cls_gym.ResetNeeded):
            cls_gym.Env("cls/HFO-2v1-v0").view()


if __name__ == "__main__":
    unittest.main()

"""examples/training/learn_team.py: its gradient, and its stages from matches to a policy."""
import argparse
import contextlib
import io
import os
import pathlib
import sys
import tempfile
import unittest

from gym_support import differences  # noqa: F401  first: may hide gymnasium
import numpy as np

from cls_gym import network

SOURCE = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCE / "examples/training"))
import learn_team  # noqa: E402


class Gradient(unittest.TestCase):
    def test_is_the_change_of_the_loss(self):
        random = np.random.default_rng(1)
        zeros, ones = np.zeros(learn_team.FEATURES), np.ones(learn_team.FEATURES)
        net = learn_team.make_network({}, zeros, ones, random)
        for step in net.steps:
            step.weights = [one.astype(np.float64) for one in step.weights]
        observed = random.normal(size=(3, learn_team.FEATURES))
        wanted = random.normal(size=(3, 1, learn_team.OPTIONS))
        gradients = learn_team.backward(net, learn_team.forward(net, observed), wanted)
        self.assertEqual(len(gradients), sum(step.kind == "dense" for step in net.steps))

        for step in net.steps:
            for i, gradient in enumerate(gradients.get(step.name, [])):
                where = tuple(random.integers(size) for size in gradient.shape)
                losses = []
                for change in (1e-5, -1e-5):
                    step.weights[i][where] += change
                    losses.append((learn_team.forward(net, observed)["scores"] * wanted).sum())
                    step.weights[i][where] -= change
                slope = (losses[0] - losses[1]) / 2e-5
                self.assertAlmostEqual(float(slope), float(gradient[where]), 4, step.name)


class Stages(unittest.TestCase):
    def test_lead_from_matches_to_a_policy(self):
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()):
            out = pathlib.Path(folder, "team.policy")
            matches = dict(opponent="self", matches=10, worlds=5, cycles=250)
            planner = argparse.Namespace(out=pathlib.Path(folder, "planner"), policy="planner",
                                         expert="planner", seed=5, **matches)
            learn_team.record(planner)
            files = sorted(planner.out.iterdir())
            self.assertEqual([one.name for one in files],
                             ["self-0000005.npz", "self-0000010.npz"])
            before = [one.stat().st_mtime_ns for one in files]
            learn_team.record(planner)  # nothing is left to do
            self.assertEqual([one.stat().st_mtime_ns for one in files], before)

            data = learn_team.read([planner.out])
            match, observed, masks, expert = data
            self.assertEqual(set(match), set(range(5, 15)))
            self.assertTrue(masks[np.arange(len(expert)), expert].all())

            learn_team.clone(argparse.Namespace(data=[planner.out], out=out, seed=1, epochs=2,
                                                rate=0.001, decay=0.02))
            net = network.load(out)
            top1, top3, loss = learn_team.agreement(net, observed, masks, expert)
            self.assertGreater(top3, 0.3)
            self.assertGreaterEqual(top3, top1)
            exact = net.exact_scores(observed[:5])
            np.testing.assert_allclose(net.scores(observed[:5]), exact, rtol=1e-3, atol=1e-4)

            learn_team.record(argparse.Namespace(out=pathlib.Path(folder, "round1"), seed=5,
                                                 policy=str(out), expert="planner", **matches))
            own = learn_team.read([planner.out, pathlib.Path(folder, "round1")])
            self.assertGreater(len(own[3]), len(expert))


class Improvement(unittest.TestCase):
    def test_advantages_are_the_errors_of_the_critic_to_come(self):
        experience = learn_team.Experience(None, 1.0, None)
        for worlds, rewards in (([0, 1], [0, 0]), ([0], [1, 0]), ([1], [0, -1])):
            experience.see(np.array(worlds))
            experience.pay(np.array(rewards))
        advantage, target = experience.advantages(np.array([0.5, 0.25, 0.0, 0.0]), 0.5, 1.0)
        np.testing.assert_allclose(target, [0.5, -0.5, 1.0, -1.0])
        np.testing.assert_allclose(advantage, target - [0.5, 0.25, 0.0, 0.0])

    def test_makes_what_earns_more_likely(self):
        random = np.random.default_rng(1)
        zeros, ones = np.zeros(learn_team.FEATURES), np.ones(learn_team.FEATURES)
        net = learn_team.make_network({}, zeros, ones, random)
        first = learn_team.writable(network.Network(net.steps, {}))
        observed = random.normal(size=(64, learn_team.FEATURES)).astype(np.float32)
        masks = np.zeros((64, learn_team.OPTIONS), bool)
        masks[:, 1:5] = True
        played = learn_team.probabilities(learn_team.forward(net, observed)["scores"][:, 0], masks)
        chosen = np.arange(64) % 4 + 1
        earned = (chosen == 3).astype(float)
        settings = argparse.Namespace(epochs=3, temperature=1.0, near=0.0, rate=0.001)
        moved = learn_team.fit_policy(net, first, (observed, masks, chosen, played), earned,
                                      settings, random)
        now = learn_team.probabilities(learn_team.forward(net, observed)["scores"][:, 0], masks)
        self.assertGreater(moved, 0)
        self.assertGreater((now - played)[:, 3].mean(), 0.01)

    def test_goes_on_where_it_stopped(self):
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()):
            files = {}
            for name, stops in (("whole", (2,)), ("halves", (1, 2))):
                out = pathlib.Path(folder, name + ".policy")
                for updates in stops:
                    learn_team.improve(argparse.Namespace(
                        policy=str(SOURCE / "match/terms/learned.policy"), out=out, seed=1,
                        updates=updates, matches=2, worlds=2, cycles=250, opponent="planner",
                        epochs=2, rate=0.0001, temperature=0.5, near=0.1, advance=0.005))
                files[name] = out.read_bytes()
            self.assertEqual(files["whole"], files["halves"])
            self.assertNotEqual(files["whole"],
                                (SOURCE / "match/terms/learned.policy").read_bytes())


@unittest.skipUnless("CLS_BINARY" in os.environ, "no cls to play matches with: set CLS_BINARY")
class Playmakers(unittest.TestCase):
    def record(self, folder, **settings):
        options = dict(out=pathlib.Path(folder, "data"), expert="playmaker:mock:example",
                       policy="planner", opponent="self", matches=3, cycles=1500, seed=7,
                       cls=os.environ["CLS_BINARY"])
        options.update(settings)
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            learn_team.record(argparse.Namespace(**options))
        return options["out"], said.getvalue()

    def test_are_cloned(self):
        with tempfile.TemporaryDirectory() as folder:
            data, said = self.record(folder)
            self.assertIn("choices; like no option: ", said)
            self.assertEqual(self.record(folder)[1], "", "nothing is left to do")
            match, observed, masks, expert = learn_team.read([data])
            self.assertEqual(set(match), {7, 8, 9})
            self.assertTrue(masks[np.arange(len(expert)), expert].all())

            out = pathlib.Path(folder, "mine.policy")
            with contextlib.redirect_stdout(io.StringIO()):
                learn_team.clone(argparse.Namespace(data=[data], out=out, seed=1, epochs=20,
                                                    rate=0.001, decay=0.02))
            held = match == 9
            top1, _, _ = learn_team.agreement(network.load(out), observed[held], masks[held],
                                              expert[held])
            by_chance = float((1 / masks[held].sum(1)).mean())
            self.assertGreater(held.sum(), 50)
            self.assertGreater(top1, 2 * by_chance)

    def test_are_not_asked_about_the_play_of_others(self):
        for wrong in (dict(policy="random"), dict(expert="nobody"), dict(expert="playmaker:")):
            with tempfile.TemporaryDirectory() as folder, self.assertRaises(SystemExit) as refused:
                self.record(folder, **wrong)
            self.assertIn("--expert is planner, or playmaker:SIDE", str(refused.exception))


if __name__ == "__main__":
    unittest.main()

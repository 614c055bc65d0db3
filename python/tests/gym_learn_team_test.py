"""examples/training/learn_team.py: its gradient, and its stages from matches to a policy."""
import argparse
import contextlib
import io
import pathlib
import sys
import tempfile
import unittest

from gym_support import differences  # noqa: F401  first: may hide gymnasium
import numpy as np

from cls_gym import network

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "examples/training"))
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
                                         seed=5, **matches)
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
                                                 policy=str(out), **matches))
            own = learn_team.read([planner.out, pathlib.Path(folder, "round1")])
            self.assertGreater(len(own[3]), len(expert))


if __name__ == "__main__":
    unittest.main()

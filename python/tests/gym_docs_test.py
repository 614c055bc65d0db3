"""Every example of a docstring in python/ runs and prints what it says; those of training.md run."""
import contextlib
import doctest
import importlib
import io
import os
import pathlib
import pkgutil
import re
import shutil
import tempfile
import unittest

import gym_support  # noqa: F401  first: may hide gymnasium
import numpy as np

import cls_gym
from cls_gym.league import CONFIG, TASK
from cls_gym.policy import Policy, describe

CLS = os.environ.get("CLS_BINARY") or shutil.which("cls")
GUIDE = pathlib.Path(__file__).resolve().parents[2] / "docs/training.md"


def modules():
    """The names of all modules of the packages that can be imported here."""
    names = [f"cls_gym.{one.name}" for one in pkgutil.iter_modules(cls_gym.__path__)] + ["cls_gym"]
    try:
        import cls_playmaker
    except ImportError:
        return names
    return names + ["cls_playmaker"] + [
        f"cls_playmaker.{one.name}" for one in pkgutil.iter_modules(cls_playmaker.__path__)]


def skip(name):
    """Why examples of a module do not run here; None: they do."""
    if name == "cls_gym.match" and (not CLS or "cls_playmaker" not in modules()):
        return "no cls and cls_playmaker"
    for module, package in (("cls_gym.parallel", "pettingzoo"), ("cls_gym.data", "pyarrow")):
        if name == module:
            try:
                importlib.import_module(package)
            except ImportError:
                return f"no {package}"
    return None


class Examples(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)
        if CLS:
            before = os.environ["PATH"]
            self.addCleanup(os.environ.__setitem__, "PATH", before)
            os.environ["PATH"] = os.path.dirname(CLS) + os.pathsep + before

    def test_docstrings(self):
        ran = {}
        for name in modules():
            reason = skip(name)
            with self.subTest(name):
                if reason:
                    self.skipTest(f"{name}: {reason}")
                out = io.StringIO()
                with contextlib.redirect_stdout(out):
                    failed, ran[name] = doctest.testmod(importlib.import_module(name))
                self.assertEqual(failed, 0, out.getvalue())
        for name in ("cls_gym", "cls_gym.env", "cls_gym.vector", "cls_gym.hfo", "cls_gym.league"):
            self.assertGreater(ran[name], 0, name)

    def test_no_docstring_has_code_that_does_not_run(self):
        for name in modules():
            if skip(name):
                continue
            with self.subTest(name):
                source = pathlib.Path(importlib.import_module(name).__file__).read_text("utf-8")
                for text in re.findall(r'"""(.*?)"""', source, re.DOTALL):
                    self.assertNotRegex(text, r"(?m)^ +(import |from \w+ import |env\w* = )")

    def test_guide(self):
        """Blocks of a section share their names; those of matches and files are left out."""
        names = {"policy": zeros}
        for number, name in enumerate(("first.npz", "second.npz")):
            constant(number).save(name)
        blocks = re.findall(r"```python\n(.*?)```", GUIDE.read_text("utf-8"), re.DOTALL)
        ran = 0
        for block in blocks:
            if any(word in block for word in ("MatchEnv", "data.record", "duckdb")):
                continue
            with self.subTest(block), contextlib.redirect_stdout(io.StringIO()):
                exec(compile(block, "training.md", "exec"), names)
                ran += 1
        self.assertGreaterEqual(ran, 4)


def constant(number):
    """A policy for the worlds of a league."""
    with cls_gym.VectorEnv(TASK, 1, **CONFIG, agents="both") as envs:
        about = describe(envs)
    shape = len(about["feature_names"]), len(about["action_names"])
    return Policy([(np.full(shape, number), np.zeros(shape[1]))], about)


def zeros(observations, masks):
    """A policy."""
    return np.zeros(len(observations), np.int64)


if __name__ == "__main__":
    unittest.main()

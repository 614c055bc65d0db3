"""What the tests of cls_gym share."""
import os
import sys

if os.environ.get("CLS_TEST_WITHOUT_GYMNASIUM"):
    sys.modules["gymnasium"] = None  # import fails, as where it is not installed

import numpy as np  # noqa: E402

import cls_gym  # noqa: E402

FULL = bool(os.environ.get("CLS_FULL"))
TASKS = [f"cls/{task['id']}-v{task['version']}" for task in cls_gym.catalog()["tasks"]]
ACTION_SETS = [entry.get("name") or entry.get("set") for entry in cls_gym.catalog()["action_sets"]]


def of_set(actions):
    """Keywords of an environment with this action set."""
    return {"actions": actions, **({"obs": "world_model"} if actions == "options" else {})}


def seeded_actions(space, seed, count):
    """Random actions that depend on the seed alone."""
    space.seed(seed)
    return [space.sample() for _ in range(count)]


def differences(a, b, path=""):
    """Where two results differ in type, shape or a bit: a list of paths."""
    if isinstance(a, dict):
        found = [f"{path}/{key}: on one side only" for key in set(a) ^ set(b)]
        return found + [text for key in set(a) & set(b)
                        for text in differences(a[key], b[key], f"{path}/{key}")]
    if isinstance(a, (tuple, list)):
        return [text for place, pair in enumerate(zip(a, b))
                for text in differences(*pair, f"{path}/{place}")]
    if a is None or b is None:
        return [] if a is b else [f"{path}: {a!r} and {b!r}"]
    a, b = np.asarray(a), np.asarray(b)
    if a.dtype == object and b.dtype == object and a.shape == b.shape:
        return [text for place, pair in enumerate(zip(a, b))
                for text in differences(*pair, f"{path}/{place}")]
    same = a.dtype == b.dtype and a.shape == b.shape and a.tobytes() == b.tobytes()
    return [] if same else [f"{path}: {a!r} and {b!r}"]

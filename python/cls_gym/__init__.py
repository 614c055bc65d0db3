"""Reinforcement learning on the soccer simulator of cls.

>>> import cls_gym
>>> envs = cls_gym.VectorEnv("cls/HFO-1v0-v0", num_envs=64, obs="full_state")

Env is a gymnasium.Env, VectorEnv a gymnasium.vector.VectorEnv, ParallelEnv a PettingZoo
environment, cls_gym.hfo the interface of HFO. All need NumPy; Gymnasium and PettingZoo are used
where they are installed (ParallelEnv, gym.make). docs/training.md leads to a trained policy.
"""
from __future__ import annotations

from typing import Any

from cls_gym._api import AutoresetMode, ClosedEnvironmentError, ResetNeeded
from cls_gym._config import ActionError, ConfigError, EngineError, KeywordError
from cls_gym._engine import World, catalog, version
from cls_gym._history import Snapshot
from cls_gym.env import Env
from cls_gym.pipeline import Pipeline
from cls_gym.tasks import ids
from cls_gym.vector import VectorEnv

__all__ = ["ActionError", "AutoresetMode", "ClosedEnvironmentError", "ConfigError", "EngineError",
           "Env", "KeywordError", "ParallelEnv", "Pipeline", "ResetNeeded", "Snapshot", "VectorEnv",
           "World", "catalog", "ids", "make_env", "make_vector_env", "version"]


def make_env(**keywords: Any) -> Env:
    """Env by keywords: the entry point of gymnasium.make() and of make_vec() with the modes "sync"
    and "async"."""
    return Env(**keywords)


def make_vector_env(**keywords: Any) -> VectorEnv:
    """VectorEnv by keywords: the entry point of make_vec() with "vector_entry_point"."""
    return VectorEnv(**keywords)


def _register() -> None:
    """Makes the ids known to gymnasium.make() and make_vec()."""
    from gymnasium.envs.registration import (  # type: ignore[import-not-found,unused-ignore]
        register, registry)
    for id in ids():
        if id not in registry:
            register(id, entry_point="cls_gym:make_env",
                     vector_entry_point="cls_gym:make_vector_env", kwargs={"task": id})


def __getattr__(name: str) -> Any:
    if name == "ParallelEnv":  # needs PettingZoo
        from cls_gym.parallel import ParallelEnv
        return ParallelEnv
    raise AttributeError(f"module 'cls_gym' has no attribute {name!r}")


try:
    import gymnasium as _gymnasium  # type: ignore[import-not-found,unused-ignore]  # noqa: F401
except ImportError:
    pass
else:
    _register()

"""What adapters share: the refusals of what a framework cannot do."""
from __future__ import annotations

from typing import Any, Type

from cls_gym._api import AutoresetMode
from cls_gym._config import ConfigError
from cls_gym.vector import VectorEnv


def refuse_tuples(spec: Any, framework: str) -> None:
    """Raises ConfigError where actions are tuples of an id and numbers, or rows with senses."""
    if spec.actions.senses:
        senses = ", ".join(sense.name for sense in spec.actions.senses)
        raise ConfigError(f"look, say: {framework} takes ids alone, without {senses}; use Env, "
                          "VectorEnv or ParallelEnv")
    if spec.actions.names and spec.actions.values:
        raise ConfigError(f"actions: {framework} has no actions that are tuples, as those of "
                          f"{spec.actions.name!r} are; did you mean 'skills' or 'low_discrete'?")


def check_vector(envs: Any, framework: str, mode: AutoresetMode) -> VectorEnv:
    """`envs`. Raises TypeError for what is no VectorEnv, ConfigError for one in another mode."""
    kind: Type[Any] = VectorEnv
    if not isinstance(envs, kind):
        raise TypeError(f"{framework}: a cls_gym.VectorEnv, not {envs!r:.60}")
    if envs.autoreset_mode is not mode:
        raise ConfigError(f"autoreset_mode: {framework} needs {mode.name.lower()!r}, not "
                          f"{envs.autoreset_mode.name.lower()!r}")
    refuse_tuples(envs.spec_of_task, framework)
    checked: VectorEnv = envs
    return checked

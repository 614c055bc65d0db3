"""Worlds inside of jitted JAX programs, by callbacks to the engine."""
from __future__ import annotations

from typing import Any, Callable, Dict, NamedTuple, Optional, Tuple

import jax
import numpy as np
from jax.experimental import io_callback

from cls_gym._api import AutoresetMode
from cls_gym._config import ConfigError
from cls_gym.adapters._common import check_vector
from cls_gym.vector import VectorEnv


class Step(NamedTuple):
    """What a step shows: arrays of N worlds with A agents."""

    observation: Any  #: float32[N, F], with several agents float32[N, A, F]
    reward: Any       #: float32[N, A]
    terminated: Any   #: bool[N]
    truncated: Any    #: bool[N]
    mask: Any         #: bool[N, K] or bool[N, A, K]: ids with an effect; None without ids


def functions(envs: VectorEnv) -> Tuple[Callable[[Any], Step], Callable[[Any], Step]]:
    """reset(seed) and step(actions) for jit, scan and while_loop.

    envs: a VectorEnv with autoreset_mode="same_step", mask="info" and actions that are no tuples.
    The worlds are state outside of JAX: calls happen in the order of the program, and vmap or grad
    of them is an error. Copies between JAX and the engine are of host memory.
    """
    check_vector(envs, "JAX", AutoresetMode.SAME_STEP)
    if envs._worlds.mask_place not in (None, "info"):
        raise ConfigError("mask: the JAX functions return masks beside; use \"info\"")
    shown = _shown(envs, *envs.reset(seed=0))
    shapes = jax.tree_util.tree_map(lambda one: jax.ShapeDtypeStruct(one.shape, one.dtype), shown)

    def reset_worlds(seed: Any) -> Step:
        return _shown(envs, *envs.reset(seed=int(seed)))

    def step_worlds(actions: Any) -> Step:
        seen, _, terminated, truncated, infos = envs.step(np.asarray(actions))
        return _shown(envs, seen, infos, terminated, truncated)

    def reset(seed: Any) -> Step:
        begun: Step = io_callback(reset_worlds, shapes, seed, ordered=True)
        return begun

    def step(actions: Any) -> Step:
        shown: Step = io_callback(step_worlds, shapes, actions, ordered=True)
        return shown

    return reset, step


def _shown(envs: VectorEnv, seen: np.ndarray, infos: Dict[str, Any],
           terminated: Optional[np.ndarray] = None, truncated: Optional[np.ndarray] = None) -> Step:
    begun = terminated is None
    nothing = np.zeros(envs.num_envs, np.bool_)
    rewards = envs.agent_rewards
    return Step(seen, np.zeros_like(rewards) if begun else rewards,
                nothing if terminated is None else terminated,
                nothing if truncated is None else truncated,
                infos["action_mask"] != 0 if "action_mask" in infos else None)

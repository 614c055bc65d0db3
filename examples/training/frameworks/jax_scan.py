"""A jitted loop over 1000 steps of 64 worlds, with a policy in JAX: pip install FILE jax"""
import jax
import jax.numpy as jnp

import cls_gym
from cls_gym.adapters import jax as cls_jax

envs = cls_gym.VectorEnv("cls/HFO-1v0-v0", 64, features="ego", actions="skills", frame_skip=4,
                         autoreset_mode="same_step")
reset, step = cls_jax.functions(envs)
weights = 0.1 * jax.random.normal(jax.random.key(0), (31, 83))


@jax.jit
def play(key):
    def one(carry, key):
        shown, total = carry
        logits = jnp.where(shown.mask, shown.observation @ weights, -jnp.inf)
        shown = step(jax.random.categorical(key, logits))
        return (shown, total + shown.reward.sum()), shown.terminated.sum()

    shown = reset(1)
    (_, goals), ends = jax.lax.scan(one, (shown, 0.0), jax.random.split(key, 1000))
    return goals, ends.sum()


goals, ends = play(jax.random.key(1))
print(f"{goals:.0f} goals, {ends} episodes ended on the pitch")

#!/usr/bin/env python3
"""Learns half field offense with NumPy alone: proximal policy optimization in one file.

    python3 examples/training/learn_numpy.py --out policy.npz

A network of two tanh layers gives a probability per action and, with another one, the value of
a situation. 64 worlds play 128 steps, then the networks improve on what they saw; and again.
Prints the share of goals of the episodes that have ended since the last line; at the end it plays
200 fresh episodes without exploration. Ctrl-C ends the training early: what was learned is saved.
"""
import argparse
import json
import os
import signal
import sys
import time

# Matrices of this size are slower with threads, five times on two cores. A set variable stays.
for library in ("OMP", "OPENBLAS", "MKL"):
    os.environ.setdefault(f"{library}_NUM_THREADS", "1")

import numpy as np  # noqa: E402

import cls_gym  # noqa: E402
from cls_gym.policy import Policy, describe  # noqa: E402

WORLDS, HORIZON = 64, 128
GAMMA, LAMBDA, CLIP = 0.99, 0.95, 0.2
EPOCHS, BATCHES = 4, 8
ENTROPY = 0.005
REWARD = {"goal": 5, "out_of_bounds": 1, "advance": 0.1, "approach": 0.1}


class Network:
    """Two tanh layers and a linear one, trained with Adam."""

    def __init__(self, sizes, random, last_scale):
        self.weights = []
        for inputs, outputs in zip(sizes, sizes[1:]):
            scale = last_scale if outputs == sizes[-1] and len(self.weights) == \
                2 * len(sizes) - 4 else 1.0
            self.weights += [(random.standard_normal((inputs, outputs)) * scale
                              / np.sqrt(inputs)).astype(np.float32),
                             np.zeros(outputs, np.float32)]
        self.moments = [[np.zeros_like(w), np.zeros_like(w)] for w in self.weights]
        self.updates = 0

    def forward(self, x):
        """The output, and what each layer received."""
        inputs = [x]
        for i in range(0, len(self.weights) - 2, 2):
            x = np.tanh(x @ self.weights[i] + self.weights[i + 1])
            inputs.append(x)
        return x @ self.weights[-2] + self.weights[-1], inputs

    def improve(self, inputs, slope, rate):
        """One step of Adam against the slope of the loss at the output."""
        gradients = [None] * len(self.weights)
        for i in reversed(range(0, len(self.weights), 2)):
            x = inputs[i // 2]
            gradients[i], gradients[i + 1] = x.T @ slope, slope.sum(axis=0)
            if i:
                slope = (slope @ self.weights[i].T) * (1.0 - x * x)
        norm = np.sqrt(sum(float((g * g).sum()) for g in gradients))
        shrink = min(1.0, 0.5 / (norm + 1e-8))
        self.updates += 1
        fix1, fix2 = 1.0 - 0.9 ** self.updates, 1.0 - 0.999 ** self.updates
        for weight, gradient, moment in zip(self.weights, gradients, self.moments):
            gradient *= shrink
            moment[0] += 0.1 * (gradient - moment[0])
            moment[1] += 0.001 * (gradient * gradient - moment[1])
            weight -= rate * (moment[0] / fix1) / (np.sqrt(moment[1] / fix2) + 1e-8)


def log_probabilities(scores, masks):
    """Of each action; -1e9 for one that has no effect now."""
    scores = np.where(masks != 0, scores, np.float32(-1e9))
    scores = scores - scores.max(axis=1, keepdims=True)
    return scores - np.log(np.exp(scores).sum(axis=1, keepdims=True))


class Rollout:
    """What the worlds have played since the last update. With same_step every step is a
    transition; the value of the last observation stands in for what a limit cut off."""

    def __init__(self, features, actions):
        shape = (HORIZON, WORLDS)
        self.seen = np.zeros((*shape, features), np.float32)
        self.masks = np.zeros((*shape, actions), np.int8)
        self.acted = np.zeros(shape, np.int64)
        self.chance = np.zeros(shape, np.float32)  # logarithm
        self.values = np.zeros((HORIZON + 1, WORLDS), np.float32)
        self.rewards = np.zeros(shape, np.float32)
        self.ended = np.zeros(shape, np.bool_)

    def advantages(self):
        result, running = np.zeros_like(self.rewards), np.zeros(WORLDS, np.float32)
        for t in reversed(range(HORIZON)):
            alive = ~self.ended[t]
            surprise = self.rewards[t] + GAMMA * self.values[t + 1] * alive - self.values[t]
            running = surprise + GAMMA * LAMBDA * alive * running
            result[t] = running
        return result


def play(envs, actor, critic, rollout, seen, mask, random):
    """Fills the rollout. Returns the next observation, its mask, and the ends' statuses."""
    ends = []
    for t in range(HORIZON):
        chances = log_probabilities(actor.forward(seen)[0], mask)
        # The highest of chances with noise of Gumbel is a draw from them.
        noise = random.gumbel(size=chances.shape).astype(np.float32)
        acted = (chances + noise).argmax(axis=1)
        rollout.seen[t], rollout.masks[t], rollout.acted[t] = seen, mask, acted
        rollout.chance[t] = chances[np.arange(WORLDS), acted]
        rollout.values[t] = critic.forward(seen)[0][:, 0]
        seen, rewards, terminated, truncated, infos = envs.step(acted)
        rollout.rewards[t], rollout.ended[t] = rewards, terminated | truncated
        for world in np.flatnonzero(truncated):
            last = infos["final_obs"][world][None]
            rollout.rewards[t, world] += GAMMA * critic.forward(last)[0][0, 0]
        if rollout.ended[t].any():
            ends += infos["final_info"]["status"][rollout.ended[t]].tolist()
        mask = infos["action_mask"]
    rollout.values[HORIZON] = critic.forward(seen)[0][:, 0]
    return seen, mask, ends


def learn(actor, critic, rollout, random, rate):
    advantages = rollout.advantages()
    targets = (advantages + rollout.values[:-1]).ravel()
    advantages = advantages.ravel()
    seen = rollout.seen.reshape(advantages.size, -1)
    masks = rollout.masks.reshape(advantages.size, -1)
    acted, before = rollout.acted.ravel(), rollout.chance.ravel()
    for _ in range(EPOCHS):
        for chosen in np.array_split(random.permutation(advantages.size), BATCHES):
            scores, inputs = actor.forward(seen[chosen])
            chances = log_probabilities(scores, masks[chosen])
            p = np.exp(chances)
            rows, own = np.arange(len(chosen)), acted[chosen]
            ratio = np.exp(chances[rows, own] - before[chosen])
            better = advantages[chosen]
            better = (better - better.mean()) / (better.std() + 1e-8)
            counts = ~(((better > 0) & (ratio > 1 + CLIP)) | ((better < 0) & (ratio < 1 - CLIP)))
            slope = p * (better * ratio * counts)[:, None]
            slope[rows, own] -= better * ratio * counts
            entropy = -(p * np.where(p > 0, chances, 0)).sum(axis=1, keepdims=True)
            slope += ENTROPY * p * (np.where(p > 0, chances, 0) + entropy)
            actor.improve(inputs, (slope / len(chosen)).astype(np.float32), rate)
            values, inputs = critic.forward(seen[chosen])
            error = values - targets[chosen, None]
            critic.improve(inputs, (error / len(chosen)).astype(np.float32), rate)


def evaluate(config, policy, episodes, seed):
    """The share of goals in fresh episodes: the first one of each of so many worlds."""
    envs = cls_gym.VectorEnv(num_envs=episodes, **config)
    seen, infos = envs.reset(seed=seed)
    status = np.zeros(episodes, np.int64)
    step = 0
    while not status.all():
        seen, _, _, _, infos = envs.step(policy(step, seen, infos["action_mask"]))
        status = np.where(status == 0, infos["status"], status)
        step += 1
    envs.close()
    return float((status == 1).mean())


def open_loop_policy(config, actions, random):
    """The best of 50 sequences of actions that see nothing but the time, each repeated for a
    while: a task that it solves proves nothing about learning."""
    best, plan = -1.0, None
    for _ in range(50):
        candidate = np.repeat(random.integers(actions, size=1000), random.integers(1, 12))
        goals = evaluate(config, lambda t, seen, _, c=candidate: np.full(len(seen), c[t]), 50, 77)
        if goals > best:
            best, plan = goals, candidate
    return lambda t, seen, _: np.full(len(seen), plan[t])


def train(config, seed, steps, report):
    """Learns for so many steps, or until Ctrl-C. Returns the policy, and whether it was interrupted;
    report(steps, share of goals) each update."""
    random = np.random.default_rng(seed)
    envs = cls_gym.VectorEnv(num_envs=WORLDS, autoreset_mode="same_step", **config)
    features = envs.single_observation_space.shape[0]
    actions = int(envs.single_action_space.n)
    actor = Network([features, 64, 64, actions], random, 0.01)
    critic = Network([features, 64, 64, 1], random, 1.0)
    rollout = Rollout(features, actions)
    seen, infos = envs.reset(seed=seed)
    mask = infos["action_mask"]
    interrupted = False
    try:
        for done in range(0, steps, WORLDS * HORIZON):
            seen, mask, ends = play(envs, actor, critic, rollout, seen, mask, random)
            learn(actor, critic, rollout, random, 1e-3 * (1.0 - done / steps))
            report(done + WORLDS * HORIZON, float(np.mean(np.array(ends) == 1)) if ends else 0.0)
    except KeyboardInterrupt:
        interrupted = True
    about = describe(envs)
    envs.close()
    weights = actor.weights
    return Policy(list(zip(weights[::2], weights[1::2])), about), interrupted


def time_left(seconds):
    return f"{seconds / 60:.0f} min left" if seconds >= 90 else f"{seconds:.0f} s left"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--offense", type=int, default=1)
    parser.add_argument("--defense", type=int, default=0)
    parser.add_argument("--steps", type=int, default=2_000_000, help="of the worlds together")
    parser.add_argument("--obs", choices=("full_state", "world_model"), default="full_state",
                        help="what the agent observes; rated matches are for world_model, which "
                             "takes longer (default: full_state)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--out", metavar="FILE", help="the trained policy (.npz)")
    parser.add_argument("--curve", metavar="FILE", help="share of goals by steps (.json)")
    parser.add_argument("--controls", action="store_true",
                        help="evaluate random and open-loop policies instead")
    options = parser.parse_args()
    # Dense rewards for training; what counts is the share of goals.
    config = {"task": "cls/HalfFieldOffense-v0", "offense": options.offense,
              "defense": options.defense, "num_agents": 1, "features": "ego",
              "actions": "low_discrete", "obs": options.obs, "max_cycles": 500, "reward": REWARD}
    random = np.random.default_rng(options.seed)
    if options.controls:
        with cls_gym.Env(**config) as env:
            count = int(env.action_space.n)
        chance = evaluate(config, lambda t, seen, _: random.integers(count, size=len(seen)), 200,
                          10_000)
        blind = open_loop_policy(config, count, random)
        print(f"random policy: {chance:.3f} of 200 fresh episodes")
        print(f"best open-loop policy: {evaluate(config, blind, 200, 10_000):.3f}")
        return 0
    curve, start, began = [], time.process_time(), time.monotonic()
    signal.signal(signal.SIGTERM, lambda *_: signal.raise_signal(signal.SIGINT))

    def report(steps, goals):
        curve.append((steps, goals))
        if len(curve) % 10 == 0 or len(curve) == 1:
            left = (time.monotonic() - began) * max(0, options.steps - steps) / steps
            print(f"{steps:>9} steps  {goals:.2f} goals  {time.process_time() - start:.0f} s CPU  "
                  f"{time_left(left)}", flush=True)

    def save(**results):
        if options.out:
            policy.save(options.out)
        if options.curve:
            with open(options.curve, "w", encoding="utf-8") as out:
                json.dump({"label": f"seed {options.seed}", **results, "curve": curve}, out)

    policy, interrupted = train(config, options.seed, options.steps, report)
    if interrupted:
        save()
        print(f"interrupted after {curve[-1][0] if curve else 0} of {options.steps} steps; " +
              (f"what was learned is in {options.out}" if options.out else "--out FILE would save"))
        return 130
    goals = evaluate(config, lambda _, seen, mask: policy.act(seen, mask), 200, 10_000)
    spent = time.process_time() - start
    print(f"seed {options.seed}: {goals:.3f} of 200 fresh episodes end with a goal; "
          f"{spent:.0f} s CPU")
    save(goals=goals, episodes=200, cpu_seconds=spent)
    return 0


if __name__ == "__main__":
    sys.exit(main())

"""A team that learns its decisions with the ball from the planner of cls, then from its own mistakes.

    L=examples/training/learn_team.py
    python3 $L record --out data/planner --matches 64
    python3 $L clone --data data/planner --out cloned.policy
    python3 $L record --out data/round1 --matches 32 --policy cloned.policy
    python3 $L clone --data data/planner data/round1 --out dagger.policy
    python3 $L improve --policy dagger.policy --out improved.policy
    python3 $L play --policy dagger.policy --opponent planner
    cls match policy:dagger.policy mock

`record` plays matches in the engine and stores what the players with the ball observed, and what the
planner would have chosen for them: where the planner plays (behavior cloning), or where a policy does
(DAgger). With --expert playmaker:SIDE it plays matches of `cls match` instead and stores what that
side chose, whatever language it is written in:

    python3 $L record --out data/mine --expert 'playmaker:run:./run --port {port}'

`clone` fits a network to it. `improve` goes on by reinforcement learning: proximal policy
optimization, which stays near the policy that it began with. `play` is a match of the policy, of the
planner's choices (--policy planner) or of random ones (--policy random) in the engine. Each stage can
be stopped and started again: `record` and `improve` go on where they stopped. It needs NumPy.
docs/learned-team.md has the figures.
"""
from __future__ import annotations

import argparse
import collections
import contextlib
import json
import pathlib
import subprocess
import tempfile
import time
from typing import Any, Callable, Dict, Iterator, List, Optional, Tuple

import numpy as np

import cls_gym
from cls_gym import network, policy
from cls_gym.network import Network, Step

# Of team/1 with 10 teammates and 11 opponents: columns of the own state and the ball, of a player,
# and of a dribble or a pass.
OWN, PLAYER, TARGET = 54, 15, 8
MATES, DRIBBLES = OWN, OWN + 21 * PLAYER
PASSES = DRIBBLES + 16 * TARGET
FEATURES = PASSES + 40 * TARGET
OPTIONS = 84
Choose = Callable[[np.ndarray, np.ndarray, np.ndarray], np.ndarray]


# ---- matches

def worlds(count: int, opponent: str, cycles: int = 0, expert: str = "planner",
           reward: Optional[Dict[str, float]] = None) -> cls_gym.VectorEnv:
    """Whole matches; opponent: "self" (both teams are agents), or a name of docs/training.md."""
    more: Dict[str, Any] = {"agents": "both"} if opponent == "self" else {"opponent": opponent}
    if reward is not None:
        more["reward"] = reward
    return cls_gym.VectorEnv("cls/Match-v0", count, obs="world_model", features="team",
                             actions="options", expert=expert, until="decision", frame_skip=20,
                             types="random", max_cycles=cycles, **more)


def chooser(name: str, seed: int) -> Choose:
    """Chooses for rows of players with the ball: observations, masks and the planner's choices."""
    if name == "planner":
        return lambda observations, masks, expert: expert
    if name == "random":
        random = np.random.default_rng(seed)
        return lambda observations, masks, expert: (random.random(masks.shape) * masks).argmax(1)
    net = network.load(name)
    return lambda observations, masks, expert: net.act(observations, masks)


def play(envs: cls_gym.VectorEnv, choose: Choose, seed: int,
         see: Optional[Callable[..., None]] = None,
         pay: Optional[Callable[[np.ndarray], None]] = None) -> np.ndarray:
    """int[N]: goal differences of a match in each world. see: takes the worlds, observations, masks
    and the planner's choices of the players with the ball; pay: the rewards [N] of what followed."""
    observations, infos = envs.reset(seed=seed)
    ended = np.zeros(envs.num_envs, bool)
    score = np.zeros((envs.num_envs, 2), int)
    while not ended.all():
        masks = infos["action_mask"]
        expert = infos.get("expert", np.zeros(masks.shape[:2], np.int64))
        ball = (masks[:, :, 0] == 0) & (expert >= 0) & ~ended[:, None]
        actions = np.zeros(expert.shape, np.int64)
        if ball.any():
            rows = observations[ball], masks[ball], expert[ball]
            actions[ball] = choose(*rows)
            if see is not None:
                see(ball.nonzero()[0], *rows)
        observations, rewards, terminated, truncated, infos = envs.step(actions)
        if pay is not None:
            pay(np.where(ended, 0, rewards))
        now = (terminated | truncated) & ~ended  # such a world begins another match, which is not seen
        score[now] = infos["score"][now]
        ended |= now
    return score[:, 0] - score[:, 1]


@contextlib.contextmanager
def completed(path: pathlib.Path) -> Iterator[pathlib.Path]:
    """Where to write the file, which appears when it is complete."""
    part = path.with_suffix(".part")
    yield part
    part.rename(path)


def save(path: pathlib.Path, **arrays: np.ndarray) -> None:
    with completed(path) as part, open(part, "wb") as out:
        np.savez(out, **arrays)  # type: ignore[arg-type]


def save_curve(path: pathlib.Path, curve: List[Dict[str, Any]]) -> None:
    with completed(path) as part:
        part.write_text(json.dumps(curve))


def record(options: argparse.Namespace) -> None:
    """Files of `worlds` matches each; those that exist are complete."""
    options.out.mkdir(parents=True, exist_ok=True)
    if options.expert != "planner":
        return record_playmaker(options)
    choose = chooser(options.policy, options.seed)
    with worlds(options.worlds, options.opponent, options.cycles) as envs:
        for first in range(options.seed, options.seed + options.matches, options.worlds):
            path = options.out / f"{options.opponent}-{first:07d}.npz"
            if path.exists():
                continue
            seen: List[Tuple[np.ndarray, ...]] = []
            began = time.process_time()
            goals = play(envs, choose, first, lambda *rows: seen.append(
                (rows[0] + first, rows[1].astype(np.float16), rows[2].astype(bool), rows[3])))
            match, observed, masks, expert = (np.concatenate(one) for one in zip(*seen))
            save(path, match=match, observed=observed, masks=masks, expert=expert)
            print(f"{path}: {len(expert)} choices, goals {goals.mean():+.2f}, "
                  f"{time.process_time() - began:.0f} s of CPU", flush=True)


def record_playmaker(options: argparse.Namespace) -> None:
    """A file of each match. A choice of the Playmaker that is like no option is counted, not kept."""
    kind, _, side = options.expert.partition(":")
    if kind != "playmaker" or not side or options.policy != "planner":
        raise SystemExit("--expert is planner, or playmaker:SIDE without --policy: such an expert "
                         "is not asked what it would do where another team plays")
    opponent = {"self": side, "planner": "mock:planner", "mock": "mock:simple"}.get(
        options.opponent, options.opponent)
    name = "".join(one if one.isalnum() else "-" for one in options.opponent)
    total: collections.Counter[str] = collections.Counter()
    for seed in range(options.seed, options.seed + options.matches):
        path = options.out / f"{name}-{seed:07d}.npz"
        if path.exists():
            continue
        with tempfile.TemporaryDirectory() as folder:
            run = [options.cls, "match", side, opponent, "--seed", str(seed), "--record-choices",
                   "--dir", f"{folder}/match", "--quiet"]
            run += ["--cycles", str(options.cycles)] if options.cycles else []
            subprocess.run(run, check=True, stdout=subprocess.DEVNULL)
            teams = ["left", "right"] if options.opponent == "self" else ["left"]
            all_choices = np.concatenate([np.load(f"{folder}/match/{one}-choices.npy")
                                          for one in teams])
        kept = all_choices[all_choices["option"] >= 0]
        save(path, match=np.full(len(kept), seed), observed=kept["observed"].astype(np.float16),
             masks=kept["legal"], expert=kept["option"])
        other = all_choices[all_choices["option"] == -1]["action"]
        total["all"] += int((all_choices["option"] >= -1).sum())
        total.update(one.decode() or "no action" for one in other)
        print(f"{path}: {len(kept)} choices, {len(other)} more are like no option", flush=True)
    if total["all"]:
        shares = [f"{name} {count / total['all']:.1%}" for name, count in total.most_common()
                  if name != "all"]
        print(f"{total['all']} choices; like no option: {', '.join(shares) or 'none'}")


# ---- the network and its gradient

def dense(name: str, of: str, inputs: int, width: int, activation: str,
          random: np.random.Generator) -> Step:
    weight = random.normal(0, (2 / inputs) ** 0.5, (inputs, width))
    return Step(name, "dense", [of], width=width, activation=activation,
                weights=[weight * (0.1 if activation == "none" else 1), np.zeros(width)])


def make_network(about: Dict[str, Any], mean: np.ndarray, deviation: np.ndarray,
                 random: np.random.Generator) -> Network:
    """What the player knows becomes a summary; a network that all dribbles share, and one that all
    receivers share, score each option from the summary and where the option leads."""
    scale = 1 / np.maximum(deviation, 0.05)
    hidden, summary = 160, 64
    steps = [
        Step("scaled", "norm", ["features"], weights=[scale, -mean * scale]),
        dense("first", "scaled", FEATURES, hidden, "relu", random),
        dense("summary", "first", hidden, summary, "relu", random),
        dense("basic", "summary", summary, 5, "none", random),
        Step("dribbles", "columns", ["scaled"], DRIBBLES, 16, TARGET),
        Step("each_dribble", "concat", ["dribbles", "summary"]),
        dense("dribble_part", "each_dribble", TARGET + summary, 48, "relu", random),
        dense("dribble_score", "dribble_part", 48, 1, "none", random),
        Step("dribble_scores", "flatten", ["dribble_score"]),
        Step("passes", "columns", ["scaled"], PASSES, 10, 4 * TARGET),
        Step("mates", "columns", ["scaled"], MATES, 10, PLAYER),
        Step("each_pass", "concat", ["passes", "mates", "summary"]),
        dense("pass_part", "each_pass", 4 * TARGET + PLAYER + summary, 64, "relu", random),
        dense("pass_score", "pass_part", 64, 4, "none", random),
        Step("pass_scores", "flatten", ["pass_score"]),
        dense("moves", "summary", summary, OPTIONS - 61, "none", random),
        Step("scores", "concat", ["basic", "dribble_scores", "pass_scores", "moves"])]
    return Network(steps, dict(about, decides="ball"))


def forward(net: Network, observations: np.ndarray) -> Dict[str, np.ndarray]:
    """The result [B, rows, width] of each step."""
    results = {"features": observations[:, None, :]}
    for step in net.steps:
        x = results[step.of[0]]
        if step.kind == "columns":
            out = x[:, 0, step.first:step.first + step.rows * step.width]
            out = out.reshape(len(x), step.rows, step.width)
        elif step.kind == "norm":
            out = x * step.weights[0] + step.weights[1]
        elif step.kind == "dense":
            out = x.reshape(-1, x.shape[2]) @ step.weights[0] + step.weights[1]
            out = out.reshape(x.shape[0], x.shape[1], -1)
            if step.activation == "relu":
                np.maximum(out, 0, out=out)
        elif step.kind == "concat":
            parts = [results[name] for name in step.of]
            rows = max(one.shape[1] for one in parts)
            out = np.concatenate([np.broadcast_to(one, (len(x), rows, one.shape[2]))
                                  for one in parts], axis=2)
        else:
            out = x.reshape(len(x), 1, -1)
        results[step.name] = out
    return results


def backward(net: Network, results: Dict[str, np.ndarray],
             of_scores: np.ndarray) -> Dict[str, List[np.ndarray]]:
    """Gradients of the weights of dense steps by name, from that of the scores [B, 1, K]."""
    of: Dict[str, np.ndarray] = {net.steps[-1].name: of_scores}
    gradients: Dict[str, List[np.ndarray]] = {}

    def add(name: str, gradient: np.ndarray) -> None:
        if name not in ("features", "scaled"):
            of[name] = of[name] + gradient if name in of else gradient

    for step in reversed(net.steps):
        if step.name not in of or step.kind in ("columns", "norm"):
            continue
        gradient, x = of[step.name], results[step.of[0]]
        if step.kind == "dense":
            if step.activation == "relu":
                gradient = gradient * (results[step.name] > 0)
            flat = gradient.reshape(-1, gradient.shape[2])
            gradients[step.name] = [x.reshape(-1, x.shape[2]).T @ flat, flat.sum(0)]
            if step.of[0] != "scaled":
                add(step.of[0], (flat @ step.weights[0].T).reshape(x.shape))
        elif step.kind == "concat":
            first = 0
            for name in step.of:
                part = results[name]
                one = gradient[:, :, first:first + part.shape[2]]
                first += part.shape[2]
                add(name, one.sum(1, keepdims=True) if part.shape[1] < one.shape[1] else one)
        else:
            add(step.of[0], gradient.reshape(x.shape))
    return gradients


class Adam:
    """Adam with a decay of the weights."""

    def __init__(self, net: Network, decay: float) -> None:
        self.net, self.decay, self.steps = net, decay, 0
        self.means = {step.name: [np.zeros_like(one) for one in step.weights] for step in net.steps}
        self.squares = {name: [np.zeros_like(one) for one in all] for name, all in
                        self.means.items()}

    def step(self, gradients: Dict[str, List[np.ndarray]], rate: float) -> None:
        self.steps += 1
        for step in self.net.steps:
            for i, gradient in enumerate(gradients.get(step.name, [])):
                mean, square = self.means[step.name][i], self.squares[step.name][i]
                mean += 0.1 * (gradient - mean)
                square += 0.001 * (gradient * gradient - square)
                change = mean / (1 - 0.9 ** self.steps)
                change /= np.sqrt(square / (1 - 0.999 ** self.steps)) + 1e-8
                decay = self.decay if i == 0 else 0.0
                step.weights[i][...] -= rate * (change + decay * step.weights[i])


# ---- imitation

def read(folders: List[pathlib.Path]) -> Tuple[np.ndarray, ...]:
    """match, observed, masks and expert of all files; matches of different folders differ."""
    parts: List[Tuple[np.ndarray, ...]] = []
    for number, folder in enumerate(folders):
        for path in sorted(folder.glob("*.npz")):
            with np.load(path) as file:
                parts.append((file["match"] + 10_000_000 * number, file["observed"], file["masks"],
                              file["expert"]))
    match, observed, masks, expert = (np.concatenate(one) for one in zip(*parts))
    return match, observed.astype(np.float32), masks, expert


def probabilities(scores: np.ndarray, masks: np.ndarray) -> np.ndarray:
    shifted = np.where(masks, scores, -1e9)
    shifted = np.exp(shifted - shifted.max(1, keepdims=True))
    return np.asarray(shifted / shifted.sum(1, keepdims=True), np.float32)


def agreement(net: Network, observed: np.ndarray, masks: np.ndarray,
              expert: np.ndarray) -> Tuple[float, float, float]:
    """Shares of choices that are the expert's, and that are among the three best; the loss."""
    top1 = top3 = loss = 0.0
    for first in range(0, len(expert), 4096):
        part = slice(first, first + 4096)
        scores = forward(net, observed[part])["scores"][:, 0]
        chosen = probabilities(scores, masks[part])
        own = np.take_along_axis(chosen, expert[part, None], 1)
        better = (chosen > own).sum(1)
        top1 += float((better == 0).sum())
        top3 += float((better < 3).sum())
        loss -= float(np.log(np.maximum(own, 1e-9)).sum())
    return top1 / len(expert), top3 / len(expert), loss / len(expert)


def batches(count: int, size: int, random: np.random.Generator) -> Iterator[np.ndarray]:
    order = random.permutation(count)
    for first in range(0, count - size + 1, size):
        yield order[first:first + size]


def clone(options: argparse.Namespace) -> None:
    """Fits the choices of the expert; one of ten matches is held out, and the best epoch kept."""
    random = np.random.default_rng(options.seed)
    match, observed, masks, expert = read(options.data)
    held = match % 10 == 9
    if not held.any():
        held = match == match.max()
    train = tuple(one[~held] for one in (observed, masks, expert))
    test = tuple(one[held] for one in (observed, masks, expert))
    print(f"{len(train[2])} choices to learn from, {len(test[2])} held out", flush=True)
    with worlds(1, "planner") as envs:
        about = policy.describe(envs)
    net = make_network(about, train[0].mean(0), train[0].std(0), random)
    adam, curve, best = Adam(net, options.decay), [], np.inf
    for epoch in range(options.epochs):
        rate = options.rate * 0.5 * (1 + np.cos(np.pi * epoch / options.epochs))
        for rows in batches(len(train[2]), min(512, len(train[2]) // 8 + 1), random):
            results = forward(net, train[0][rows])
            of_scores = probabilities(results["scores"][:, 0], train[1][rows])
            of_scores[np.arange(len(rows)), train[2][rows]] -= 1
            adam.step(backward(net, results, of_scores[:, None] / len(rows)), rate)
        top1, top3, loss = agreement(net, *test)
        curve.append({"epoch": epoch + 1, "top1": top1, "top3": top3, "loss": loss})
        print(f"epoch {epoch + 1}: held out: {top1:.3f} the expert's, {top3:.3f} among three, "
              f"loss {loss:.3f}; {time.process_time():.0f} s of CPU", flush=True)
        if loss < best:
            best = loss
            net.about["training"] = {"choices": len(train[2]), **curve[-1]}
            net.save(options.out)
    save_curve(pathlib.Path(options.out).with_suffix(".curve.json"), curve)


# ---- improvement

def writable(net: Network) -> Network:
    for step in net.steps:
        step.weights = [one.copy() for one in step.weights]
    return net


def make_critic(policy_net: Network, random: np.random.Generator) -> Network:
    """What an observation is worth, in goals, until the end of the match."""
    steps = [Step("scaled", "norm", ["features"], weights=policy_net.steps[0].weights),
             dense("first", "scaled", FEATURES, 64, "relu", random),
             dense("scores", "first", 64, 1, "none", random)]
    return Network(steps, policy_net.about)


class Experience:
    """The choices of matches in their order, what they earned, and what they were worth."""

    def __init__(self, net: Network, temperature: float, random: np.random.Generator) -> None:
        self.net, self.temperature, self.random = net, temperature, random
        self.seen: List[Tuple[np.ndarray, ...]] = []
        self.world: List[np.ndarray] = []  # of each choice
        self.last: Dict[int, int] = {}  # of each world, the index of its latest choice
        self.gains: List[float] = []

    def choose(self, observed: np.ndarray, masks: np.ndarray, _: np.ndarray) -> np.ndarray:
        """Draws an option, by its probability."""
        scores = forward(self.net, observed)["scores"][:, 0]
        shares = probabilities(scores / self.temperature, masks != 0)
        drawn = (shares.cumsum(1) < self.random.random((len(shares), 1))).sum(1)
        chosen = np.minimum(drawn, OPTIONS - 1)
        # Sums of rounded shares may end below 1.
        chosen = np.where(masks[np.arange(len(chosen)), chosen] != 0, chosen, shares.argmax(1))
        self.seen.append((observed, masks != 0, chosen, shares))
        return np.asarray(chosen)

    def see(self, world: np.ndarray, *_: np.ndarray) -> None:
        self.world.append(world)
        for one in world:
            self.last[int(one)] = len(self.gains)
            self.gains.append(0.0)

    def pay(self, rewards: np.ndarray) -> None:
        for world, index in self.last.items():
            self.gains[index] += float(rewards[world])

    def advantages(self, values: np.ndarray, keep: float, trace: float
                   ) -> Tuple[np.ndarray, np.ndarray]:
        """Generalized advantage estimates, and what the critic should have said. keep: of the value
        from one choice of the team to the next; trace: weight of later estimates."""
        world, gains = np.concatenate(self.world), np.array(self.gains)
        result = np.zeros(len(gains))
        for one in np.unique(world):
            later, after = 0.0, 0.0
            for i in (world == one).nonzero()[0][::-1]:
                error = gains[i] + keep * after - values[i]
                later = result[i] = error + keep * trace * later
                after = values[i]
        return result, result + values


def values_of(critic: Network, observed: np.ndarray) -> np.ndarray:
    return np.asarray(forward(critic, observed)["scores"][:, 0, 0])


def fit_critic(critic: Network, observed: np.ndarray, wanted: np.ndarray, epochs: int,
               random: np.random.Generator) -> None:
    adam = Adam(critic, 0.01)
    for _ in range(epochs):
        for rows in batches(len(wanted), min(256, len(wanted)), random):
            results = forward(critic, observed[rows])
            error = results["scores"][:, 0, 0] - wanted[rows]
            adam.step(backward(critic, results, error[:, None, None] / len(rows)), 0.001)


def fit_policy(net: Network, first: Network, rows_of: Tuple[np.ndarray, ...],
               advantage: np.ndarray, options: argparse.Namespace,
               random: np.random.Generator) -> float:
    """Proximal policy optimization. Returns the divergence from the policy that played."""
    observed, masks, chosen, played = rows_of
    advantage = ((advantage - advantage.mean()) / (advantage.std() + 1e-6)).astype(np.float32)
    adam, moved = Adam(net, 0.0), 0.0
    for _ in range(options.epochs):
        for rows in batches(len(chosen), min(256, len(chosen)), random):
            at = np.arange(len(rows)), chosen[rows]
            results = forward(net, observed[rows])
            shares = probabilities(results["scores"][:, 0] / options.temperature, masks[rows])
            ratio = shares[at] / np.maximum(played[rows][at], 1e-6)
            gain = advantage[rows]
            clipped = np.where(gain > 0, ratio > 1.2, ratio < 0.8)
            weight = np.where(clipped, 0, gain * ratio)
            of_scores = shares * weight[:, None]
            of_scores[at] -= weight
            near = probabilities(forward(first, observed[rows])["scores"][:, 0]
                                 / options.temperature, masks[rows])
            of_scores += options.near * (shares - near)
            of_scores /= options.temperature * len(rows)
            adam.step(backward(net, results, of_scores[:, None].astype(np.float32)), options.rate)
        scores = forward(net, observed)["scores"][:, 0] / options.temperature
        now = probabilities(scores, masks)
        moved = float((played * (np.log(played + 1e-9) - np.log(now + 1e-9))).sum(1).mean())
        if moved > 0.02:
            break
    return moved


def play_and_judge(envs: cls_gym.VectorEnv, net: Network, critic: Network, update: int,
                   options: argparse.Namespace, random: np.random.Generator
                   ) -> Tuple[Tuple[np.ndarray, ...], np.ndarray, np.ndarray, np.ndarray]:
    """The choices of an update's matches, their advantages, what the critic should have said, and
    the goal differences."""
    goals, rows_of, judged = [], [], []
    for number in range(0, options.matches, options.worlds):
        experience = Experience(net, options.temperature, random)
        goals.append(play(envs, experience.choose, options.seed + update * options.matches + number,
                          experience.see, experience.pay))
        rows_of.append(tuple(np.concatenate(one) for one in zip(*experience.seen)))
        judged.append(experience.advantages(values_of(critic, rows_of[-1][0]), 0.98, 0.95))
    advantage, target = (np.concatenate(one) for one in zip(*judged))
    return (tuple(np.concatenate(one) for one in zip(*rows_of)), advantage, target,
            np.concatenate(goals))


def improve(options: argparse.Namespace) -> None:
    """Reinforcement learning from goals. An update is so many matches, in which choices are drawn."""
    if options.opponent == "self":
        raise SystemExit("improve plays one team: --opponent planner, mock or scripted")
    first = writable(network.load(options.policy))
    curve_file, critic_file = (options.out.with_suffix(one) for one in (".curve.json", ".critic"))
    curve = json.loads(curve_file.read_text()) if curve_file.exists() else []
    net = writable(network.load(options.out if curve else options.policy))
    critic = (writable(network.load(critic_file)) if curve
              else make_critic(net, np.random.default_rng(options.seed)))
    reward = {"goal": 1.0, "advance": options.advance}
    with worlds(options.worlds, options.opponent, options.cycles, "none", reward) as envs:
        for update in range(len(curve), options.updates):
            random, began = np.random.default_rng([options.seed, update]), time.process_time()
            rows_of, advantage, target, goals = play_and_judge(envs, net, critic, update, options,
                                                               random)
            # The first matches teach the critic alone: before, it knows nothing.
            moved = (fit_policy(net, first, rows_of, advantage, options, random)
                     if update > 0 else 0.0)
            fit_critic(critic, rows_of[0], target, 4, random)
            curve.append({"update": update, "matches": len(goals), "moved": moved,
                          "goals": [int(one) for one in goals],
                          "cpu": time.process_time() - began})
            critic.save(critic_file)
            net.save(options.out)
            save_curve(curve_file, curve)
            print(f"update {update}: goals {goals.mean():+.2f} of drawn choices, moved "
                  f"{moved:.4f}, {curve[-1]['cpu']:.0f} s of CPU", flush=True)


def evaluate(options: argparse.Namespace) -> None:
    """Goal difference of matches in the engine, with its 95 % interval."""
    choose = chooser(options.policy, options.seed)
    goals: List[np.ndarray] = []
    expert = "planner" if options.policy == "planner" else "none"
    with worlds(options.worlds, options.opponent, options.cycles, expert) as envs:
        for first in range(options.seed, options.seed + options.matches, options.worlds):
            goals.append(play(envs, choose, first))
            all_goals = np.concatenate(goals)
            margin = 1.96 * all_goals.std(ddof=1) / len(all_goals) ** 0.5
            print(f"{options.policy} against {options.opponent}, {len(all_goals)} matches: "
                  f"{all_goals.mean():+.2f} ({all_goals.mean() - margin:+.2f} to "
                  f"{all_goals.mean() + margin:+.2f})", flush=True)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    stages = parser.add_subparsers(required=True, metavar="STAGE")

    def stage(name: str, run: Callable[[argparse.Namespace], None]) -> argparse.ArgumentParser:
        one = stages.add_parser(name, help=(run.__doc__ or "").split("\n")[0])
        one.set_defaults(run=run)
        one.add_argument("--seed", type=int, default=1)
        return one

    def of_matches(one: argparse.ArgumentParser, opponent: str, policy: str = "planner") -> None:
        one.add_argument("--policy", default=policy, required=not policy,
                         help="a policy file" + ", planner or random" * bool(policy))
        one.add_argument("--opponent", default=opponent, help="self, planner, mock or scripted")
        one.add_argument("--matches", type=int, default=16)
        one.add_argument("--worlds", type=int, default=8, help="matches at the same time")
        one.add_argument("--cycles", type=int, default=0, help="of a match (default: 6000)")

    recorded = stage("record", record)
    recorded.add_argument("--out", type=pathlib.Path, required=True)
    recorded.add_argument("--expert", default="planner",
                          help="planner, or playmaker:SIDE with a side of cls match")
    recorded.add_argument("--cls", default="cls", help="the program, for a playmaker")
    of_matches(recorded, "self")
    cloned = stage("clone", clone)
    cloned.add_argument("--data", type=pathlib.Path, nargs="+", required=True)
    cloned.add_argument("--out", required=True)
    cloned.add_argument("--epochs", type=int, default=12)
    cloned.add_argument("--rate", type=float, default=0.001)
    cloned.add_argument("--decay", type=float, default=0.02)
    improved = stage("improve", improve)
    improved.add_argument("--out", type=pathlib.Path, required=True)
    improved.add_argument("--updates", type=int, default=50)
    improved.add_argument("--epochs", type=int, default=3)
    improved.add_argument("--rate", type=float, default=0.0001)
    improved.add_argument("--temperature", type=float, default=0.5,
                          help="divides the scores of choices that are drawn")
    improved.add_argument("--near", type=float, default=0.1,
                          help="weight of the divergence from the policy that it began with")
    improved.add_argument("--advance", type=float, default=0.005,
                          help="goals for each meter that the ball comes nearer to their goal")
    of_matches(improved, "planner", "")
    of_matches(stage("play", evaluate), "planner")
    options = parser.parse_args()
    options.run(options)


if __name__ == "__main__":
    main()

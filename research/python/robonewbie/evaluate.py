"""Evaluates policies in episodes with seeds that no training run uses, and compares them with zero actions.

    python -m robonewbie.evaluate Stand Stand.policy                  128 episodes each
    python -m robonewbie.evaluate QuickGetUp QuickGetUp.policy --option friction=2 --n-eval-episodes 256
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from robonewbie import network
from robonewbie.environment import CYCLES_PER_SECOND, EpisodeSeeds
from robonewbie.simulator import RESET, SKIP, STEP, TERMINATED, Connection
from robonewbie.train import options_of

# The seeds of training runs start at 10 million.
FIRST_SEED = 1_000_000


_TASKS = {"walk": "WalkGait", "jog": "JogGait", "run": "RunGait"}  # that the policies of these names have learned


class PlayedPolicy:
    """Policy loaded from its file, evaluated with NumPy for a batch of observations.

    ``task`` is what it has learned, and ``options`` are those that it needs of the task.
    """

    def __init__(self, text: str) -> None:
        self.text, self.inputs, self.layers = text, [], network.read(text)
        learned = text.split("\n", 1)[0].split()[-1]
        self.task = _TASKS.get(learned, learned)
        self.options = {"cycles": 1}
        for line in text.splitlines():
            words = line.split(" ")
            if words[0] == "input":
                self.inputs.append(words[1])
                age = int(words[1].partition("@-")[2] or 0)
                if age:
                    self.options["history"] = max(age + 1, self.options.get("history", 1))
            if words[0] == "output" and words[1].startswith("speed."):
                self.options["speeds"] = 1
            if words[:2] == ["numbers", "cycles-per-action"]:
                self.options["cycles"] = int(words[2])
        self.reset()

    def reset(self) -> None:
        """Forgets all earlier observations, as at the start of an episode."""
        self.states = [None] * len(self.layers)

    def act(self, observation: np.ndarray) -> np.ndarray:
        """Returns a row of actions from -1 to 1 for each row of observations. A recurrent policy remembers each row's observations."""
        values = observation.astype(float)
        for i, layer in enumerate(self.layers):
            values, self.states[i] = layer.apply(values, self.states[i])
        return values


@dataclass(frozen=True)
class Result:
    """The return, the length in actions, the success, the mean speed in m/s, and whether the robot fell, of each episode."""

    returns: np.ndarray
    actions: np.ndarray
    successes: np.ndarray
    speeds: np.ndarray
    falls: np.ndarray

    def __str__(self):
        error = np.std(self.returns) / np.sqrt(len(self.returns))
        return f"return {np.mean(self.returns):.3f} ± {error:.3f}, success {np.sum(self.successes)} of {len(self.successes)}"


def evaluate(
    task: str,
    policy: PlayedPolicy | None = None,
    episodes: int = 128,
    first_seed: int = FIRST_SEED,
    options: dict[str, Any] | None = None,
    physics: Any = None,
) -> Result:
    """Plays all episodes in parallel and returns a Result. Without a policy, all actions are zero.

    Cycles per action, history and kind of actions are those of the policy's training, unless ``options`` set them. ``physics`` replaces
    the simulator's, see :class:`robonewbie.mujoco.Physics`.
    """
    options = {**(policy.options if policy else {}), **(options or {})}
    robots = Connection(task, episodes, "", options, physics)
    described = robots.description
    cycles = described["cycles"]
    names = [entry["name"] for entry in described["observation"]]
    indices = [names.index(name) for name in policy.inputs] if policy else []
    seeds = EpisodeSeeds(episodes)
    seeds.begin(range(first_seed, first_seed + episodes))
    running = np.ones(episodes, dtype=bool)
    if policy:
        policy.reset()
        robots.play(policy.text)
    observation, _, _ = robots.act(RESET, seeds.draw(running), 0)
    returns, actions, way = np.zeros(episodes), np.zeros(episodes, dtype=int), np.zeros(episodes)
    truth = {name: i for i, name in enumerate(robots.truth_names)}
    place = [truth["x"], truth["y"]]
    before, interval = robots.truth[:, place], max(1, round(CYCLES_PER_SECOND / cycles))
    last, fallen = robots.truth.copy(), np.zeros(episodes, dtype=bool)
    while running.any():
        action = described["actionLimit"] * policy.act(observation[:, indices]) if policy else 0
        observation, reward, _ = robots.act(np.where(running, STEP, SKIP), 0, action)
        returns[running] += reward[running]
        actions += running
        last[running] = robots.truth[running]
        ended = running & (robots.state != 0)
        measured = ended | running & (actions % interval == 0)
        way[measured] += np.hypot(*(last[:, place] - before)[measured].T)
        before[measured] = last[measured][:, place]
        fallen |= ended & (robots.state == TERMINATED) & (last[:, truth["fallen"]] > 0)
        running &= ~ended
    robots.close()
    seconds = actions * cycles / CYCLES_PER_SECOND
    return Result(returns, actions, last[:, truth["is_success"]] > 0, way / seconds, fallen)


def compare(task, file=None, episodes=128, first_seed=FIRST_SEED, options=None):
    """Prints the results of the policy in a file, if any, and of zero actions."""
    policies = {"zero actions": None}
    if file:
        policies = {str(file): PlayedPolicy(Path(file).read_text(encoding="utf-8")), **policies}
    for name, policy in policies.items():
        print(f"{name}: {evaluate(task, policy, episodes, first_seed, options)}", flush=True)


def main(words=None):
    """Runs the command line."""
    parser = argparse.ArgumentParser(prog="python -m robonewbie.evaluate", description="Evaluates a policy and compares it with zero actions.")
    parser.add_argument("task", help="Stand, EngineFollow, EngineRun, KickTo, GetUp, QuickGetUp, another task, or the name of a custom Java class")
    parser.add_argument("policy", nargs="?", type=Path, help="policy file; if omitted, only zero actions are evaluated")
    parser.add_argument("--n-eval-episodes", type=int, default=128, help="number of episodes (default: 128)")
    parser.add_argument("--first-seed", type=int, default=FIRST_SEED, help=f"seed of the first episode (default: {FIRST_SEED})")
    parser.add_argument("--option", action="append", default=[], metavar="NAME=VALUE", help="option of the task, such as cycles=2")
    wanted = parser.parse_args(words)
    compare(wanted.task, wanted.policy, wanted.n_eval_episodes, wanted.first_seed, options_of(wanted.option))


if __name__ == "__main__":
    main()

"""Evaluates policies on episodes that no training has seen, beside doing nothing.

    python -m robonewbie.evaluate Stand Stand.policy                  128 episodes each
    python -m robonewbie.evaluate QuickGetUp QuickGetUp.policy --option friction=2 --n-eval-episodes 256
"""

import argparse
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from robonewbie.environment import EpisodeSeeds
from robonewbie.simulator import RESET, SKIP, STEP, Connection
from robonewbie.train import options_of

# Trainings choose their episodes by seeds from 10 million on.
FIRST_SEED = 1_000_000


class PlayedPolicy:
    """A policy as it stands in its file, without PyTorch: it gives the actions of all robots for what they observe."""

    def __init__(self, text):
        self.inputs, self.cycles, self._layers = [], 1, []
        lines = iter(text.splitlines())
        for line in lines:
            words = line.split(" ")
            if words[0] == "input":
                self.inputs.append(words[1])
            if words[:2] == ["numbers", "cycles-per-action"]:
                self.cycles = int(words[2])
            if words[0] == "layer":
                rows = np.array([[float(word) for word in next(lines).split()] for _ in range(int(words[2]))])
                self._layers.append((rows[:, 1:].T, rows[:, 0], words[3]))

    def act(self, observation):
        """Gives a row of numbers from -1 to 1 for each row that is observed."""
        values = observation.astype(float)
        for weights, bias, activation in self._layers:
            values = values @ weights + bias
            values = np.tanh(values) if activation == "tanh" else np.clip(values, -1, 1)
        return values


@dataclass(frozen=True)
class Result:
    """Result of the episodes: returns, lengths in actions, and whether each was a success."""

    returns: np.ndarray
    actions: np.ndarray
    successes: np.ndarray

    def __str__(self):
        error = np.std(self.returns) / np.sqrt(len(self.returns))
        return f"return {np.mean(self.returns):.3f} ± {error:.3f}, success {np.sum(self.successes)} of {len(self.successes)}"


def evaluate(task, policy=None, episodes=128, first_seed=FIRST_SEED, options=None):
    """Plays each episode once, all at the same time; without a policy all actions are zero. Gives a Result.

    An action lasts as long as while the policy was learned, unless the option cycles says something else.
    """
    robots = Connection(task, episodes, "", {"cycles": policy.cycles if policy else 1, **(options or {})})
    described = robots.description
    names = [entry["name"] for entry in described["observation"]]
    places = [names.index(name) for name in policy.inputs] if policy else []
    seeds = EpisodeSeeds(episodes)
    seeds.begin(range(first_seed, first_seed + episodes))
    running = np.ones(episodes, dtype=bool)
    observation, _, _ = robots.act(RESET, seeds.draw(running), 0)
    returns, actions, successes = np.zeros(episodes), np.zeros(episodes, dtype=int), np.zeros(episodes, dtype=bool)
    success = robots.truth_names.index("is_success")
    while running.any():
        action = policy.act(observation[:, places]) if policy else 0
        observation, reward, _ = robots.act(np.where(running, STEP, SKIP), 0, action)
        returns[running] += reward[running]
        actions += running
        successes[running] = robots.truth[running, success] > 0
        running &= robots.state == 0
    robots.close()
    return Result(returns, actions, successes)


def main(words=None):
    """Evaluates what the command line names."""
    parser = argparse.ArgumentParser(prog="python -m robonewbie.evaluate", description="Evaluates a policy beside doing nothing.")
    parser.add_argument("task", help="Stand, EngineFollow, EngineRun, KickTo, GetUp, QuickGetUp, another task, or the name of a Java class of yours")
    parser.add_argument("policy", nargs="?", type=Path, help="file of the policy; without it only doing nothing is evaluated")
    parser.add_argument("--n-eval-episodes", type=int, default=128, help="how many (128)")
    parser.add_argument("--first-seed", type=int, default=FIRST_SEED, help=f"chooses the episodes ({FIRST_SEED})")
    parser.add_argument("--option", action="append", default=[], metavar="NAME=VALUE", help="changes the episodes, such as cycles=2")
    wanted = parser.parse_args(words)
    both = {"doing nothing": None}
    if wanted.policy:
        both = {str(wanted.policy): PlayedPolicy(wanted.policy.read_text(encoding="utf-8")), **both}
    for name, policy in both.items():
        print(f"{name}: {evaluate(wanted.task, policy, wanted.n_eval_episodes, wanted.first_seed, options_of(wanted.option))}")


if __name__ == "__main__":
    main()

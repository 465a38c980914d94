"""Many matches at once, with PettingZoo's names: each agent has an array with a row for each match.

>>> from robonewbie.matches import Matches
>>> matches = Matches("Match1v1", num_matches=64)
>>> observations, infos = matches.reset(seed=1)
>>> observations["left_1"].shape
(64, 9)
"""

from __future__ import annotations

from typing import Any

import numpy as np

from robonewbie.environment import EpisodeSeeds, SimulatedTask
from robonewbie.simulator import RESET, STEP_AND_RESET, TRUNCATED, RoboNewbieError


def stacked(actions: dict[str, np.ndarray], agents: list[str], axis: int = 0) -> np.ndarray:
    """Returns the actions of all agents in one array, in their order along an axis.

    :raises RoboNewbieError: if there is no action for one of them
    """
    missing = [agent for agent in agents if agent not in actions]
    if missing:
        raise RoboNewbieError(f"There is no action for {', '.join(missing)}. Each step needs an action for every robot.")
    return np.stack([actions[agent] for agent in agents], axis=axis)


class Matches(SimulatedTask):
    """Matches in one simulator. A match that is over begins again in the same step; ``infos`` then has its last observation under ``final_obs``.

    ``task`` is a task of :mod:`robonewbie.parallel`, and ``options`` are those of ``RoboNewbieEnv``.
    """

    def __init__(self, task: str = "Match1v1", num_matches: int = 1, render_mode: str | None = None, **options: Any) -> None:
        self.num_matches = num_matches
        self.observation_space_of_one, self.action_space_of_one = self._connect(task, num_matches, "", render_mode, options)
        self.possible_agents = self.agents = list(self.description["robots"])
        self._seeds = EpisodeSeeds(num_matches)
        self._every = np.ones(num_matches, dtype=bool)

    def observation_space(self, agent: str):
        """Returns the space of one robot."""
        return self.observation_space_of_one

    def action_space(self, agent: str):
        """Returns the space of one robot."""
        return self.action_space_of_one

    def reset(self, seed: int | list[int | None] | None = None, options: dict[str, Any] | None = None):
        """Begins all matches. Match i has the seed plus i, or its seed from a list."""
        if seed is not None:
            self._seeds.begin([seed + i for i in range(self.num_matches)] if np.isscalar(seed) else seed)
        self._change(options)
        observation, _, _ = self._act(RESET, self._seeds.draw(self._every), 0)
        self._next = self._seeds.draw(self._every)
        return self._each(observation), self._infos(observation)

    def step(self, actions: dict[str, np.ndarray]):
        """Returns observations, rewards, terminations, truncations and infos; each is a dictionary by agent, with arrays."""
        rows = stacked(actions, self.agents, axis=1).reshape(-1, len(self.action_names))
        observation, reward, terminated = self._act(STEP_AND_RESET, self._next, rows)
        truncated = self._rows(self._connection.state == TRUNCATED)
        terminated = self._rows(terminated)
        infos = self._infos(observation)
        done = terminated[:, 0] | truncated[:, 0]
        if done.any():
            observation = observation.copy()
            observation[done] = self._connection.fresh.reshape(-1, *observation.shape[1:])
            self._next = np.where(done, self._seeds.draw(done), self._next)
        return self._each(observation), self._each(self._rows(reward)), self._each(terminated), self._each(truncated), infos

    def _act(self, what, seeds, actions):
        observation, reward, terminated = self._connection.act(what, np.repeat(seeds, len(self.agents)), actions)
        return self._rows(observation), reward, terminated

    def _rows(self, values):
        return values.reshape(self.num_matches, len(self.agents), *values.shape[1:])

    def _each(self, values):
        return {agent: values[:, i] for i, agent in enumerate(self.agents)}

    def _infos(self, observation):
        truth = self._each(self._rows(self._connection.truth))
        names = self._connection.truth_names
        last = self._each(observation)
        return {agent: {**dict(zip(names, truth[agent].T)), "final_obs": last[agent]} for agent in self.agents}

"""Matches in which all robots learn, with the interface of PettingZoo's ParallelEnv.

>>> from robonewbie.parallel import parallel_env
>>> match = parallel_env("Match1v1")
>>> observations, infos = match.reset(seed=1)
"""

from __future__ import annotations

import copy
from typing import Any

import gymnasium
import numpy as np
from gymnasium.utils import seeding
from pettingzoo import ParallelEnv

from robonewbie.environment import CYCLES_PER_SECOND, RENDER_MODES, SEED_LIMIT, SimulatedTask
from robonewbie.matches import stacked
from robonewbie.simulator import RESET, STEP, TRUNCATED, RoboNewbieError


class RoboNewbieParallelEnv(SimulatedTask, ParallelEnv):
    """Two teams of agents ``left_1`` to ``right_11``. An action is a velocity for the walk, held for 0.2 s
    unless the option ``cycles`` is set. :class:`robonewbie.matches.Matches` steps many matches at once.

    ``task`` is ``Match1v1``, ``Match2v2``, ``Match11v11``, ``KeeperAgainstAttacker``, or a custom Java class with several
    ``learners``. ``options`` are those of ``RoboNewbieEnv``.
    """

    metadata = {"name": "robonewbie_v1", "render_modes": RENDER_MODES, "render_fps": CYCLES_PER_SECOND, "is_parallelizable": True}

    def __init__(self, task: str = "Match1v1", render_mode: str | None = None, **options: Any) -> None:
        observation, action = self._connect(task, 1, "", render_mode, options)
        self.possible_agents = list(self.description["robots"])
        self.agents = []
        self.observation_spaces = {agent: copy.deepcopy(observation) for agent in self.possible_agents}
        self.action_spaces = {agent: copy.deepcopy(action) for agent in self.possible_agents}
        self._random, _ = seeding.np_random()

    def observation_space(self, agent: str) -> gymnasium.spaces.Box:
        return self.observation_spaces[agent]

    def action_space(self, agent: str) -> gymnasium.spaces.Box:
        return self.action_spaces[agent]

    def reset(
        self, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[dict[str, np.ndarray], dict[str, dict[str, Any]]]:
        if seed is not None:
            self._random, _ = seeding.np_random(seed)
        # PettingZoo's API test passes an option that is called "options".
        self._change({name: value for name, value in (options or {}).items() if name != "options"})
        self.agents = list(self.possible_agents)
        observation, _, _ = self._connection.act(RESET, int(self._random.integers(SEED_LIMIT)), 0)
        return self._each(observation), self._infos()

    def step(
        self, actions: dict[str, np.ndarray]
    ) -> tuple[dict[str, np.ndarray], dict[str, float], dict[str, bool], dict[str, bool], dict[str, dict[str, Any]]]:
        if not self.agents:
            raise RoboNewbieError("The match is over. Call reset().")
        rows = stacked(actions, self.possible_agents)
        observation, reward, terminated = self._connection.act(STEP, 0, rows)
        truncated = self._connection.state == TRUNCATED
        results = (
            self._each(observation),
            self._each(reward.tolist()),
            self._each(terminated.tolist()),
            self._each(truncated.tolist()),
            self._infos(),
        )
        if terminated.any() or truncated.any():
            self.agents = []
        return results

    def _each(self, values):
        return dict(zip(self.possible_agents, values))

    def _infos(self):
        return self._each(self._connection.infos())


def parallel_env(task: str = "Match1v1", **keywords: Any) -> RoboNewbieParallelEnv:
    """Creates a match, like the factory functions of PettingZoo's environments."""
    return RoboNewbieParallelEnv(task, **keywords)

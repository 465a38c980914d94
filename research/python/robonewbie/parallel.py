"""Matches in which all robots learn, with the interface of PettingZoo's ParallelEnv.

>>> from robonewbie.parallel import parallel_env
>>> match = parallel_env("Match1v1")
>>> observations, infos = match.reset(seed=1)
"""

import numpy as np
from gymnasium.utils import seeding
from pettingzoo import ParallelEnv

from robonewbie.environment import RENDER_MODES, checked_render_mode, show, spaces_of
from robonewbie.picture import draw
from robonewbie.simulator import RESET, STEP, TRUNCATED, Connection, RoboNewbieError

_SEEDS = 2**62


class RoboNewbieParallelEnv(ParallelEnv):
    """Two teams, ``left_1`` to ``right_11``; a step is a cycle of 20 ms unless the option ``cycles`` says otherwise.

    ``task`` is ``Match1v1``, ``Match2v2``, ``Match11v11``, ``KeeperAgainstAttacker``, or a Java class of yours with several
    ``learners``. ``options`` are those of ``RoboNewbieEnv``.
    """

    metadata = {"name": "robonewbie_v1", "render_modes": RENDER_MODES, "render_fps": 50, "is_parallelizable": True}

    def __init__(self, task="Match1v1", render_mode=None, **options):
        self.render_mode = checked_render_mode(render_mode)
        self._options = options
        self._changed = False
        self._connection = Connection(task, 1, "", options)
        description = self._connection.description
        self.possible_agents = list(description["robots"])
        self.agents = []
        observation, action = spaces_of(description)
        self.observation_spaces = {agent: _copy(observation) for agent in self.possible_agents}
        self.action_spaces = {agent: _copy(action) for agent in self.possible_agents}
        self.observation_names = [entry["name"] for entry in description["observation"]]
        self.action_names = description["action"]
        self.studio_address = show(self._connection) if render_mode == "human" else None
        self._random, _ = seeding.np_random()

    def observation_space(self, agent):
        return self.observation_spaces[agent]

    def action_space(self, agent):
        return self.action_spaces[agent]

    def reset(self, seed=None, options=None):
        if seed is not None:
            self._random, _ = seeding.np_random(seed)
        options = {name: value for name, value in (options or {}).items() if name != "options"}  # PettingZoo's own test gives this
        if options or self._changed:
            self._connection.change({**self._options, **options})
            self._changed = bool(options)
        self.agents = list(self.possible_agents)
        observation, _, _ = self._connection.act(RESET, int(self._random.integers(_SEEDS)), 0)
        return self._each(observation), self._infos()

    def step(self, actions):
        if not self.agents:
            raise RoboNewbieError("The match is over. Call reset.")
        missing = [agent for agent in self.agents if agent not in actions]
        if missing:
            raise RoboNewbieError(f"There is no action for {', '.join(missing)}: each robot needs one in each step.")
        rows = np.stack([actions[agent] for agent in self.possible_agents])
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
        names = self._connection.truth_names
        return self._each([dict(zip(names, row)) for row in self._connection.truth.tolist()])

    def render(self):
        """Returns a picture as an array of 360 x 480 x 3 bytes if ``render_mode`` is ``"rgb_array"``."""
        return draw(self._connection.picture(0)) if self.render_mode == "rgb_array" else None

    def close(self):
        self._connection.close()


def _copy(space):
    return type(space)(space.low, space.high, dtype=space.dtype)


def parallel_env(task="Match1v1", **keywords):
    """Makes a match, as PettingZoo's own environments are made."""
    return RoboNewbieParallelEnv(task, **keywords)

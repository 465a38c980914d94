"""One robot with the interface of gymnasium.Env."""

import gymnasium
import numpy as np

from robonewbie.simulator import RESET, STEP, Connection

_SEEDS = 2**62


def spaces_of(description):
    """Makes the spaces of observation and action from what the simulator tells."""
    low = np.array([entry["least"] for entry in description["observation"]], dtype=np.float32)
    high = np.array([entry["greatest"] for entry in description["observation"]], dtype=np.float32)
    observation = gymnasium.spaces.Box(low, high, dtype=np.float32)
    action = gymnasium.spaces.Box(-1.0, 1.0, (len(description["action"]),), dtype=np.float32)
    return observation, action


class RoboNewbieEnv(gymnasium.Env):
    """A task for one robot; one step is a cycle of 20 ms.

    ``observation_names``, ``observation_units`` and ``action_names`` tell what the numbers are. An action is, for each joint,
    the angle to go to: -1 to 1 times ``range_degrees`` from the first posture. ``reward`` is the name of a measure such as
    ``"energy"``; without it the task decides what it pays.
    """

    metadata = {"render_modes": []}

    def __init__(self, task="Walk", reward="", render_mode=None):
        if render_mode is not None:
            raise ValueError(f"There is no render_mode \"{render_mode}\"; leave it out.")
        self.render_mode = None
        self._connection = Connection(task, 1, reward)
        description = self._connection.description
        self.observation_space, self.action_space = spaces_of(description)
        self.observation_names = [entry["name"] for entry in description["observation"]]
        self.observation_units = [entry["unit"] for entry in description["observation"]]
        self.action_names = description["action"]
        self.range_degrees = description["rangeDegrees"]

    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed)
        episode = int(self.np_random.integers(_SEEDS))
        observation, _, _ = self._connection.act(RESET, episode, 0)
        return observation[0], {}

    def step(self, action):
        observation, reward, over = self._connection.act(STEP, 0, action)
        return observation[0], float(reward[0]), bool(over[0]), False, {}

    def close(self):
        self._connection.close()

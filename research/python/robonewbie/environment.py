"""Environment for one robot with the interface of gymnasium.Env, and the base class of all environments."""

import sys
import webbrowser

import gymnasium
import numpy as np

from robonewbie.picture import draw
from robonewbie.simulator import RESET, STEP, TRUNCATED, Connection, RoboNewbieError

SEED_LIMIT = 2**62
RENDER_MODES = ["human", "rgb_array"]


class EpisodeSeeds:
    """Generates the seeds of episodes, with a separate random generator for each environment."""

    def __init__(self, count):
        self._generators = [np.random.default_rng() for _ in range(count)]

    def begin(self, seeds):
        """Seeds the generators; ``None`` leaves a generator unchanged."""
        for i, seed in enumerate(seeds):
            if seed is not None:
                self._generators[i] = np.random.default_rng(seed)

    def draw(self, needed):
        """Returns a seed for each environment that a boolean mask selects, and 0 for all others."""
        return np.array([g.integers(SEED_LIMIT) if n else 0 for g, n in zip(self._generators, needed)], dtype=np.int64)


def spaces_of(description):
    """Creates the observation and action spaces from the description of a task."""
    low = np.array([entry["least"] for entry in description["observation"]], dtype=np.float32)
    high = np.array([entry["greatest"] for entry in description["observation"]], dtype=np.float32)
    observation = gymnasium.spaces.Box(low, high, dtype=np.float32)
    action = gymnasium.spaces.Box(-1.0, 1.0, (len(description["action"]),), dtype=np.float32)
    return observation, action


class SimulatedTask:
    """Base class of all environments: connection to the simulator, episode options, and rendering."""

    def _connect(self, task, count, reward, render_mode, options):
        if render_mode is not None and render_mode not in RENDER_MODES:
            raise ValueError(f'There is no render_mode "{render_mode}". Available: {", ".join(RENDER_MODES)}; or omit the argument.')
        self.render_mode = render_mode
        self._options = options
        self._changed = False
        self._connection = Connection(task, count, reward, options)
        self.description = self._connection.description
        self.observation_names = [entry["name"] for entry in self.description["observation"]]
        self.observation_units = [entry["unit"] for entry in self.description["observation"]]
        self.action_names = self.description["action"]
        self.studio_address = self._show() if render_mode == "human" else None
        return spaces_of(self.description)

    def _show(self):
        address, file = self._connection.show(0)
        print(f"Studio: {address}", file=sys.stderr)
        webbrowser.open(file)  # the file hides the access code from command lines, which all users of the computer can read
        return address

    def _change(self, options):
        """Sets options for the next episode, in addition to those of the constructor."""
        if options or self._changed:
            self._connection.change({**self._options, **(options or {})})
            self._changed = bool(options)

    def render(self):
        """Returns an image as an array of 360 x 480 x 3 bytes if ``render_mode`` is ``"rgb_array"``."""
        return draw(self._connection.picture(0)) if self.render_mode == "rgb_array" else None

    def close(self):
        self._connection.close()


class RoboNewbieEnv(SimulatedTask, gymnasium.Env):
    """A task for one robot; a step is a cycle of 20 ms.

    ``observation_names``, ``observation_units`` and ``action_names`` describe the spaces. An action contains a target angle for each
    joint: -1 to 1 times ``range_degrees``, relative to the initial posture.

    ``reward`` is the name of a measure such as ``"energy"`` that replaces the reward of the task. ``options`` change the episodes:
    ``x``, ``y``, ``ball_x``, ``ball_y`` (metres), ``heading`` (degrees), ``push`` (increase in newtons from one push to the next, with one
    push per second), ``delay`` (cycles until an action takes effect), ``cycles`` (per action; default: 1), ``noise`` (standard deviation of
    additional noise in joint angles, gyroscope and accelerometer), ``friction`` and ``mass`` (relative to the default) and, for ``Follow``
    and similar tasks, ``forward``, ``left`` (m/s) and ``turn`` (degrees/s). Each option is a number, or a pair (low, high) from which each
    episode draws. ``reset(options={...})`` changes only the next episode.

    ``render_mode="human"`` opens the studio, in which the robot moves in real time and can be paused.

    ``info`` contains the true state. To customise a task, override ``observation``, ``reward`` and ``termination``:

    >>> class Crouch(RoboNewbieEnv):
    ...     def reward(self, reward, info):
    ...         return -info["height"]
    """

    metadata = {"render_modes": RENDER_MODES, "render_fps": 50}

    def __init__(self, task="Walk", reward="", render_mode=None, **options):
        self._arguments = {"task": task, "reward": reward, "render_mode": render_mode, **options}
        self.observation_space, self.action_space = self._connect(task, 1, reward, render_mode, options)
        if len(self.description["robots"]) > 1:
            raise RoboNewbieError(f"{task} trains several robots. Use robonewbie.parallel.parallel_env(\"{task}\").")
        self.range_degrees = self.description["rangeDegrees"]
        self.cycles = options.get("cycles", 1)

    def observation(self, observation, info):
        """Returns the observation for a step. Override to derive it from the sensor readings or the true state."""
        return observation

    def reward(self, reward, info):
        """Returns the reward for a step. Override to replace the task's reward."""
        return reward

    def termination(self, terminated, info):
        """Returns whether the episode is terminated. Override to replace the task's decision."""
        return terminated

    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed)
        self._change(options)
        observation, _, _ = self._connection.act(RESET, int(self.np_random.integers(SEED_LIMIT)), 0)
        info = self._info()
        return self.observation(observation[0], info), info

    def step(self, action):
        action = np.asarray(action, dtype=float)
        if action.shape != self.action_space.shape:
            raise RoboNewbieError(
                f"The action has the shape {action.shape} instead of {self.action_space.shape}: one number for each of "
                f"{', '.join(self.action_names)}."
            )
        observation, reward, terminated = self._connection.act(STEP, 0, action)
        info = self._info()
        return (
            self.observation(observation[0], info),
            float(self.reward(float(reward[0]), info)),
            bool(self.termination(bool(terminated[0]), info)),
            bool(self._connection.state[0] == TRUNCATED),
            info,
        )

    def _info(self):
        info = {name: float(value) for name, value in zip(self._connection.truth_names, self._connection.truth[0])}
        for name in ("fallen", "is_success"):
            info[name] = bool(info[name])
        return info

    def __getstate__(self):
        """Returns the constructor's arguments for pickling; unpickling creates a new environment."""
        return self._arguments

    def __setstate__(self, arguments):
        self.__init__(**arguments)

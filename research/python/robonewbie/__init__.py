"""Gymnasium environments for a simulated NAO humanoid robot.

>>> import gymnasium, robonewbie
>>> env = gymnasium.make("RoboNewbie/Walk-v1")
>>> observation, info = env.reset(seed=1)
>>> observation, reward, terminated, truncated, info = env.step(env.action_space.sample())
"""

import gymnasium

from robonewbie.environment import RoboNewbieEnv
from robonewbie.model import model_path
from robonewbie.simulator import RoboNewbieError
from robonewbie.vector import RoboNewbieVectorEnv

__all__ = ["RoboNewbieEnv", "RoboNewbieError", "RoboNewbieVectorEnv", "model_path"]

_MAX_CYCLES = {
    "Stand": 500,
    "Walk": 1000,
    "Follow": 500,
    "EngineFollow": 500,
    "Run": 500,
    "EngineRun": 500,
    "GetUp": 500,
    "QuickGetUp": 200,
    "Kick": 250,
    "KickTo": 150,
    "Reach": 100,
}

for _task, _cycles in _MAX_CYCLES.items():
    gymnasium.register(
        id=f"RoboNewbie/{_task}-v1",
        entry_point="robonewbie.environment:RoboNewbieEnv",
        vector_entry_point="robonewbie.vector:RoboNewbieVectorEnv",
        max_episode_steps=_cycles,
        kwargs={"task": _task},
    )

"""Stable-Baselines3 by its own documentation; skipped where it is not installed."""

import unittest
from unittest import mock

import gymnasium
import numpy as np

import robonewbie  # noqa: F401 registers the tasks

try:
    from stable_baselines3 import PPO
    from stable_baselines3.common.env_checker import check_env
    from stable_baselines3.common.env_util import make_vec_env

    from robonewbie.sb3 import VecEnv
except ImportError:
    PPO = None


@unittest.skipUnless(PPO, "stable-baselines3 is not installed")
class StableBaselinesTest(unittest.TestCase):
    def test_each_task_passes_its_checker(self):
        for task in ["Stand", "Walk", "Follow", "GetUp", "Kick", "Reach", "Run", "EngineFollow", "EngineRun", "KickTo", "QuickGetUp"]:
            with self.subTest(task), mock.patch("webbrowser.open"):
                env = gymnasium.make(f"RoboNewbie/{task}-v1").unwrapped
                check_env(env)
                env.close()

    def test_learns_a_task_by_its_name(self):
        PPO("MlpPolicy", "RoboNewbie/Reach-v1", n_steps=64, batch_size=32).learn(128)

    def test_makes_vectors_by_name(self):
        robots = make_vec_env("RoboNewbie/Reach-v1", 2, env_kwargs={"render_mode": "rgb_array"})
        robots.reset()
        robots.step(np.zeros((2, 4)))
        self.assertEqual(robots.render().shape, (720, 480, 3))
        robots.close()

    def test_own_vector_gives_the_episodes_of_single_environments(self):
        robots = VecEnv("Reach", 2)
        robots.seed(5)
        rows = [robots.reset()]
        action = np.full((2, 4), 0.3, dtype=np.float32)
        infos, done = [], np.zeros(2, dtype=bool)
        while not done.any():
            observation, _, done, infos = robots.step(action)
            rows.append(observation)
        robots.close()

        self.assertTrue(all(info["TimeLimit.truncated"] for info in infos))
        for i in range(2):
            alone = gymnasium.make("RoboNewbie/Reach-v1")
            own = [alone.reset(seed=5 + i)[0]] + [alone.step(action[i])[0] for _ in range(100)]
            alone.close()
            np.testing.assert_array_equal([row[i] for row in rows[:-1]], own[:-1])
            np.testing.assert_array_equal(infos[i]["terminal_observation"], own[-1])

    def test_own_vector_is_learned_from(self):
        robots = VecEnv("Reach", 4)
        PPO("MlpPolicy", robots, n_steps=50, batch_size=100).learn(400)
        robots.close()


if __name__ == "__main__":
    unittest.main()

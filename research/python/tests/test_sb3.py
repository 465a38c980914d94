"""Stable-Baselines3 by its own documentation; skipped where it is not installed."""

import pickle
import unittest
from unittest import mock

import gymnasium
import numpy as np

import robonewbie  # noqa: F401 registers the tasks

try:
    from stable_baselines3 import PPO
    from stable_baselines3.common.env_checker import check_env
    from stable_baselines3.common.env_util import make_vec_env

    from robonewbie import RoboNewbieError
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

    def test_own_vector_takes_registered_ids(self):
        robots = VecEnv("robonewbie:RoboNewbie/Reach-v1", 2)
        self.assertEqual(robots.description["task"], "Reach")
        robots.close()

    def test_episode_statistics_are_those_of_the_monitor(self):
        robots = VecEnv("RoboNewbie/Reach-v1", 2)
        robots.seed(5)
        robots.reset()
        rewards, done = [], np.zeros(2, dtype=bool)
        while not done.any():
            _, reward, done, infos = robots.step(np.zeros((2, 4)))
            rewards.append(reward)
        robots.close()
        for i in range(2):
            self.assertEqual(infos[i]["episode"]["l"], 100)
            self.assertAlmostEqual(infos[i]["episode"]["r"], np.sum(rewards, axis=0)[i], places=3)

        model = PPO("MlpPolicy", VecEnv("Reach", 4), n_steps=100, batch_size=100)
        model.learn(400)
        self.assertEqual(len(model.ep_info_buffer), 4)
        model.env.close()

    def test_options_change_the_episodes_that_begin_from_then_on(self):
        robots = VecEnv("Walk", 4)
        robots.set_options({"x": 3.0, "cycles": 1000, "push": 0})
        robots.reset()
        self.assertEqual([round(info["x"], 1) for info in robots.reset_infos], [3.0] * 4)
        self.assertEqual(robots.metadata["render_fps"], 0.05)
        robots.set_options()
        _, _, done, _ = robots.step(np.zeros((4, 12)))
        self.assertTrue(done.all())
        _, _, done, infos = robots.step(np.zeros((4, 12)))
        self.assertFalse(done.any())
        self.assertTrue(all(info["x"] < 2 for info in infos))
        with self.assertRaisesRegex(RoboNewbieError, "All robots have the same options"):
            robots.set_options([{"x": 1}, {"x": 2}, {"x": 1}, {"x": 1}])
        robots.close()

    def test_methods_and_attributes_belong_to_all_robots(self):
        robots = ManyCrouch(3)
        robots.env_method("sink", 0.2)
        self.assertEqual(robots.get_attr("depth", indices=[0, 2]), [0.2, 0.2])
        robots.set_attr("depth", 0.1)
        self.assertEqual(robots.depth, 0.1)
        with self.assertRaisesRegex(RoboNewbieError, "Omit the argument indices"):
            robots.env_method("sink", 0.3, indices=1)
        robots.close()

    def test_hooks_on_arrays_choose_observation_reward_and_end(self):
        robots = pickle.loads(pickle.dumps(ManyCrouch(2)))
        robots.seed(1)
        first = robots.reset()
        self.assertEqual(first.shape, (2, *robots.observation_space.shape))
        bend = -np.array([1.0 if name.endswith("KNEE_PITCH") else 0.0 for name in robots.action_names])
        done = np.zeros(2, dtype=bool)
        while not done.any():
            observation, reward, done, infos = robots.step(np.stack([bend, 0 * bend]))
            np.testing.assert_allclose(reward, [-info["height"] for info in infos], rtol=1e-6)
        self.assertEqual(done.tolist(), [True, False])
        self.assertFalse(infos[0]["TimeLimit.truncated"])
        self.assertLess(infos[0]["terminal_observation"][-1], 0.31)
        self.assertGreater(observation[0, -1], 0.34)
        robots.close()

    def test_registered_time_limit_holds(self):
        gymnasium.register(
            "Brief/Reach-v0", "robonewbie.environment:RoboNewbieEnv", max_episode_steps=10, kwargs={"task": "Reach"}
        )
        robots = VecEnv("Brief/Reach-v0", 2)
        robots.reset()
        ends = [robots.step(np.zeros((2, 4)))[2].all() for _ in range(20)]
        self.assertEqual([i for i, end in enumerate(ends) if end], [9, 19])
        robots.close()


if PPO:

    class ManyCrouch(VecEnv):
        """Ends when the torso has sunk; observes its height as well."""

        def __init__(self, robots):
            super().__init__("Stand", robots, push=0)
            self.depth = 0.05
            low, high = self.observation_space.low, self.observation_space.high
            self.observation_space = gymnasium.spaces.Box(np.append(low, 0), np.append(high, 1), dtype=np.float32)

        def sink(self, depth):
            self.depth = depth

        def observation(self, observation, info):
            return np.column_stack([observation, info["height"]]).astype(np.float32)

        def reward(self, reward, info):
            return -info["height"]

        def termination(self, terminated, info):
            return terminated | (info["height"] < 0.36 - self.depth)


if __name__ == "__main__":
    unittest.main()

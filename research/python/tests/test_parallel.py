"""Matches by PettingZoo's own tests; skipped where it is not installed."""

import pickle
import unittest
import warnings

import numpy as np

try:
    from pettingzoo.test import parallel_api_test, parallel_seed_test

    from robonewbie import RoboNewbieEnv, RoboNewbieError
    from robonewbie.parallel import parallel_env
except ImportError:
    parallel_env = None


@unittest.skipUnless(parallel_env, "pettingzoo is not installed")
class ParallelTest(unittest.TestCase):
    def test_each_match_passes_the_tests_of_pettingzoo(self):
        for task, robots in {"Match1v1": 2, "Match2v2": 4, "KeeperAgainstAttacker": 2, "Match11v11": 22}.items():
            with self.subTest(task), warnings.catch_warnings():
                warnings.simplefilter("error", UserWarning)
                match = parallel_env(task, cycles=1)
                parallel_api_test(match, num_cycles=50)
                self.assertEqual(len(match.possible_agents), robots)
                match.close()
        parallel_seed_test(parallel_env, num_cycles=20)

    def test_match_is_pickled_and_its_videos_play_at_the_speed_of_the_simulation(self):
        match = parallel_env("Match1v1", cycles=5)
        twin = pickle.loads(pickle.dumps(match))
        self.assertEqual((match.metadata["render_fps"], twin.metadata["render_fps"]), (10, 10))
        observation, other = match.reset(seed=1)[0], twin.reset(seed=1)[0]
        for robot in match.agents:
            np.testing.assert_array_equal(observation[robot], other[robot])
        match.close()
        twin.close()

    def test_teams_lose_what_the_other_wins(self):
        match = parallel_env("KeeperAgainstAttacker", cycles=5)
        observations, _ = match.reset(seed=1)
        self.assertEqual(match.agents, ["left_1", "right_1"])
        ball = match.observation_names.index("ball.forward")
        self.assertAlmostEqual(float(observations["left_1"][ball]), 0.3 / 0.8, delta=0.4)
        rewards = match.step({agent: np.zeros(3, dtype=np.float32) for agent in match.agents})[1]
        self.assertLess(max(map(abs, rewards.values())), 0.1)
        with self.assertRaisesRegex(RoboNewbieError, "no action for right_1"):
            match.step({"left_1": np.zeros(3)})
        match.close()
        with self.assertRaisesRegex(RoboNewbieError, "trains several robots"):
            RoboNewbieEnv("Match1v1")


if __name__ == "__main__":
    unittest.main()

"""Complete true state and randomised bodies, which are the same in all kinds of environments."""

import unittest

import numpy as np

import robonewbie

try:
    from robonewbie.sb3 import VecEnv
except ImportError:
    VecEnv = None

try:
    from robonewbie.parallel import parallel_env
except ImportError:
    parallel_env = None


class TrueStateTest(unittest.TestCase):
    def setUp(self):
        self.env = robonewbie.RoboNewbieEnv("Stand", push=0, true_state=True)
        self.addCleanup(self.env.close)

    def named(self, info):
        return dict(zip(self.env.true_state_names, info["true_state"].tolist()))

    def test_vector_has_names_and_describes_the_standing_robot(self):
        _, info = self.env.reset(seed=1)
        for _ in range(20):
            _, _, _, _, info = self.env.step(np.zeros(12))

        state = self.named(info)

        self.assertEqual(len(info["true_state"]), len(self.env.true_state_units))
        self.assertEqual(len(set(self.env.true_state_names)), len(self.env.true_state_names))
        self.assertAlmostEqual(state["torso.x"], info["x"], places=5)
        self.assertAlmostEqual(state["torso.z"], info["height"], places=5)
        self.assertAlmostEqual(state["torso.up.up"], np.cos(np.radians(info["tilt"])), places=4)
        self.assertAlmostEqual(state["torso.heading.sine"], np.sin(np.radians(info["heading"])), places=4)
        self.assertAlmostEqual(state["leftFoot.force.up"] + state["rightFoot.force.up"], 4.6 * 9.81, delta=3)
        self.assertGreater(abs(state["torque.LEFT_KNEE_PITCH"]), 0.1)
        self.assertAlmostEqual(state["speed.LEFT_KNEE_PITCH"], 0, delta=1)

    def test_speed_is_the_change_of_the_angle(self):
        self.env.reset(seed=1)
        action = np.array([0.1 if name.endswith("KNEE_PITCH") else 0 for name in self.env.action_names])
        angles, speeds = [], []
        for _ in range(4):
            state = self.named(self.env.step(action)[-1])
            angles.append(state["joint.LEFT_KNEE_PITCH"])
            speeds.append(state["speed.LEFT_KNEE_PITCH"])
        np.testing.assert_allclose(np.diff(angles) / 0.02, speeds[1:], atol=5)
        self.assertGreater(max(speeds), 20)

    def test_same_vector_in_all_kinds_of_environments(self):
        _, info = self.env.reset(seed=3)
        many = robonewbie.RoboNewbieVectorEnv("Stand", 2, push=0, true_state=True)
        self.addCleanup(many.close)
        np.testing.assert_array_equal(many.reset(seed=3)[1]["true_state"][0], info["true_state"])
        if VecEnv:
            robots = VecEnv("Stand", 2, push=0, true_state=True)
            robots.seed(3)
            robots.reset()
            np.testing.assert_array_equal(robots.reset_infos[0]["true_state"], info["true_state"])
            robots.step(np.zeros((2, 12)))
            robots.close()
        if parallel_env:
            match = parallel_env("Match1v1", true_state=True)
            _, infos = match.reset(seed=3)
            self.assertEqual(len(infos["right_1"]["true_state"]), len(self.env.true_state_names))
            self.assertGreater(infos["right_1"]["true_state"][0], infos["left_1"]["true_state"][0])
            match.close()

    def test_is_chosen_in_the_constructor(self):
        plain = robonewbie.RoboNewbieEnv("Stand")
        self.addCleanup(plain.close)
        self.assertNotIn("true_state", plain.reset(seed=1)[1])
        with self.assertRaisesRegex(robonewbie.RoboNewbieError, "Pass it when the environment is made"):
            plain.reset(options={"true_state": 1})


class RandomisedBodyTest(unittest.TestCase):
    def episode(self, seed=1, action=None, steps=40, **options):
        env = robonewbie.RoboNewbieEnv("Stand", push=0, true_state=True, **options)
        env.reset(seed=seed)
        chosen = np.zeros(12) if action is None else action(env)
        states = [env.step(chosen)[-1]["true_state"] for _ in range(steps)]
        env.close()
        return dict(zip(env.true_state_names, np.array(states).T))

    def test_weak_joints_give_way_each_by_its_own_strength(self):
        normal = self.episode()
        weak = self.episode(strength=0.05)
        drawn = self.episode(strength=(0.02, 0.1))
        self.assertAlmostEqual(normal["torso.z"][-1], normal["torso.z"][0], delta=0.01)
        self.assertLess(weak["torso.z"][-1], normal["torso.z"][-1] - 0.02)
        left, right = (np.abs(drawn[f"torque.{side}_SHOULDER_PITCH"]).max() for side in ("LEFT", "RIGHT"))
        self.assertNotAlmostEqual(left, right, delta=0.001)
        np.testing.assert_array_equal(drawn["torso.z"], self.episode(strength=(0.02, 0.1))["torso.z"])

    def test_displaced_weight_loads_feet_and_ankles(self):
        def load(state):
            return state["leftFoot.force.up"][-1] - state["rightFoot.force.up"][-1]

        def ankles(state):
            return state["torque.LEFT_FOOT_PITCH"][-1] + state["torque.RIGHT_FOOT_PITCH"][-1]

        self.assertGreater(load(self.episode(com_left=0.03)), 1)
        self.assertLess(load(self.episode(com_left=-0.03)), -1)
        moment = 1.2171 * 9.81 * 0.03
        self.assertAlmostEqual(ankles(self.episode()) - ankles(self.episode(com_forward=0.03)), moment, delta=0.02)

    def test_soles_of_little_grip_do_not_resist_legs_that_spread(self):
        def spread(env):
            sides = {"LEFT_HIP_ROLL": 0.8, "RIGHT_HIP_ROLL": -0.8}
            return np.array([sides.get(name, 0) for name in env.action_names])

        normal, slippery = (self.episode(action=spread, steps=13, sole_friction=grip) for grip in (1, 0.05))
        self.assertGreater(abs(normal["leftFoot.force.left"][-1]), 30)
        self.assertLess(abs(slippery["leftFoot.force.left"][-1]), 15)

    def test_jitter_delays_an_action_by_a_random_time(self):
        def bend(env):
            return np.array([0.2 if name.endswith("KNEE_PITCH") else 0 for name in env.action_names])

        def first_motion(seed, **options):
            knee = self.episode(seed, bend, 12, **options)["joint.LEFT_KNEE_PITCH"]
            return int(np.argmax(np.abs(knee - knee[0]) > 0.5))

        on_time = first_motion(1)
        late = [first_motion(seed, jitter=4) - on_time for seed in range(8)]
        self.assertGreater(len(set(late)), 1)
        self.assertTrue(all(0 <= cycles <= 4 for cycles in late), late)

    @unittest.skipUnless(VecEnv, "stable-baselines3 is not installed")
    def test_options_apply_to_vectors_in_training(self):
        robots = VecEnv("Stand", 2, push=0)
        robots.set_options({"strength": 0.05})
        robots.reset()
        for _ in range(40):
            _, _, _, infos = robots.step(np.zeros((2, 12)))
        self.assertLess(infos[0]["height"], self.episode()["torso.z"][-1] - 0.02)
        robots.close()

    @unittest.skipUnless(parallel_env, "pettingzoo is not installed")
    def test_options_apply_to_matches(self):
        heights = []
        for strength in (1, 0.05):
            match = parallel_env("Match1v1", strength=strength)
            match.reset(seed=1)
            for _ in range(5):
                infos = match.step({robot: np.zeros(3) for robot in match.possible_agents})[-1]
            heights.append(infos["right_1"]["height"])
            match.close()
        self.assertLess(heights[1], heights[0] - 0.02)


if __name__ == "__main__":
    unittest.main()

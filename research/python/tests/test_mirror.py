"""Mirrored actions lead to mirrored observations."""

import unittest

import numpy as np

import robonewbie


class MirrorTest(unittest.TestCase):
    def started(self, task, **options):
        env = robonewbie.RoboNewbieEnv(task, **options)
        self.addCleanup(env.close)
        return env, env.reset(seed=1)[0]

    def test_mirrored_actions_lead_to_mirrored_observations(self):
        env, _ = self.started("Stand", push=0, y=0)
        image, _ = self.started("Stand", push=0, y=0)
        indices, signs = env.action_mirror
        action = 0.3 * np.random.default_rng(1).uniform(-1, 1, 12)
        for _ in range(12):
            observation = env.step(action)[0]
            mirrored = image.step(signs * action[indices])[0]

        indices, signs = env.observation_mirror
        scale = np.maximum(np.abs(observation), [{"degrees": 1, "degrees/s": 20, "m/s²": 2, "m": 0.02, "N": 10}[unit] for unit in env.observation_units])
        np.testing.assert_allclose(signs * observation[indices] / scale[indices], mirrored / scale[indices], atol=0.1)
        self.assertGreater(np.abs(observation - mirrored).max(), 5)

    def test_arms_and_neck_are_mirrored_as_well(self):
        env, _ = self.started("GetUp", true_state=True, y=0)
        image, _ = self.started("GetUp", true_state=True, y=0)
        indices, signs = env.action_mirror
        action = np.array([0.2 if name.startswith("LEFT") else 0 for name in env.action_names])
        for _ in range(10):
            state = env.step(action)[-1]["true_state"]
            mirrored = image.step(signs * action[indices])[-1]["true_state"]

        indices, signs = robonewbie.mirror.mirror_of(env.true_state_names)
        for i, name in enumerate(env.true_state_names):
            if name.startswith(("joint.", "torso.up")):
                self.assertAlmostEqual(signs[i] * state[indices[i]], mirrored[i], delta=1, msg=name)

    def test_mirroring_twice_changes_nothing(self):
        for task in ("Follow", "Walk", "GetUp", "EngineRun"):
            env, observation = self.started(task)
            indices, signs = env.observation_mirror
            once = signs * observation[indices]
            np.testing.assert_array_equal(signs * once[indices], observation)

    def test_commands_and_places_change_sides(self):
        indices, signs = robonewbie.mirror.mirror_of(["command.forward", "command.left", "command.turn", "command.heading", "ball.horizontal", "ball.distance", "goal.left"])
        self.assertEqual(signs.tolist(), [1, -1, -1, -1, -1, 1, -1])
        self.assertEqual(indices.tolist(), list(range(7)))

    def test_tasks_without_a_mirror_image_say_so(self):
        for task, reason in (("KickTo", "its actions correct a motion"), ("Reach", "RIGHT_ARM_ROLL, .* is missing")):
            env, _ = self.started(task)
            with self.assertRaisesRegex(robonewbie.RoboNewbieError, f"not symmetric: {reason}"):
                env.action_mirror


if __name__ == "__main__":
    unittest.main()

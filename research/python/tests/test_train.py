"""Training by PPO and what it writes; the parts with Stable-Baselines3 are skipped where it is not installed."""

import io
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from unittest import mock

import numpy as np

from robonewbie import baselines, curve, evaluate, settings, simulator, train

try:
    import torch
except ImportError:
    torch = None

try:
    import stable_baselines3
except ImportError:
    stable_baselines3 = None

try:
    from tensorboard.backend.event_processing.event_accumulator import EventAccumulator
except ImportError:
    EventAccumulator = None


BASELINES = Path(__file__).parents[1] / "baselines"


def _board(text):
    """Returns return, its standard error and the number of successes of each task and policy on a board of baselines."""
    rows = re.findall(r"^\| `(\w+)` \| (\S+\.policy`|zero actions) \| (\S+) ± (\S+) \| (\d+) of \d+ \|", text, re.MULTILINE)
    return {(task, policy): (float(reward), float(error), int(successes)) for task, policy, reward, error, successes in rows}


def _scalars(run):
    """Returns what a run of TensorBoard contains: for each name its values by timestep."""
    events = EventAccumulator(str(run)).Reload()
    return {name: {event.step: event.value for event in events.Scalars(name)} for name in events.Tags()["scalars"]}


def _cell(recurrent):
    """Returns a cell with the parameters of a recurrent module."""
    cell = torch.nn.GRUCell(recurrent.input_size, recurrent.hidden_size, bias=recurrent.bias)
    cell.load_state_dict({name.removesuffix("_l0"): numbers for name, numbers in recurrent.state_dict().items()})
    return cell


class TrainTest(unittest.TestCase):
    def test_folded_layer_does_with_raw_numbers_what_the_other_does_with_normalised_ones(self):
        random = np.random.default_rng(1)
        weights, bias = random.normal(size=(3, 5)), random.normal(size=3)
        mean, variance, raw = random.normal(size=5), random.uniform(1, 9, size=5), random.normal(size=5)

        folded, shifted = train.fold(weights, bias, mean, variance, 1e-8)

        np.testing.assert_allclose(folded @ raw + shifted, weights @ ((raw - mean) / np.sqrt(variance + 1e-8)) + bias)

    def test_curve_is_a_picture_with_a_line_for_each_name(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "walk.policy.csv")
            file.write_text("generation,episodes,cycles,reward\n1,32,1000,-2\n2,32,1000,5\n", encoding="utf-8")

            picture = curve.svg([("walk", *curve.read(file))])

        root = ElementTree.fromstring(picture)
        self.assertIn("walk", [element.text for element in root.iter("{http://www.w3.org/2000/svg}text")])
        self.assertEqual(curve.smoothed([1, 3, 5], 2), [1, 2, 4])

    def test_curves_of_several_seeds_are_one_line_with_their_spread(self):
        with tempfile.TemporaryDirectory() as folder:
            files = []
            for seed, rewards in enumerate([(1, 2, 9), (3, 6)]):
                file = Path(folder, f"Stand-{seed}.policy.csv")
                lines = [f"{1000 * (i + 1)},{reward},50" for i, reward in enumerate(rewards)]
                file.write_text("\n".join(["steps,reward,cycles", *lines]) + "\n", encoding="utf-8")
                files.append(file)

            joined = curve.together("Stand", [curve.read(file) for file in files])

        self.assertEqual(joined, ("Stand", [0.001, 0.002], [2, 4], [1, 2], [3, 6]))
        root = ElementTree.fromstring(curve.svg([joined]))
        self.assertEqual(len(list(root.iter("{http://www.w3.org/2000/svg}polygon"))), 1)

    def test_baselines_name_what_they_have(self):
        with self.assertRaises(SystemExit), mock.patch("sys.stderr", io.StringIO()) as told:
            baselines.main(["Stnd"])
        self.assertIn("There is no baseline for Stnd. Available: Stand,", told.getvalue())

    def test_policy_carries_the_motion_of_its_task(self):
        text = train.policy_text("KickTo", ["learned"], [("gyro.left", "degrees/s")], ["NECK_YAW"], 30, [], [400, 0, -94.9])

        self.assertIn("numbers motion 400 0 -94.9\n", text)

    def test_policy_that_corrects_the_walk_carries_its_numbers_and_moves_swing_leg_and_support_leg(self):
        walk = {"step-millis": [200], "gait": [0.5, -1]}
        text = train.policy_text("EngineRun", ["learned"], [("pitch.error", "10 degrees")], ["swing_KNEE_PITCH"], 20, [], walk=walk)

        self.assertIn("numbers step-millis 200\nnumbers gait 0.5 -1\n", text)
        self.assertIn("input pitch.error 10 degrees\noutput swing_KNEE_PITCH 20 degrees\n", text)

    def test_policy_says_how_long_an_action_lasts(self):
        text = train.policy_text("Stand", ["learned"], [("gyro.left", "degrees/s")], ["NECK_YAW"], 30, [], cycles=4)

        self.assertIn("numbers cycles-per-action 4\n", text)

    def test_policy_is_played_as_it_stands_in_its_file(self):
        layers = [(np.array([[2.0], [0.0]]), np.array([1.0, 3.0]), "tanh"), (np.array([[2.0, 1.0]]), np.array([-1.0]), "cut")]
        policy = evaluate.PlayedPolicy(train.policy_text("Stand", ["learned"], [("gyro.left", "degrees/s")], ["NECK_YAW"], 30, layers))

        self.assertEqual(policy.inputs, ["gyro.left"])
        np.testing.assert_allclose(policy.act(np.array([[-0.5], [2.0]])), [[np.tanh(3) - 1], [1]])
        np.testing.assert_allclose(policy.act(np.array([[-9.0]])), [[-1]])

    def test_options_are_numbers_or_ranges(self):
        self.assertEqual(train.options_of(["cycles=2", "friction=0.5..2"]), {"cycles": 2, "friction": (0.5, 2)})
        for wrong in ("cycles", "mass=heavy", "mass=1..2..3"):
            with self.assertRaisesRegex(SystemExit, f'The option "{wrong}" is neither'):
                train.options_of([wrong])

    def test_arguments_have_the_best_known_values_unless_given(self):
        known = train.arguments(["KickTo"])
        given = train.arguments(["KickTo", "--gamma", "0.9", "--net-arch", "8", "--option", "cycles=2", "--option", "friction=0.5..2"])
        other = train.arguments(["GetUp"])

        self.assertEqual((known.n_envs, known.gamma, known.options, known.total_timesteps), (256, 1, {"cycles": 5}, 300_000))
        self.assertEqual((given.n_envs, given.gamma, given.net_arch), (256, 0.9, [8]))
        self.assertEqual(given.options, {"cycles": 2, "friction": (0.5, 2)})
        self.assertEqual((other.n_envs, other.gamma, other.options), (64, 0.99, {}))

    def test_evaluation_is_the_same_each_time_and_other_episodes_are_others(self):
        first, again, others = (evaluate.evaluate("Stand", None, 3, seed, {"push": 60}) for seed in (5, 5, 50))

        np.testing.assert_array_equal(first.returns, again.returns)
        self.assertFalse((first.returns == others.returns).all())
        self.assertFalse(first.successes.any())
        self.assertIn("success 0 of 3", str(first))

    def test_what_ppo_has_learned_pays_more_than_doing_nothing_in_each_task(self):
        gains = {"Stand": 10, "EngineFollow": 3, "EngineRun": 4, "KickTo": 0.1, "QuickGetUp": 0.1, "Walk": 5}
        board = _board((BASELINES.parents[2] / "docs" / "policies.md").read_text(encoding="utf-8"))
        for task, known in settings.TASKS.items():
            with self.subTest(task):
                options = train.options_of(known.options)
                policy = BASELINES / f"{task}-1.policy"
                learned = evaluate.evaluate(task, evaluate.PlayedPolicy(policy.read_text(encoding="utf-8")), 128, options=options)
                nothing = evaluate.evaluate(task, None, 128, options=options)

                self.assertGreater(np.mean(learned.returns), np.mean(nothing.returns) + gains[task])
                self.assertGreater(np.mean(learned.successes), np.mean(nothing.successes))
                for name, result in ((f"`{policy.name}`", learned), ("zero actions", nothing)):
                    reward, error, successes = board[task, name]
                    self.assertAlmostEqual(np.mean(result.returns), reward, delta=error + 0.0005)  # of printed digits
                    self.assertAlmostEqual(np.sum(result.successes), successes, delta=4)

    @unittest.skipUnless(stable_baselines3, "stable-baselines3 is not installed")
    def test_begins_with_doing_nothing_and_takes_what_it_is_told_to_take(self):
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder, "my.policy")
            words = ["Stand", "--n-envs", "2", "--net-arch", "--inputs", "gyro.*", "--option", "cycles=2", "--out", str(out)]
            begun = train.Training(train.arguments(words))
            policy = evaluate.PlayedPolicy(begun.text())
            begun.task.close()

            self.assertEqual(policy.inputs, ["gyro.forward", "gyro.left", "gyro.up"])
            np.testing.assert_array_equal(policy.act(np.array([[100.0, -50.0, 7.0]])), np.zeros((1, 12)))
            with self.assertRaisesRegex(SystemExit, "No observed quantity of Stand has a name that matches wing"):
                train.main(["Stand", "--n-envs", "2", "--inputs", "wing", "--out", str(out)])

    @unittest.skipUnless(stable_baselines3, "stable-baselines3 is not installed")
    @unittest.skipUnless(EventAccumulator, "tensorboard is not installed")
    def test_logs_losses_and_returns_beside_those_of_zero_actions_to_tensorboard(self):
        words = ["Reach", "--n-envs", "2", "--n-steps", "100", "--batch-size", "100", "--total-timesteps", "400", "--n-eval-episodes", "3", "--option", "x=1"]
        with tempfile.TemporaryDirectory() as folder, mock.patch("sys.stdout", io.StringIO()) as told:
            train.main([*words, "--out", str(Path(folder, "my.policy"))])
            learned, zero = (_scalars(Path(folder, "my.policy.tensorboard", run)) for run in ("", "zero_actions"))

        self.assertEqual(list(learned["rollout/ep_rew_mean"]), [200, 400])
        self.assertEqual(list(learned["train/value_loss"]), [200, 400])
        wanted = np.mean(evaluate.evaluate("Reach", None, 3, options={"x": 1}).returns)
        self.assertEqual(list(zero["rollout/ep_rew_mean"]), [0, 400])
        np.testing.assert_allclose(list(zero["rollout/ep_rew_mean"].values()), wanted, rtol=1e-6)
        self.assertIn(f"(zero actions {wanted:.3f}) in 100 cycles", told.getvalue())

    @unittest.skipUnless(stable_baselines3, "stable-baselines3 is not installed")
    def test_baseline_has_a_row_for_the_table(self):
        short = settings.Settings(512, "--n-envs 4 --n-steps 32 --batch-size 16 --net-arch 4 4", ("cycles=2", "push=60"))
        with tempfile.TemporaryDirectory() as folder, mock.patch.dict(settings.TASKS, Stand=short), mock.patch.object(
            baselines, "EPISODES", 4
        ), mock.patch("sys.stdout", io.StringIO()) as told:
            baselines.main(["Stand", "--out", folder, "--policy", str(BASELINES / "KickTo-1.policy")])

            self.assertTrue(Path(folder, "Stand.svg").exists())
        self.assertEqual(len(_board(told.getvalue())), 6)
        for seed in (1, 2, 3):
            self.assertRegex(told.getvalue(), rf"\| `Stand` \| `Stand-{seed}.policy` \| .* \| 0 of 4 \| 1,024 \| 0.00 \| `train Stand --seed {seed}` \|")

    @unittest.skipUnless(stable_baselines3, "stable-baselines3 is not installed")
    def test_goes_on_and_writes_a_policy_that_does_what_the_model_does(self):
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder, "my.policy")
            with self.assertRaisesRegex(SystemExit, "There is nothing to resume"):
                train.main(["Reach", "--out", str(out), "--resume"])
            words = ["Reach", "--n-envs", "2", "--n-steps", "32", "--batch-size", "8", "--sde-sample-freq", "4", "--net-arch", "16", "16", "--n-eval-episodes", "4", "--out", str(out)]
            with mock.patch("sys.stdout", io.StringIO()) as told:
                train.main([*words, "--total-timesteps", "64"])
            self.assertRegex(told.getvalue(), r"my.policy: return .*, success . of 4\nzero actions: return .*, success . of 4\n$")
            with self.assertRaisesRegex(SystemExit, r"A training run already exists in .*\. Resume it with --resume"):
                train.main([*words, "--total-timesteps", "64"])
            train.main([*words, "--total-timesteps", "256", "--resume"])

            training = train.Training(train.arguments([*words, "--resume"]))
            self.assertEqual(training.model.num_timesteps, 256)
            self.assertEqual(training.task._seeds, [10_000_256, 10_000_257])
            raw = training.normalised.venv.reset()[0]
            wanted, _ = training.model.predict(training.normalised.normalize_obs(raw), deterministic=True)
            training.task.close()
            self.assertEqual(raw[-1], 0)  # what only the critic takes: nothing of the episode is over
            values = evaluate.PlayedPolicy(out.read_text(encoding="utf-8")).act(raw[None, :-1])
            np.testing.assert_allclose(values[0], wanted, atol=2e-3)

    @unittest.skipUnless(stable_baselines3, "stable-baselines3 is not installed")
    def test_symmetric_policy_does_the_mirrored_action_in_the_mirrored_situation_and_so_does_its_file(self):
        with tempfile.TemporaryDirectory() as folder, mock.patch("sys.stdout", io.StringIO()):
            out = Path(folder, "my.policy")
            words = ["Walk", "--n-envs", "4", "--n-steps", "32", "--batch-size", "32", "--net-arch", "8", "4", "--n-eval-episodes", "0", "--out", str(out)]
            train.main([*words, "--symmetric", "--total-timesteps", "256"])
            training = train.Training(train.arguments([*words, "--symmetric", "--resume"]))
            indices, signs = training.task.observation_mirror
            action_indices, action_signs = training.task.action_mirror
            training.task.close()
            seen = np.random.default_rng(1).normal(size=(100, len(indices)))
            limit = training.task.action_space.high[0]
            wanted, _ = training.model.predict(training.normalised.normalize_obs(np.column_stack([seen, np.zeros(100)])), deterministic=True)

            played = evaluate.PlayedPolicy(out.read_text(encoding="utf-8"))

            np.testing.assert_allclose(limit * played.act(seen), wanted, atol=2e-3)
            np.testing.assert_allclose(played.act(signs * seen[:, indices]), action_signs * played.act(seen)[:, action_indices], atol=1e-5)
            self.assertGreater(np.abs(played.act(seen)).max(), 1e-3)

    @unittest.skipUnless(stable_baselines3, "stable-baselines3 is not installed")
    def test_policy_file_computes_what_the_network_computes_whatever_its_activations(self):
        from stable_baselines3 import PPO
        from stable_baselines3.common.vec_env import VecNormalize
        from torch import nn

        from robonewbie.sb3 import VecEnv

        random = np.random.default_rng(1)
        robots = VecNormalize(VecEnv("Walk", 1), clip_obs=2)
        size = robots.observation_space.shape[0]
        robots.obs_rms.mean, robots.obs_rms.var = random.normal(size=size), random.uniform(0.5, 9, size)
        raw = random.normal(scale=4, size=(1000, size))
        for activation in (nn.Tanh, nn.ReLU, nn.ELU, nn.SiLU, nn.Identity):
            for squash in (False, True):
                settings = {"activation_fn": activation, "net_arch": [32, 16], "squash_output": squash}
                model = PPO("MlpPolicy", robots, use_sde=squash, policy_kwargs=settings, seed=1, device="cpu")
                model.policy.action_net.weight.data *= 30
                wanted, _ = model.predict(robots.normalize_obs(raw), deterministic=True)

                text = train.policy_text("Walk", [], [], [], 30, train.layers_of(model, robots, np.arange(size)))

                found = robots.action_space.high[0] * evaluate.PlayedPolicy(text).act(raw)
                np.testing.assert_allclose(found, wanted, atol=2e-3, err_msg=f"{activation} {squash}")
        plain = PPO("MlpPolicy", robots.venv, seed=1, device="cpu")
        plain.policy.action_net.weight.data *= 30
        found = robots.action_space.high[0] * evaluate.PlayedPolicy(train.policy_text("Walk", [], [], [], 30, train.layers_of(plain))).act(raw)
        np.testing.assert_allclose(found, plain.predict(raw, deterministic=True)[0], atol=2e-3)
        for activation, named in ((nn.LeakyReLU, "LeakyReLU"), (lambda: nn.ELU(alpha=2.0), "ELU")):
            model = PPO("MlpPolicy", robots, policy_kwargs={"activation_fn": activation, "net_arch": [4]}, device="cpu")
            with self.assertRaisesRegex(ValueError, f"A policy file cannot express {named}"):
                train.layers_of(model, robots, np.arange(size))
        robots.close()

    @unittest.skipUnless(torch, "torch is not installed")
    def test_torch_modules_become_layers_that_act_alike_step_by_step(self):
        from torch import nn

        torch.manual_seed(1)
        for recurrent in (nn.GRU(16, 8, batch_first=True), nn.GRUCell(16, 8), nn.GRU(16, 8, bias=False)):
            before = nn.Sequential(nn.LayerNorm(5), nn.Linear(5, 16), nn.LayerNorm(16, eps=1e-3, bias=False), nn.ELU())
            after = nn.Sequential(nn.SiLU(), nn.Linear(8, 3, bias=False), nn.Hardtanh())
            text = train.policy_text("Stand", [], [], [], 30, train.torch_layers([*before, recurrent, *after]))
            policy, state = evaluate.PlayedPolicy(text), torch.zeros(100, 8)
            for observation in torch.randn(10, 100, 5):
                with torch.no_grad():
                    hidden = before(observation)
                    state = recurrent(hidden, state) if isinstance(recurrent, nn.GRUCell) else nn.GRUCell.forward(_cell(recurrent), hidden, state)
                    wanted = after(state)
                np.testing.assert_allclose(policy.act(observation.numpy()), wanted.numpy(), rtol=1e-4, atol=1e-6)
        for module in (nn.LSTM(3, 4), nn.GRU(3, 4, num_layers=2), nn.LayerNorm((2, 3)), nn.Hardtanh(-2, 2)):
            with self.assertRaisesRegex(ValueError, f"A policy file cannot express {type(module).__name__}"):
                train.torch_layers([nn.Linear(3, 3), module])

    @unittest.skipUnless(torch, "torch is not installed")
    def test_policy_of_plain_torch_plays_in_java(self):
        examples = Path(__file__).parents[1] / "examples"
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, str(examples / "imitate.py")], cwd=folder, check=True)
            words = [*simulator._command(), "run", str(examples / "Imitator.java"), "--headless", "--fast", "--seconds", "3"]
            told = subprocess.run(words, cwd=folder, check=True, capture_output=True, text=True).stdout

        angles = [[float(word) for word in line.split()[1:]] for line in told.splitlines() if line.startswith("Head")]
        self.assertGreater(len(angles), 50)
        for wanted, found in angles:
            self.assertAlmostEqual(found, wanted, delta=2)
        self.assertGreater(max(found for _, found in angles), 20)

    @unittest.skipUnless(stable_baselines3, "stable-baselines3 is not installed")
    def test_critic_sees_how_much_of_the_episode_is_over(self):
        from robonewbie.critic import Timed
        from robonewbie.sb3 import VecEnv

        robots = Timed(VecEnv("Stand", 2, cycles=200, push=0), longest=3)
        times, nothing = [robots.reset()[:, -1]], np.zeros((2, 12), dtype=np.float32)
        for _ in range(3):
            observation, _, done, infos = robots.step(nothing)
            times.append(observation[:, -1])
        robots.close()

        np.testing.assert_allclose(times, [[0, 0], [1 / 3, 1 / 3], [2 / 3, 2 / 3], [0, 0]], atol=1e-6)
        self.assertTrue(done.all())
        self.assertAlmostEqual(infos[0]["terminal_observation"][-1], 1, places=6)

    @unittest.skipUnless(stable_baselines3, "stable-baselines3 is not installed")
    def test_goes_on_in_the_same_way_from_the_same_round(self):
        texts = []
        with tempfile.TemporaryDirectory() as folder:
            words = ["Reach", "--n-envs", "2", "--n-steps", "32", "--batch-size", "8", "--net-arch", "4", "4", "--n-eval-episodes", "0", "--out"]
            train.main([*words, str(Path(folder, "first.policy")), "--total-timesteps", "64"])
            for name in ("one", "two"):
                for file in filter(Path.is_file, Path(folder).glob("first.*")):
                    shutil.copy(file, file.with_name(file.name.replace("first", name)))
                out = Path(folder, f"{name}.policy")
                train.main([*words, str(out), "--total-timesteps", "128", "--resume"])
                texts.append(out.read_text(encoding="utf-8"))

        self.assertEqual(*texts)


if __name__ == "__main__":
    unittest.main()

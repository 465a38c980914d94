"""Learns a task by PPO of Stable-Baselines3, and writes what was learned as a policy that agents in Java play.

    python -m robonewbie.train Stand --steps 300000
    python -m robonewbie.train Stand --steps 600000 --resume

After each round it keeps all that is needed to go on, so that a training can be stopped at any moment. The observations'
normalisation is folded into the first layer of the policy.
"""

import argparse
import csv
import os
import sys
from pathlib import Path

import numpy as np



def fold(weights, bias, mean, variance, epsilon):
    """Gives the layer that does with raw numbers what one does with normalised ones."""
    deviation = np.sqrt(variance + epsilon)
    return weights / deviation, bias - weights @ (mean / deviation)


def policy_text(task, about, inputs, outputs, range_degrees, layers, motion=()):
    """Writes a policy as org.robonewbie.agent.policy.PolicyText reads it; layers are weights, bias and "tanh" or "cut"."""
    lines = [f"policy 1 {task}", *(f"# {line}" for line in about), f"numbers range-degrees {range_degrees:g}"]
    if motion:
        lines.append("numbers motion " + " ".join(f"{number:g}" for number in motion))
    lines += [f"input {name} {unit}" for name, unit in inputs]
    lines += [f"output joint.{name} {range_degrees:g} degrees" for name in outputs]
    for weights, bias, bend in layers:
        lines.append(f"layer {weights.shape[1]} {weights.shape[0]} {bend}")
        lines += [" ".join(f"{number:.6g}" for number in [b, *row]) for b, row in zip(bias, weights)]
    return "\n".join(lines) + "\n"


def _numbers(layer):
    return layer.weight.detach().cpu().numpy().astype(float), layer.bias.detach().cpu().numpy().astype(float)


def layers_of(model, normalisation):
    """Takes the layers of a PPO model, with the normalisation folded into the first one."""
    first, _, second, _ = model.policy.mlp_extractor.policy_net
    seen = normalisation.obs_rms
    folded = fold(*_numbers(first), seen.mean, seen.var, normalisation.epsilon)
    return [(*folded, "tanh"), (*_numbers(second), "tanh"), (*_numbers(model.policy.action_net), "cut")]


def _arguments(words):
    parser = argparse.ArgumentParser(prog="python -m robonewbie.train", description="Learns a task by PPO.")
    parser.add_argument("task", help="Stand, Follow, Run, KickTo, QuickGetUp, another task, or the name of a Java class of yours")
    parser.add_argument("--steps", type=int, default=300_000, help="cycles of all robots together (300000)")
    parser.add_argument("--robots", type=int, default=16, help="robots that learn side by side (16)")
    parser.add_argument("--round", type=int, default=128, help="steps of each robot between two updates (128)")
    parser.add_argument("--rate", type=float, default=3e-4, help="how fast it learns (0.0003)")
    parser.add_argument("--gamma", type=float, default=0.99, help="what a reward is worth one step later (0.99)")
    parser.add_argument("--noise", type=float, default=0.3, help="standard deviation of the first actions (0.3)")
    parser.add_argument("--hold", type=int, default=0, help="steps for which a robot errs in the same way, by gSDE; 0: each step in another (0)")
    parser.add_argument("--hidden", type=int, default=64, help="neurons in each of the two hidden layers (64)")
    parser.add_argument("--seed", type=int, default=1, help="chooses weights and episodes (1)")
    parser.add_argument("--out", type=Path, help="file of the policy (TASK.policy)")
    parser.add_argument("--resume", action="store_true", help="go on with a training that was stopped")
    return parser.parse_args(words)


class Training:
    """A task, a model, and the files beside the policy: .zip and .normalisation to go on with, .csv with the curve."""

    def __init__(self, wanted):
        from stable_baselines3 import PPO
        from stable_baselines3.common.vec_env import VecMonitor, VecNormalize

        from robonewbie.sb3 import VecEnv

        self.wanted = wanted
        self.out = wanted.out
        self.task = VecEnv(wanted.task, wanted.robots)
        robots = VecMonitor(self.task)
        if wanted.resume:
            self.normalised = VecNormalize.load(str(self._beside(".normalisation")), robots)
            self.model = PPO.load(self._beside(".zip"), self.normalised, device="cpu")
        else:
            robots.seed(wanted.seed)
            self.normalised = VecNormalize(robots, gamma=wanted.gamma)
            self.model = PPO(
                "MlpPolicy",
                self.normalised,
                n_steps=wanted.round,
                batch_size=wanted.robots * wanted.round // 8,
                learning_rate=wanted.rate,
                gamma=wanted.gamma,
                seed=wanted.seed,
                device="cpu",
                use_sde=wanted.hold > 0,
                sde_sample_freq=wanted.hold or -1,
                policy_kwargs={"net_arch": [wanted.hidden, wanted.hidden], "log_std_init": float(np.log(_first_deviation(wanted)))},
            )

    def _beside(self, ending):
        return self.out.with_name(self.out.name + ending)

    def _replace(self, ending, write):
        part = self._beside(ending + ".part")
        with open(part, "wb") as file:
            write(file)
        os.replace(part, self._beside(ending))

    def keep(self):
        """Writes policy, curve and all that is needed to go on."""
        self._replace(".normalisation", lambda file: file.write(_pickled(self.normalised)))
        self._replace(".zip", self.model.save)
        self._replace("", lambda file: file.write(self.text().encode("utf-8")))
        self._add_to_curve()

    def text(self):
        """Gives the policy as a text."""
        wanted, described = self.wanted, self.task.description
        return policy_text(
            wanted.task,
            [f"learned by: python -m robonewbie.train {wanted.task} --steps {self.model.num_timesteps} --robots {wanted.robots} "
             f"--round {wanted.round} --rate {wanted.rate:g} --gamma {wanted.gamma:g} --noise {wanted.noise:g} --hold {wanted.hold} "
             f"--hidden {wanted.hidden} --seed {wanted.seed}"],
            [(entry["name"], entry["unit"]) for entry in described["observation"]],
            described["action"],
            described["rangeDegrees"],
            layers_of(self.model, self.normalised),
            described["motion"],
        )

    def _add_to_curve(self):
        episodes = list(self.model.ep_info_buffer)
        if not episodes:
            return
        curve = self._beside(".csv")
        new = not curve.exists()
        with open(curve, "a", newline="", encoding="utf-8") as file:
            lines = csv.writer(file, lineterminator="\n")
            if new:
                lines.writerow(["steps", "reward", "cycles"])
            rewards, lengths = [e["r"] for e in episodes], [e["l"] for e in episodes]
            lines.writerow([self.model.num_timesteps, f"{np.mean(rewards):.4f}", f"{np.mean(lengths):.1f}"])
            print(f"{self.model.num_timesteps:9d}: reward {np.mean(rewards):8.3f} in {np.mean(lengths):.0f} cycles")

    def run(self):
        """Learns, round by round."""
        while self.model.num_timesteps < self.wanted.steps:
            self.model.learn(self.wanted.robots * self.wanted.round, reset_num_timesteps=False)
            self.keep()


def _first_deviation(wanted):
    """With gSDE each of the last layer's inputs adds its own error."""
    return wanted.noise / np.sqrt(wanted.hidden) if wanted.hold else wanted.noise


def _pickled(normalised):
    import pickle

    return pickle.dumps(normalised)


def main(words=None):
    """Learns what the command line says."""
    wanted = _arguments(words)
    wanted.out = wanted.out or Path(f"{wanted.task}.policy")
    model = wanted.out.with_name(wanted.out.name + ".zip")
    if model.exists() and not wanted.resume:
        sys.exit(f"There is a training in {model} already. Go on with --resume, or choose another --out.")
    if wanted.resume and not model.exists():
        sys.exit(f"There is nothing to resume: {model} does not exist. Leave out --resume.")
    training = Training(wanted)
    training.run()
    training.task.close()
    print(f"Written to {training.out}.")


if __name__ == "__main__":
    main()

"""Trains a policy for a task by Stable-Baselines3's PPO, and writes it for use by Java agents.

    python -m robonewbie.train KickTo
    python -m robonewbie.train KickTo --total-timesteps 600000 --resume
    python -m robonewbie.train Stand --net-arch --inputs "gyro.*|accelerometer.*" --option cycles=2

Arguments that are omitted have the best known values for the task, which robonewbie/settings.py lists. At the end, the policy is
evaluated in new episodes beside zero actions. The last layer of the initial policy is zero, so all actions are zero. A checkpoint is
written after each update, so a training run can be interrupted at any time. The first layer of the policy normalises the observations.

If TensorBoard is installed, returns and losses are logged to the folder TASK.policy.tensorboard:

    tensorboard --logdir .
"""

import argparse
import csv
import dataclasses
import math
import os
import pickle
import re
import sys
import time
from pathlib import Path

import numpy as np

from robonewbie import network, settings
from robonewbie.mirror import mirror_of, symmetric_layers
from robonewbie.network import Dense, Gru, LayerNorm

# Stable-Baselines3 seeds environment i with the seed plus i, so neighbouring seeds would share most of their episodes.
SEEDS_APART = 10_000_000

# The activations of policy files by the names of torch's modules.
_ACTIVATIONS = {"Tanh": "tanh", "ReLU": "relu", "ELU": "elu", "SiLU": "silu", "Identity": "linear", "Hardtanh": "cut"}
_MODULES = "Linear, LayerNorm, GRU (one layer, one direction), GRUCell"


def fold(weights, bias, mean, variance, epsilon):
    """Folds the normalisation of inputs into a layer."""
    deviation = np.sqrt(variance + epsilon)
    return weights / deviation, bias - weights @ (mean / deviation)


def policy_text(task, about, inputs, outputs, range_degrees, layers, motion=(), cycles=1, walk=None, packed=False):
    """Formats a policy for org.robonewbie.agent.policy.PolicyText. Layers come from :func:`torch_layers`; a tuple of weights, biases and
    activation, such as "tanh", is a fully connected layer. Packed weights take a fifth of the space, and are rounded.

    ``inputs`` are pairs of name and unit, and so are ``outputs``; the name of a joint alone is an output for its angle, with the range
    ``range_degrees``. If ``walk`` contains the parameters of a walk, by name, the policy corrects the output of the walk engine.
    """
    lines = [f"policy 1 {task}", *(f"# {line}" for line in about)]
    if motion:
        lines.append("numbers motion " + " ".join(f"{number:g}" for number in motion))
    lines += [f"numbers {name} " + " ".join(f"{number:g}" for number in numbers) for name, numbers in (walk or {}).items()]
    if cycles > 1:
        lines.append(f"numbers cycles-per-action {cycles}")
    lines += [f"input {name} {unit}" for name, unit in inputs]
    angles = {name: (f"{'' if walk else 'joint.'}{name}", f"{range_degrees:g} degrees") for name in outputs if isinstance(name, str)}
    lines += ["output {} {}".format(*angles.get(output, output)) for output in outputs]
    return "\n".join([*lines, *network.lines(layers, packed)]) + "\n"


def layers_of(model, normalisation=None, inputs=()):
    """Returns the layers of the actor of a PPO model for :func:`policy_text`.

    With a ``VecNormalize``, the first layer normalises the inputs (indices) and clips them as it does.

    :raises ValueError: if the network has a module that a policy file cannot express; it is named
    """
    *hidden, last = actor_layers(model.policy)
    if model.policy.squash_output:
        last = Dense(last.weights, last.bias, "tanh")
    else:
        limit = model.action_space.high[0]
        last = Dense(last.weights / limit, last.bias / limit, "cut")
    if normalisation is None:
        return [*hidden, last]
    moments, limit = normalisation.obs_rms, normalisation.clip_obs
    size = len(inputs)
    scale, offset = fold(np.identity(size) / limit, np.zeros(size), moments.mean[inputs], moments.var[inputs], normalisation.epsilon)
    first, *others = [*hidden, last]
    if isinstance(first, Dense):
        scaled = [Dense(first.weights * limit, first.bias, first.activation)]
    else:
        scaled = [Dense(np.identity(size) * limit, np.zeros(size)), first]
    return [Dense(scale, offset, "cut"), *scaled, *others]


def actor_layers(policy):
    """Returns the layers of the actor of a PPO policy without the limits of observations and actions."""
    hidden = torch_layers(policy.mlp_extractor.policy_net)
    mirrors = getattr(policy, "mirrors", None)
    if mirrors is None:
        return [*hidden, *torch_layers([policy.action_net])]
    return symmetric_layers([*hidden, *torch_layers([policy.action_net.linear])], *mirrors)


def torch_layers(modules):
    """Returns the layers of torch modules for :func:`policy_text`: of an ``nn.Sequential``, or of a list in the order of evaluation.

    Java resets what a GRU remembers at the start of an episode.

    :raises ValueError: if a policy file cannot express a module; it is named
    """
    layers, free = [], False  # whether the last layer has no activation yet
    for module in modules:
        kind = type(module).__name__
        if kind in _ACTIVATIONS and free and getattr(module, "alpha", 1) == 1 and (kind != "Hardtanh" or (module.min_val, module.max_val) == (-1, 1)):
            layers[-1] = dataclasses.replace(layers[-1], activation=_ACTIVATIONS[kind])
            free = False
        else:
            layers.append(_layer_of(module, kind))
            free = True
    return layers


def _layer_of(module, kind):
    def numbers(name, size):
        parameter = getattr(module, name, None)
        return np.zeros(size) if parameter is None or parameter is False else parameter.detach().cpu().numpy().astype(float)

    if kind == "Linear":
        return Dense(numbers("weight", 0), numbers("bias", module.out_features))
    if kind == "LayerNorm" and len(module.normalized_shape) == 1:
        size = module.normalized_shape[0]
        return LayerNorm(numbers("weight", size) if module.elementwise_affine else np.ones(size), numbers("bias", size), module.eps)
    if kind == "GRUCell" or (kind == "GRU" and module.num_layers == 1 and not module.bidirectional):
        end, size = ("" if kind == "GRUCell" else "_l0"), 3 * module.hidden_size
        return Gru(numbers("weight_ih" + end, 0), numbers("weight_hh" + end, 0), numbers("bias_ih" + end, size), numbers("bias_hh" + end, size))
    known = ", ".join(_ACTIVATIONS)
    raise ValueError(f"A policy file cannot express {module}. Use {_MODULES}, each followed by at most one of {known}.")


def options_of(words):
    """Parses options of a task: NAME=VALUE or NAME=LOW..HIGH."""
    options = {}
    for word in words:
        name, equals, value = word.partition("=")
        try:
            numbers = tuple(float(number) for number in value.split(".."))
        except ValueError:
            numbers = ()
        if not equals or len(numbers) not in (1, 2):
            sys.exit(f'The option "{word}" is neither NAME=VALUE nor NAME=LOW..HIGH, such as cycles=2 or friction=0.7..1.3.')
        options[name] = numbers[0] if len(numbers) == 1 else numbers
    return options


def argument_parser(program="train", tasks=settings.TASKS, episodes=128):
    """Returns the parser for a program that trains some tasks, and evaluates the policy in a number of episodes at the end."""
    parser = argparse.ArgumentParser(
        prog=f"python -m robonewbie.{program}",
        description="Trains a policy for a task by PPO. Parameters are named as in Stable-Baselines3. "
        f"For {', '.join(tasks)}, the defaults are the best known values instead of those below. "
        "If TensorBoard is installed, returns and losses are logged: tensorboard --logdir .",
    )
    parser.set_defaults(program=program)
    parser.add_argument("task", help=f"{', '.join(tasks)}, another task, or the name of a custom Java class")
    parser.add_argument("--total-timesteps", type=int, default=300_000, help="total number of actions of all robots (default: 300000)")
    parser.add_argument("--n-envs", type=int, default=64, help="number of parallel robots or matches (default: 64)")
    parser.add_argument("--n-steps", type=int, default=64, help="actions of each robot per update (default: 64)")
    parser.add_argument("--batch-size", type=int, default=512, help="minibatch size (default: 512)")
    parser.add_argument("--n-epochs", type=int, default=10, help="epochs per update (default: 10)")
    parser.add_argument("--learning-rate", type=float, default=3e-4, help="initial learning rate, which decreases linearly to 0 (default: 0.0003)")
    parser.add_argument("--gamma", type=float, default=0.99, help="discount factor (default: 0.99)")
    parser.add_argument("--gae-lambda", type=float, default=0.95, help="factor of generalised advantage estimation (default: 0.95)")
    parser.add_argument("--log-std-init", type=float, default=math.log(0.1), help="initial log standard deviation of the actions or, with gSDE, of each weight's noise (default: -2.3)")
    parser.add_argument("--sde-sample-freq", type=int, default=-1, help="use gSDE and sample new noise every N actions (default: no gSDE)")
    parser.add_argument("--net-arch", type=int, nargs="*", default=[64, 64], metavar="N", help="size of each hidden layer; empty for none (default: 64 64)")
    parser.add_argument("--inputs", default=".*", metavar="REGEX", help="pattern for the names of the policy's inputs (default: all observed quantities)")
    parser.add_argument("--critic", default=".*", metavar="REGEX", help="pattern for the names of the critic's inputs, in addition to the time (default: all observed quantities)")
    parser.add_argument("--symmetric", action="store_true", help="a policy that treats left and right alike, for tasks that are symmetric")
    parser.add_argument("--option", action="append", default=[], metavar="NAME=VALUE", help="option of the task, such as cycles=2 or friction=0.7..1.3")
    parser.add_argument("--seed", type=int, default=1, help="seed of weights and episodes (default: 1)")
    parser.add_argument("--out", type=Path, help="file of the policy (default: TASK.policy)")
    parser.add_argument("--resume", action="store_true", help="resume an interrupted training run")
    parser.add_argument("--n-eval-episodes", type=int, default=episodes, help=f"episodes of the evaluation at the end; 0 for none (default: {episodes})")
    return parser


def arguments(words, parser=None, tasks=settings.TASKS):
    """Parses a command line. The best known settings of the task are the defaults."""
    parser = parser or argument_parser()
    task = parser.parse_args(words).task
    known = tasks[task].words if task in tasks else []
    wanted = parser.parse_args(words, parser.parse_args([task, *known]))
    wanted.options = options_of(wanted.option)
    if wanted.symmetric and wanted.sde_sample_freq > 0:
        parser.error("--symmetric has no gSDE. Omit it, or --sde-sample-freq.")
    return wanted


class Training:
    """Training run of a task. The checkpoint (.zip and .normalisation) and the learning curve (.csv) are written beside the policy."""

    def __init__(self, wanted):
        from stable_baselines3 import PPO
        from stable_baselines3.common.vec_env import VecMonitor, VecNormalize

        from robonewbie.critic import Timed, TwoViewsPolicy
        from robonewbie.symmetry import SymmetricMoments, SymmetricPolicy

        self.wanted = wanted
        self.out = wanted.out
        self.began = time.monotonic()
        self.task = self._robots()
        self.inputs = indices_of(self.task.description, wanted.inputs)
        longest = math.ceil(self.task.description["longestCycles"] / self.task.cycles)
        robots = VecMonitor(Timed(self.task, longest))
        if wanted.resume:
            self.normalised = VecNormalize.load(str(self._beside(".normalisation")), robots)
            self.model = PPO.load(self._beside(".zip"), self.normalised, device="cpu")
            # The seed alone would repeat the first episodes.
            self.model.set_random_seed(SEEDS_APART * wanted.seed + self.model.num_timesteps)
        else:
            self.normalised = VecNormalize(robots, gamma=wanted.gamma)
            if wanted.symmetric:
                indices, signs = self.task.observation_mirror
                self.normalised.obs_rms = SymmetricMoments(np.append(indices, len(indices)), np.append(signs, 1))
            self.model = PPO(SymmetricPolicy if wanted.symmetric else TwoViewsPolicy, self.normalised, **self._settings())
            self._initialise_actor()
        self.first_timestep = self.model.num_timesteps
        self.zero_actions = None  # their mean return, if known

    def _robots(self):
        from robonewbie.sb3 import VecEnv

        return VecEnv(self.wanted.task, self.wanted.n_envs, **self.wanted.options)

    def _initialise_actor(self):
        """Sets the last layer to zero and the hidden biases to random values, because gSDE does not explore if all inputs are zero."""
        policy = self.model.policy
        for numbers in policy.action_net.parameters():
            numbers.data.zero_()
        for name, numbers in policy.mlp_extractor.policy_net.named_parameters():
            if name.endswith("bias"):
                numbers.data.uniform_(-1, 1)

    def _mirrors(self):
        names = [self.task.observation_names[i] for i in self.inputs]
        return {"mirrors": (mirror_of(names), self.task.action_mirror)} if self.wanted.symmetric else {}

    def _settings(self):
        wanted = self.wanted
        names = ("n_steps", "batch_size", "n_epochs", "learning_rate", "gamma", "gae_lambda", "sde_sample_freq")
        return {
            **{name: getattr(wanted, name) for name in names},
            "seed": SEEDS_APART * wanted.seed,
            "device": "cpu",
            "use_sde": wanted.sde_sample_freq > 0,
            "policy_kwargs": {
                "actor": self.inputs,
                "critic": [*indices_of(self.task.description, wanted.critic), len(self.task.description["observation"])],
                "net_arch": {"pi": wanted.net_arch, "vf": wanted.net_arch or [64, 64]},
                "log_std_init": wanted.log_std_init,
                **self._mirrors(),
            },
        }

    @property
    def all_cycles(self):
        """The total number of cycles so far."""
        return self.model.num_timesteps * self.task.cycles

    def _beside(self, ending):
        return self.out.with_name(self.out.name + ending)

    def _replace(self, ending, write):
        part = self._beside(ending + ".part")
        with open(part, "wb") as file:
            write(file)
        os.replace(part, self._beside(ending))

    def save(self):
        """Writes the policy, the learning curve and the checkpoint."""
        self._replace(".normalisation", lambda file: pickle.dump(self.normalised, file))
        self._replace(".zip", self.model.save)
        self._replace("", lambda file: file.write(self.text().encode("utf-8")))
        self._add_to_curve()

    def text(self):
        """Returns the policy in its file format."""
        wanted, described = self.wanted, self.task.description
        return policy_text(
            wanted.task,
            [f"learned by: {command_of(wanted, self.model.num_timesteps)}"],
            [(described["observation"][i]["name"], described["observation"][i]["unit"]) for i in self.inputs],
            [(output["name"], output["unit"]) for output in described["output"]],
            described["rangeDegrees"],
            layers_of(self.model, self.normalised, self.inputs),
            described["motion"],
            self.task.cycles,
            described["walk"],
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
                lines.writerow(["steps", "reward", "cycles", "seconds"])
            reward = np.mean([episode["r"] for episode in episodes])
            cycles = np.mean([episode["l"] for episode in episodes]) * self.task.cycles
            lines.writerow([self.all_cycles, f"{reward:.4f}", f"{cycles:.1f}", f"{time.monotonic() - self.began:.0f}"])
            beside = "" if self.zero_actions is None else f" (zero actions {self.zero_actions:.3f})"
            print(f"{self.all_cycles:9d}: return {reward:8.3f}{beside} in {cycles:.0f} cycles, {self._minutes_left():.0f} min left", flush=True)

    def _minutes_left(self):
        done = self.model.num_timesteps - self.first_timestep
        return (time.monotonic() - self.began) / 60 * (self.wanted.total_timesteps - self.model.num_timesteps) / max(1, done)

    def _compare_with_zero_actions(self):
        """Evaluates zero actions, so that progress can be judged."""
        from robonewbie import evaluate

        wanted = self.wanted
        if wanted.n_eval_episodes > 0:
            self.zero_actions = np.mean(evaluate.evaluate(wanted.task, None, wanted.n_eval_episodes, options=wanted.options).returns)

    def _log_to_tensorboard(self):
        """Logs to TensorBoard if it is installed; zero actions are a run of their own, so that both curves are in one chart."""
        from stable_baselines3.common.logger import SummaryWriter, configure

        if SummaryWriter is None:
            return
        folder = self._beside(".tensorboard")
        self.model.set_logger(configure(str(folder), ["tensorboard"]))
        if self.zero_actions is not None:
            zero = configure(str(folder / "zero_actions"), ["tensorboard"])
            for timesteps in (self.first_timestep, self.wanted.total_timesteps):
                zero.record("rollout/ep_rew_mean", self.zero_actions)
                zero.dump(timesteps)
            zero.close()

    def run(self):
        """Trains until the total number of actions is reached."""
        wanted = self.wanted
        self._compare_with_zero_actions()
        self._log_to_tensorboard()
        while self.model.num_timesteps < wanted.total_timesteps:
            rate = wanted.learning_rate * (1 - self.model.num_timesteps / wanted.total_timesteps)
            self.model.lr_schedule = lambda _, rate=rate: rate
            self.model.learn(self.task.num_envs * wanted.n_steps, reset_num_timesteps=False)
            self.model.logger.dump(self.model.num_timesteps)  # the losses of this update
            self.save()


def command_of(wanted, total_timesteps):
    """Returns the command line with all arguments that determine a training run."""
    return (
        f"python -m robonewbie.{wanted.program} {wanted.task} --total-timesteps {total_timesteps} --n-envs {wanted.n_envs} "
        f"--n-steps {wanted.n_steps} --batch-size {wanted.batch_size} --n-epochs {wanted.n_epochs} --learning-rate {wanted.learning_rate:g} "
        f"--gamma {wanted.gamma:g} --gae-lambda {wanted.gae_lambda:g} --log-std-init {wanted.log_std_init:g} "
        f"--sde-sample-freq {wanted.sde_sample_freq} --net-arch {''.join(f'{neurons} ' for neurons in wanted.net_arch)}"
        f"--inputs '{wanted.inputs}' --critic '{wanted.critic}' {'--symmetric ' if wanted.symmetric else ''}{''.join(f'--option {word} ' for word in wanted.option)}--seed {wanted.seed}"
    )


def indices_of(description, inputs):
    """Returns the indices of the observed quantities whose names match a regular expression."""
    names = [entry["name"] for entry in description["observation"]]
    indices = [i for i, name in enumerate(names) if re.fullmatch(inputs, name)]
    if not indices:
        sys.exit(f"No observed quantity of {description['task']} has a name that matches {inputs}. Available: {', '.join(names)}.")
    return indices


def main(words=None):
    """Runs the command line."""
    training = trained(Training, arguments(words))
    if training.wanted.n_eval_episodes > 0:
        from robonewbie import evaluate

        evaluate.compare(training.wanted.task, training.out, training.wanted.n_eval_episodes, options=training.wanted.options)


def trained(kind, wanted):
    """Runs or resumes a training run of a kind, and returns it."""
    wanted.out = wanted.out or Path(f"{wanted.task}.policy")
    model = wanted.out.with_name(wanted.out.name + ".zip")
    if model.exists() and not wanted.resume:
        sys.exit(f"A training run already exists in {model}. Resume it with --resume, or choose another file with --out.")
    if wanted.resume and not model.exists():
        sys.exit(f"There is nothing to resume: {model} does not exist. Omit --resume to start a new training run.")
    print(command_of(wanted, wanted.total_timesteps), flush=True)
    training = kind(wanted)
    training.run()
    training.task.close()
    print(f"The policy was written to {training.out}.")
    return training


if __name__ == "__main__":
    main()

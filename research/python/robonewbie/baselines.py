"""Makes the board of baselines in docs/policies.md: trains tasks by Stable-Baselines3's PPO, three seeds each, and evaluates the policies.

    python -m robonewbie.baselines                                    all tasks, into the folder baselines
    python -m robonewbie.baselines Stand KickTo --policy My.policy    these tasks, and a policy of your own beside them

Interrupted training runs are resumed; complete ones are not repeated. The policies of a task and zero actions play the same 128 episodes,
whose seeds no training run uses. The best policy comes first.
"""

import argparse
import csv
from pathlib import Path

import numpy as np

from robonewbie import curve, evaluate, train
from robonewbie.settings import TASKS

SEEDS = (1, 2, 3)
EPISODES = 128
COLUMNS = ("task", "policy", "return", "success", "cycles", "hours", "command")


def train_seed(task, seed, folder):
    """Starts or resumes the training run with one seed, and returns the file of its policy."""
    out = folder / f"{task}-{seed}.policy"
    file = _curve_of(out)
    if not file.exists() or curve.read(file)[0][-1] < _cycles(task) / 1e6:
        resume = ["--resume"] if out.with_name(out.name + ".zip").exists() else []
        train.main([task, "--seed", str(seed), "--n-eval-episodes", "0", "--out", str(out), *resume])
    return out


def _cycles(task):
    """Returns the total number of cycles of a training run."""
    return int(TASKS[task].total_timesteps * train.options_of(TASKS[task].options).get("cycles", 1))


def _curve_of(policy):
    return policy.with_name(policy.name + ".csv")


def _hours(file):
    """Returns the duration of a training run; the seconds in its curve restart whenever it is resumed."""
    with open(file, newline="", encoding="utf-8") as lines:
        seconds = [float(row["seconds"]) for row in csv.DictReader(lines)]
    return sum(now for now, after in zip(seconds, [*seconds[1:], 0]) if after < now) / 3600


def _training_of(file, task, seed):
    """Returns the cells of a policy's training."""
    file = _curve_of(file)
    return [f"{1e6 * curve.read(file)[0][-1]:,.0f}", f"{_hours(file):.2f}", f"`train {task} --seed {seed}`"]


def rows(task, policies):
    """Evaluates zero actions and the policies of one task, and returns their rows, the highest return first.

    ``policies`` are pairs of a file and the cells of its training.
    """
    options = train.options_of(TASKS[task].options) if task in TASKS else {}
    entries = [(evaluate.evaluate(task, None, EPISODES, options=options), "zero actions", ["", "", ""])]
    options.pop("cycles", None)  # a policy says how long its actions last
    for file, training in policies:
        policy = evaluate.PlayedPolicy(file.read_text(encoding="utf-8"))
        entries.append((evaluate.evaluate(task, policy, EPISODES, options=options), f"`{file.name}`", training))
    entries.sort(key=lambda entry: -np.mean(entry[0].returns))
    return [
        f"| {' | '.join([f'`{task}`', name, *str(result).removeprefix('return ').split(', success '), *training])} |"
        for result, name, training in entries
    ]


def main(words=None):
    """Runs the command line."""
    parser = argparse.ArgumentParser(prog="python -m robonewbie.baselines", description="Makes the board of baselines in docs/policies.md.")
    parser.add_argument("tasks", nargs="*", metavar="TASK", help=f"any of {', '.join(TASKS)} (default: all)")
    parser.add_argument("--out", type=Path, default=Path("baselines"), help="folder of policies and curves (default: baselines)")
    parser.add_argument("--policy", type=Path, nargs="+", default=[], metavar="FILE", help="other policies that are evaluated too")
    wanted = parser.parse_args(words)
    unknown = set(wanted.tasks) - set(TASKS)
    if unknown:
        parser.error(f"There is no baseline for {', '.join(sorted(unknown))}. Available: {', '.join(TASKS)}.")
    wanted.out.mkdir(parents=True, exist_ok=True)
    policies = {}
    for task in wanted.tasks or TASKS:
        files = [train_seed(task, seed, wanted.out) for seed in SEEDS]
        picture = wanted.out / f"{task}.svg"
        picture.write_text(curve.svg([curve.together(task, [curve.read(_curve_of(file)) for file in files])]), encoding="utf-8")
        policies[task] = [(file, _training_of(file, task, seed)) for file, seed in zip(files, SEEDS)]
    for file in wanted.policy:
        task = evaluate.PlayedPolicy(file.read_text(encoding="utf-8")).task
        policies.setdefault(task, []).append((file, ["", "", ""]))
    print(f"| {' | '.join(COLUMNS)} |\n|{'---|' * len(COLUMNS)}")
    for task in policies:
        print("\n".join(rows(task, policies[task])), flush=True)


if __name__ == "__main__":
    main()

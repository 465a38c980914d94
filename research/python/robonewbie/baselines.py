"""Reproduces the baselines in docs/policies.md: trains each task by Stable-Baselines3's PPO with three seeds, and plots the learning curves.

    python -m robonewbie.baselines                  all tasks, into the folder baselines
    python -m robonewbie.baselines Stand KickTo     these tasks

Interrupted training runs are resumed; complete ones are not repeated. Prints a row for each task, part of which is shown in docs/policies.md:
returns during training, and returns of the policies and of a zero-action baseline in 256 evaluation episodes.
"""

import argparse
import csv
from pathlib import Path

import numpy as np

from robonewbie import curve, evaluate, train
from robonewbie.settings import TASKS

SEEDS = (1, 2, 3)
EVALUATED = 256


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


def _minutes(file):
    """Returns the duration of a training run in minutes; the seconds in its curve restart whenever it is resumed."""
    with open(file, newline="", encoding="utf-8") as lines:
        seconds = [float(row["seconds"]) for row in csv.DictReader(lines)]
    return sum(now for now, after in zip(seconds, [*seconds[1:], 0]) if after < now) / 60


def _range(numbers, digits=2):
    low, high = f"{min(numbers):.{digits}f}".replace("-", "−"), f"{max(numbers):.{digits}f}".replace("-", "−")
    return low if low == high else f"{low} to {high}"


def row(task, policies):
    """Evaluates the policies of one task, and returns its row of the table."""
    curves = [curve.read(_curve_of(policy)) for policy in policies]
    options = train.options_of(TASKS[task].options)
    learned = [evaluate.evaluate(task, evaluate.PlayedPolicy(policy.read_text(encoding="utf-8")), EVALUATED, options=options) for policy in policies]
    nothing = evaluate.evaluate(task, None, EVALUATED, options=options)
    cells = [
        f"`{task}`",
        f"{_cycles(task):,}",
        _range([_minutes(_curve_of(policy)) for policy in policies], 1),
        _range([rewards[0] for _, rewards in curves]),
        _range([np.mean(rewards[-max(1, len(rewards) // 10) :]) for _, rewards in curves]),
        _range([np.mean(result.returns) for result in learned]),
        _range([np.mean(nothing.returns)]),
        _range([100 * np.mean(result.successes) for result in learned], 0) + " %",
        _range([100 * np.mean(nothing.successes)], 0) + " %",
    ]
    return "| " + " | ".join(cells) + " |"


def main(words=None):
    """Runs the command line."""
    parser = argparse.ArgumentParser(prog="python -m robonewbie.baselines", description="Reproduces the baselines of docs/policies.md.")
    parser.add_argument("tasks", nargs="*", metavar="TASK", help=f"any of {', '.join(TASKS)} (default: all)")
    parser.add_argument("--out", type=Path, default=Path("baselines"), help="folder of policies and curves (default: baselines)")
    wanted = parser.parse_args(words)
    unknown = set(wanted.tasks) - set(TASKS)
    if unknown:
        parser.error(f"There is no baseline for {', '.join(sorted(unknown))}. Available: {', '.join(TASKS)}.")
    wanted.out.mkdir(parents=True, exist_ok=True)
    rows = []
    for task in wanted.tasks or TASKS:
        policies = [train_seed(task, seed, wanted.out) for seed in SEEDS]
        picture = wanted.out / f"{task}.svg"
        picture.write_text(curve.svg([curve.together(task, [curve.read(_curve_of(policy)) for policy in policies])]), encoding="utf-8")
        rows.append(row(task, policies))
        print(rows[-1], flush=True)
    print("\n".join(["", *rows]))


if __name__ == "__main__":
    main()

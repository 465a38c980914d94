"""Repeats the baselines of docs/policies.md: PPO of Stable-Baselines3, three seeds for each task, curves with their spread.

    python -m robonewbie.baselines                  all tasks, into the folder baselines
    python -m robonewbie.baselines Stand KickTo     these tasks

What was interrupted goes on where it was; what is complete is not repeated.
"""

import argparse
from pathlib import Path

from robonewbie import curve, train

SEEDS = (1, 2, 3)

# A step of 20 ms is short: a robot errs in the same way for 32 of them, and little, or it falls before it has learned anything.
COMMON = ["--hold", "32", "--hidden", "32", "--rate", "0.0001"]

# Cycles of all robots together, and what else robonewbie.train is told.
TASKS = {
    "Stand": (50_000, ["--noise", "0.02", "--gamma", "0.99"]),
    "Follow": (50_000, ["--noise", "0.05", "--gamma", "0.99"]),
    "Run": (50_000, ["--noise", "0.05", "--gamma", "0.99"]),
    "KickTo": (50_000, ["--noise", "0.03", "--gamma", "0.998"]),
    "GetUp": (50_000, ["--noise", "0.2", "--gamma", "0.998"]),
    "QuickGetUp": (50_000, ["--noise", "0.03", "--gamma", "0.998"]),
}


def train_seed(task, seed, folder):
    """Trains one seed, or what is missing of it, and gives the file of its curve."""
    steps, options = TASKS[task]
    out = folder / f"{task}-{seed}.policy"
    file = out.with_name(out.name + ".csv")
    if not file.exists() or curve.read(file)[0][-1] < steps / 1e6:
        resume = ["--resume"] if out.with_name(out.name + ".zip").exists() else []
        train.main([task, "--steps", str(steps), "--seed", str(seed), *COMMON, *options, "--out", str(out), *resume])
    return file


def main(words=None):
    """Trains what the command line names."""
    parser = argparse.ArgumentParser(prog="python -m robonewbie.baselines", description="Repeats the baselines of docs/policies.md.")
    parser.add_argument("tasks", nargs="*", metavar="TASK", help=f"one of {', '.join(TASKS)} (all)")
    parser.add_argument("--out", type=Path, default=Path("baselines"), help="folder of policies and curves (baselines)")
    wanted = parser.parse_args(words)
    unknown = set(wanted.tasks) - set(TASKS)
    if unknown:
        parser.error(f"There is no baseline for {', '.join(sorted(unknown))}. There are: {', '.join(TASKS)}.")
    wanted.out.mkdir(parents=True, exist_ok=True)
    for task in wanted.tasks or TASKS:
        curves = [curve.read(train_seed(task, seed, wanted.out)) for seed in SEEDS]
        picture = wanted.out / f"{task}.svg"
        picture.write_text(curve.svg([curve.together(task, curves)]), encoding="utf-8")
        last = [rewards[-1] for _, rewards in curves]
        print(f"{task}: reward {min(last):.3f} to {max(last):.3f} at the end; curve in {picture}")


if __name__ == "__main__":
    main()

"""Compares the search used by ``optimise`` with the package ``cma``: ``python research/python/benchmarks/beside_cma.py``.

Needs ``pip install ./research/python cma``. Prints how many trials each needs to reach a cost of 1e-9 (median over the seeds).
"""

import argparse
import statistics
import subprocess
from pathlib import Path

import cma
import numpy as np

from robonewbie import simulator

GOAL = 1e-9
MOST_TRIALS = 300_000
FIRST_CENTRE = {"sphere": 1, "ellipsoid": 1, "rosenbrock": 0, "rastrigin": 2.3}


def sphere(x):
    return float(np.sum(np.square(x)))


def ellipsoid(x):
    return float(np.sum(1e6 ** (np.arange(len(x)) / (len(x) - 1)) * np.square(x)))


def rosenbrock(x):
    x = np.asarray(x)
    return float(np.sum(100 * (x[:-1] ** 2 - x[1:]) ** 2 + (1 - x[:-1]) ** 2))


def rastrigin(x):
    x = np.asarray(x)
    return float(np.sum(x * x + 10 - 10 * np.cos(2 * np.pi * x)))


def theirs(name, count, seed):
    """Returns the number of trials that ``cma`` needs with its default settings, and with restarts for Rastrigin's function."""
    cost, hard = globals()[name], name == "rastrigin"
    trials, best = 0, np.inf

    def counted(x):
        nonlocal trials, best
        value = cost(x)
        if best > GOAL:
            trials, best = trials + 1, min(best, value)
        return value

    options = {"ftarget": GOAL, "maxfevals": MOST_TRIALS, "seed": seed, "verbose": -9}
    start = [FIRST_CENTRE[name]] * count
    cma.fmin(counted, start, 2 if hard else 0.5, options, restarts=9 if hard else 0, bipop=hard)
    return trials


def main(words=None):
    """Counts the trials and prints the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds", type=int, default=11, help="how often each function is minimised (11)")
    wanted = parser.parse_args(words)
    program = Path(__file__).with_name("SearchTrials.java")
    told = subprocess.run(
        [*simulator._command(), "run", str(program), str(wanted.seeds)], capture_output=True, text=True, check=True
    ).stdout
    ours = {}
    for name, count, trials in (line.split() for line in told.splitlines()):
        ours.setdefault((name, int(count)), []).append(int(trials))
    print("| function | numbers | optimise | cma | ratio |\n|---|---|---|---|---|")
    for (name, count), trials in ours.items():
        own = statistics.median(trials)
        other = statistics.median(theirs(name, count, seed) for seed in range(1, wanted.seeds + 1))
        print(f"| {name} | {count} | {own:.0f} | {other:.0f} | {own / other:.2f} |", flush=True)


if __name__ == "__main__":
    main()

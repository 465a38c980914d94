"""A robot learns to move its arm to any point by the cross-entropy method, in a few minutes on two cores.

``learn_to_reach.py 10`` stops after 10 generations instead of 30.
"""

import sys

import gymnasium
import numpy as np

import robonewbie  # registers the tasks

CANDIDATES, BEST, TARGETS = 48, 8, 4
GENERATIONS = int(sys.argv[1]) if len(sys.argv) > 1 else 30
random = np.random.default_rng(1)
robots = gymnasium.make_vec("RoboNewbie/Reach-v1", num_envs=CANDIDATES)
target = [robots.unwrapped.observation_names.index(f"target.{axis}") for axis in ("forward", "left", "up")]


def mean_centimetres(policies, seed):
    """Returns each policy's mean distance to the same targets, after half a second to reach them."""
    distances = np.zeros(CANDIDATES)
    for i in range(TARGETS):
        observation, _ = robots.reset(seed=[seed + i] * CANDIDATES)
        for step in range(100):
            seen = np.column_stack([10 * observation[:, target], np.ones(CANDIDATES)])
            observation, reward, *_ = robots.step(np.tanh(np.einsum("nij,nj->ni", policies, seen)))
            distances -= reward * (step >= 25)
    return 100 * distances / TARGETS / 75


mean, spread = np.zeros((4, 4)), np.full((4, 4), 0.7)
for generation in range(GENERATIONS):
    policies = mean + spread * random.standard_normal((CANDIDATES, 4, 4))
    distances = mean_centimetres(policies, 1000 * generation)
    best = policies[np.argsort(distances)[:BEST]]
    mean, spread = best.mean(axis=0), best.std(axis=0) + 0.02
    print(f"generation {generation:2}: best {distances.min():5.1f} cm, mean {distances.mean():5.1f} cm", flush=True)
unseen = [mean_centimetres(np.repeat(policy[None], CANDIDATES, 0), 10**6 + i * 9)[0]
          for policy in (np.zeros((4, 4)), mean) for i in range(3)]
print(f"12 targets never seen before: {np.mean(unseen[:3]):.1f} cm before, {np.mean(unseen[3:]):.1f} cm after learning")
robots.close()

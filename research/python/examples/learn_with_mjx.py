"""A NAO learns in MJX, MuJoCo for GPUs, to move its arm to any point. Without a GPU it takes some minutes.

    pip install ./research/python mujoco-mjx
    python research/python/examples/learn_with_mjx.py                 # writes Reach.policy
    ./robonewbie learn Reach Reach.policy --evaluate 20               # plays it in RoboNewbie, without Python

``learn_with_mjx.py 10`` stops after 10 generations instead of 100.
"""

import sys
from pathlib import Path
from xml.etree import ElementTree

import jax
import jax.numpy as jnp
import mujoco
import numpy as np
from mujoco import mjx

from robonewbie import model_path
from robonewbie.train import policy_text

ARM = ["LEFT_SHOULDER_PITCH", "LEFT_SHOULDER_YAW", "LEFT_ARM_ROLL", "LEFT_ARM_YAW"]  # laj1 to laj4
STANCE = jnp.radians(jnp.array([-95.0, 10, -90, -40]))
RANGE = 120  # degrees
SHOULDER, REACH = jnp.array([0, 0.098, 0.075]), 0.15
CYCLES, STEPS = 40, 4
PAIRS, TARGETS, HIDDEN = 32, 8, 16
SIGMA, RATE = 0.05, 0.05
GENERATIONS = int(sys.argv[1]) if len(sys.argv) > 1 else 100


def arm_model():
    """Returns the robot with a fixed torso and only the joints of the left arm, which is all that the task needs."""
    tree = ElementTree.parse(model_path())
    for parent in list(tree.iter()):
        for part in list(parent):
            if part.tag == "freejoint" or not (part.get("joint") or part.tag == "joint" and part.get("name") or "laj").startswith("laj"):
                parent.remove(part)
    tree.getroot().remove(tree.find("sensor"))
    ElementTree.SubElement(tree.find("option"), "flag", constraint="disable")
    return mujoco.MjModel.from_xml_string(ElementTree.tostring(tree.getroot(), encoding="unicode"))


model = arm_model()
device_model = mjx.put_model(model)
torso, lower_arm = model.body("torso").id, model.body("llowerarm").id
largest_change = jnp.array(model.actuator_ctrlrange[:, 1]) * 0.02  # of a target angle in a cycle of 20 ms
low, high = jnp.array(model.actuator_actrange).T
start = mjx.make_data(model).replace(qpos=STANCE, act=STANCE)


def action(weights, target):
    first, second = weights[: 4 * HIDDEN].reshape(HIDDEN, 4), weights[4 * HIDDEN :].reshape(4, HIDDEN + 1)
    hidden = jnp.tanh(first @ jnp.append(10 * (target - SHOULDER), 1))
    return jnp.tanh(second @ jnp.append(hidden, 1))


def reward(weights, target):
    """Returns the negative mean distance of the arm from its target in the second half of an episode, in metres."""
    wanted = jnp.clip(STANCE + jnp.radians(RANGE) * action(weights, target), low, high)

    def cycle(data, _):
        data = data.replace(act=data.act + jnp.clip(wanted - data.act, -largest_change, largest_change))
        data = jax.lax.fori_loop(0, STEPS, lambda _, each: mjx.step(device_model, each), data)
        return data, jnp.linalg.norm(data.xpos[lower_arm] - data.xpos[torso] - target)

    return -jax.lax.scan(cycle, start, length=CYCLES)[1][CYCLES // 2 :].mean()


def targets(key, count):
    """Draws targets as the task Reach does."""
    sides, heights = jax.random.split(key)
    side = jnp.radians(jax.random.uniform(sides, (count,), minval=-22.5, maxval=67.5))
    height = jnp.radians(jax.random.uniform(heights, (count,), minval=-60, maxval=60))
    return SHOULDER + REACH * jnp.stack([jnp.cos(height) * jnp.cos(side), jnp.cos(height) * jnp.sin(side), jnp.sin(height)], axis=1)


rewards = jax.vmap(jax.vmap(reward, (None, 0)), (0, None))


@jax.jit
def generation(mean, rate, key):
    """Moves the weights towards the better ones of antithetic pairs, which is an evolution strategy."""
    noises, places = jax.random.split(key)
    noise = jax.random.normal(noises, (PAIRS, mean.size))
    all_rewards = rewards(mean + SIGMA * jnp.concatenate([noise, -noise]), targets(places, TARGETS)).mean(axis=1)
    better = all_rewards[:PAIRS] - all_rewards[PAIRS:]
    return mean + rate * better @ noise / (jnp.std(better) + 1e-6) / PAIRS**0.5, all_rewards.mean()


def main():
    mean = 0.3 * jax.random.normal(jax.random.key(1), (4 * HIDDEN + 4 * (HIDDEN + 1),))
    for number in range(GENERATIONS):
        mean, result = generation(mean, RATE * (1 - number / GENERATIONS), jax.random.key(number))
        if number % 10 == 0 or number == GENERATIONS - 1:
            print(f"generation {number:3}: mean distance {-100 * result:.1f} cm", flush=True)
    first, second = np.split(np.asarray(mean, dtype=float), [4 * HIDDEN])
    first, second = first.reshape(HIDDEN, 4), second.reshape(4, HIDDEN + 1)
    scaled = 10 * first[:, :3]
    layers = [(scaled, first[:, 3] - scaled @ np.asarray(SHOULDER), "tanh"), (second[:, :-1], second[:, -1], "tanh")]
    inputs = [(f"target.{axis}", "m") for axis in ("forward", "left", "up")]
    text = policy_text("Reach", [f"learned by: learn_with_mjx.py {GENERATIONS}"], inputs, ARM, RANGE, layers)
    Path("Reach.policy").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()

"""Prints what MuJoCo makes of a model: the mass and moments of inertia of each link, then the poses of all links for each posture.

Usage: link-poses.py MODEL POSTURES. Each line of POSTURES has the angles of all joints in degrees, in the order of the model.
"""

import sys

import mujoco
import numpy as np

text = open(sys.argv[1], encoding="utf-8").read()
# Of a URDF file, MuJoCo would make the torso a part of the ground.
model = mujoco.MjModel.from_xml_string(text.replace("<link", '<mujoco><compiler fusestatic="false"/></mujoco><link', 1))
data = mujoco.MjData(model)
joints = [j for j in range(model.njnt) if model.jnt_type[j] == mujoco.mjtJoint.mjJNT_HINGE]
names = [model.joint(j).name for j in joints]
bodies = [b for b in range(1, model.nbody) if model.body(b).name not in ("ball", "goal_left", "goal_right")]


def line(*words):
    print(*words, sep="\t")


for joint in joints:
    line("joint", model.joint(joint).name, *np.degrees(model.jnt_range[joint]))
for body in bodies:
    mujoco.mj_forward(model, data)
    turn = data.ximat[body].reshape(3, 3)
    inertia = turn @ np.diag(model.body_inertia[body]) @ turn.T
    line("link", model.body(body).name, model.body_mass[body], *np.diag(inertia))
order, *postures = open(sys.argv[2], encoding="utf-8").read().splitlines()
columns = [order.split("\t").index(name) for name in names]
for posture in postures:
    degrees = np.array(posture.split("\t"), dtype=float)
    for joint, column in zip(joints, columns):
        data.qpos[model.jnt_qposadr[joint]] = np.radians(degrees[column])
    mujoco.mj_forward(model, data)
    root = data.xpos[bodies[0]]
    line("centre", "of mass", *(data.subtree_com[bodies[0]] - root))
    for body in bodies:
        line("pose", model.body(body).name, *(data.xipos[body] - root), *data.xmat[body])

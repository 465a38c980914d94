"""Writes a policy file, made from an ONNX model, and the actions that onnxruntime computes with the model.

Usage: onnx-actions.py KIND POLICY TABLE. Each line of TABLE has 12 normalised inputs and 6 actions of one episode, in order.
"""

import sys

import numpy as np
import onnxruntime
from onnx import TensorProto, helper, numpy_helper

from robonewbie import onnx, train

kind = sys.argv[1]
random = np.random.default_rng(1)
nodes, constants = [], {}


def constant(name, *shape):
    constants[name] = random.normal(size=shape) / np.sqrt(shape[-2] if len(shape) > 1 else 4)
    return name


def add(operator, inputs, outputs, **attributes):
    nodes.append(helper.make_node(operator, inputs, outputs, **attributes))


add("Gemm", ["x", constant("w1", 12, 32), constant("b1", 32)], ["h"])
if kind == "layer-norm":
    add("LayerNormalization", ["h", constant("scale", 32), constant("shift", 32)], ["a"], epsilon=1e-3)
elif kind == "gru":
    constants["axis"] = np.zeros(1)
    add("Unsqueeze", ["h", "axis"], ["sequence"])
    names = [constant("w", 1, 96, 32), constant("r", 1, 96, 32), constant("b", 1, 192)]
    add("GRU", ["sequence", *names, "", "state"], ["", "next"], hidden_size=32, linear_before_reset=1)
    add("Squeeze", ["next", "axis"], ["a"])
elif kind == "silu":
    add("Sigmoid", ["h"], ["gate"])
    add("Mul", ["h", "gate"], ["a"])
else:
    add({"linear": "Identity", "relu": "Relu", "elu": "Elu", "tanh": "Tanh"}[kind], ["h"], ["a"])
add("Gemm", ["a", constant("w2", 32, 6), constant("b2", 6)], ["s"])
add("Tanh", ["s"], ["y"])

tensors = [numpy_helper.from_array(np.asarray(each, np.int64 if name == "axis" else np.float32), name) for name, each in constants.items()]
inputs, outputs = (
    [helper.make_tensor_value_info(name, TensorProto.FLOAT, [1, size])] + [helper.make_tensor_value_info(state, TensorProto.FLOAT, [1, 1, 32])] * (kind == "gru")
    for name, size, state in (("x", 12, "state"), ("y", 6, "next"))
)
model = helper.make_model(helper.make_graph(nodes, "main", inputs, outputs, tensors), ir_version=8, opset_imports=[helper.make_opsetid("", 17)])
like = train.policy_text("Any", [], [(f"input{i}", "1") for i in range(12)], [f"J{i}" for i in range(6)], 30, [(np.ones((6, 12)), np.ones(6), "cut")])
with open(sys.argv[2], "w", encoding="utf-8") as file:
    file.write(onnx.to_policy(model, like))

session = onnxruntime.InferenceSession(model.SerializeToString())
state = {"state": np.zeros((1, 1, 32), np.float32)} if kind == "gru" else {}
with open(sys.argv[3], "w", encoding="utf-8") as file:
    for observation in random.normal(size=(1000, 1, 12)).astype(np.float32):
        action, *after = session.run(None, {"x": observation, **state})
        state = dict(zip(state, after))
        print(*observation[0], *action[0], sep="\t", file=file)

"""Converts policy files to ONNX models and back.

    python -m robonewbie.onnx Stand.policy Stand.onnx
    python -m robonewbie.onnx trained.onnx My.policy --like Stand.policy

An ONNX model has no names and units of inputs and outputs. They come from the policy named by ``--like``, or from the model's metadata if
the model was written by this module.
"""

import argparse
import dataclasses
import sys
from pathlib import Path

import numpy as np
import onnx
from onnx import TensorProto, helper, numpy_helper

from robonewbie import network
from robonewbie.network import Dense, Gru, LayerNorm

MAX_LAYER_WIDTH = 1024  # of org.robonewbie.agent.policy.PolicyText
_METADATA = "robonewbie.policy"
_NODES = {"tanh": "Tanh", "relu": "Relu", "elu": "Elu"}
_ACTIVATIONS = {node: activation for activation, node in _NODES.items()}


def to_onnx(text):
    """Returns an ONNX model that computes the actions (float32, from -1 to 1) of a policy, given as its file's text, from its inputs."""
    nodes, constants, value = [], [], "observation"

    def constant(name, numbers):
        constants.append(numpy_helper.from_array(np.asarray(numbers, dtype=np.float32), name))
        return name

    def add(kind, *inputs, **attributes):
        output = f"{kind.lower()}_{len(nodes)}"
        nodes.append(helper.make_node(kind, inputs, [output], name=output, **attributes))
        return output

    def gru(value, layer, i):
        size = layer.sizes[1]
        if "first" not in ready:
            ready["first"] = numpy_helper.from_array(np.zeros(1, dtype=np.int64), "first")
        numbers = [_gates(layer.input_weights)[None], _gates(layer.state_weights)[None], np.r_[_gates(layer.input_bias), _gates(layer.state_bias)][None]]
        names = [constant(f"{name}_{i}", table) for name, table in zip(("W", "R", "B"), numbers)]
        before, after = f"state_{i}", f"next_state_{i}"
        states.append((before, after, size))
        sequence = add("Unsqueeze", value, "first")
        nodes.append(helper.make_node("GRU", [sequence, *names, "", before], ["", after], name=f"gru_{i}", hidden_size=size, linear_before_reset=1))
        return add("Squeeze", after, "first")

    ready = {}
    layers, states = network.read(text), []
    for i, layer in enumerate(layers):
        activation = layer.activation
        if isinstance(layer, Gru):
            value = gru(value, layer, i)
        elif isinstance(layer, LayerNorm):
            value = add("LayerNormalization", value, constant(f"scale_{i}", layer.weights), constant(f"bias_{i}", layer.bias), epsilon=layer.epsilon)
        else:
            value = add("Gemm", value, constant(f"weights_{i}", layer.weights.T), constant(f"bias_{i}", layer.bias))
        if activation in _NODES:
            value = add(_NODES[activation], value)
        elif activation == "cut":
            value = add("Clip", value, constant(f"min_{i}", -1), constant(f"max_{i}", 1))
        elif activation == "silu":
            value = add("Mul", value, add("Sigmoid", value))
        elif activation != "linear":
            raise ValueError(f'Layer {i + 1} has the unknown activation "{activation}".')
    nodes[-1].output[0] = "action"
    sizes = {"observation": layers[0].sizes[0], "action": layers[-1].sizes[1]}
    observation, action = (helper.make_tensor_value_info(name, TensorProto.FLOAT, ["batch", size]) for name, size in sizes.items())
    before, after = ([helper.make_tensor_value_info(state[i], TensorProto.FLOAT, [1, "batch", state[2]]) for state in states] for i in (0, 1))
    graph = helper.make_graph(nodes, "policy", [observation, *before], [action, *after], [*constants, *ready.values()])
    model = helper.make_model(graph, producer_name="robonewbie", ir_version=8, opset_imports=[helper.make_opsetid("", 17)])
    helper.set_model_props(model, {_METADATA: _head(text)})
    onnx.checker.check_model(model)
    return model


def _gates(rows):
    """Exchanges the rows of reset gate and update gate, which torch and ONNX have in another order."""
    reset, update, candidate = np.split(rows, 3)
    return np.concatenate([update, reset, candidate])


def to_policy(model, like=None, packed=False):
    """Returns the text of a policy file that computes what an ONNX model computes. Packed weights take a fifth of the space, and are rounded.

    :param like: text of a policy that has the same inputs and outputs; if omitted, the model must have been written by :func:`to_onnx`
    :raises ValueError: if a policy file cannot express the model; the message names the node
    """
    properties = {entry.key: entry.value for entry in model.metadata_props}
    head = _head(like) if like else properties.get(_METADATA)
    if head is None:
        raise ValueError("The model does not name its inputs and outputs. Name a policy that has the same ones (--like).")
    layers = _Chain(model).layers()
    for kind, size in (("input", layers[0].sizes[0]), ("output", layers[-1].sizes[1])):
        named = sum(line.startswith(f"{kind} ") for line in head.splitlines())
        if named != size:
            raise ValueError(f"The model has {size} {kind}s, but the policy names {named}.")
    return head + "\n".join(network.lines(layers, packed)) + "\n"


def _head(text):
    """Returns the lines of a policy before its layers."""
    if not text.startswith("policy 1 "):
        raise ValueError('A policy begins with "policy 1 " and the name of its task.')
    head, layer, _ = text.partition("\nlayer ")
    if not layer:
        raise ValueError("The policy has no layer.")
    return head + "\n"


class _Chain:
    """Reads the nodes of a model, each of which must continue from the one before it."""

    def __init__(self, model):
        graph = model.graph
        self._constants = {tensor.name: _stored(tensor) for tensor in graph.initializer}
        onnx.checker.check_model(model)
        inputs = [entry for entry in graph.input if entry.name not in self._constants]
        self._states = {node.input[5]: node.output[1] for node in graph.node if node.op_type == "GRU" and len(node.input) > 5 and len(node.output) > 1}
        outputs = [entry for entry in graph.output if entry.name not in self._states.values()]
        inputs = [entry for entry in inputs if entry.name not in self._states]
        if len(inputs) != 1 or len(outputs) != 1:
            raise ValueError(f"The model has {len(inputs)} inputs and {len(outputs)} outputs; a policy file has one each.")
        shape = inputs[0].type.tensor_type.shape.dim
        size = shape[-1].dim_value if shape else 0
        if not 1 <= size <= MAX_LAYER_WIDTH:
            raise ValueError(f'The input "{inputs[0].name}" needs a fixed size of 1 to {MAX_LAYER_WIDTH} in its last dimension.')
        self._value, self._gate, self._layers = inputs[0].name, None, []
        self._matrix, self._bias = None, np.zeros(size)
        for node in graph.node:
            self._read(node)
        if self._value != outputs[0].name:
            raise ValueError(f'The output "{outputs[0].name}" is not the result of the last node.')
        if self._matrix is not None or not self._layers or self._layers[-1].activation not in ("tanh", "cut"):
            raise ValueError("The outputs of the model must lie between -1 and 1: its last node must be Tanh, or Clip from -1 to 1.")

    def layers(self):
        """Returns the layers."""
        return self._layers

    def _read(self, node):
        if node.op_type == "Constant" and node.attribute[0].name == "value":
            self._constants[node.output[0]] = _stored(node.attribute[0].t)
            return
        read = getattr(self, f"_read_{node.op_type.lower()}", None)
        others = [name for name in node.input if name != self._value]
        if node.domain or (read is None and node.op_type not in _ACTIVATIONS) or len(others) == len(node.input):
            raise self._refused(node)
        if self._gate and node.op_type != "Mul":
            raise self._refused(node)
        if read is None:
            if _attributes(node).get("alpha", 1) != 1:
                raise self._refused(node, "its alpha must be 1")
            self._activate(_ACTIVATIONS[node.op_type])
        else:
            read(node, others)
        if not self._gate:
            self._value = next(name for name in reversed(node.output) if name)

    def _read_gemm(self, node, others):
        attributes = _attributes(node)
        if node.input[0] != self._value or any(attributes.get(name, 1) != 1 for name in ("alpha", "beta")) or attributes.get("transA", 0):
            raise self._refused(node, "it must be a fully connected layer")
        weights = self._constant(node, others[0], 2)
        bias = self._constant(node, others[1], 1) if len(others) > 1 else 0
        self._apply(node, weights if attributes.get("transB", 0) else weights.T, bias)

    def _read_matmul(self, node, others):
        if len(others) != 1 or node.input[0] != self._value:
            raise self._refused(node, "it must multiply its input by constant weights")
        self._apply(node, self._constant(node, others[0], 2).T, 0)

    def _read_add(self, node, others):
        self._scale(node, 1, self._operand(node, others))

    def _read_sub(self, node, others):
        self._scale(node, 1, -self._operand(node, others, first=True))

    def _read_mul(self, node, others):
        if self._gate:
            if others != [self._gate]:
                raise self._refused(node)
            self._gate = None
            self._activate("silu")
        else:
            self._scale(node, self._operand(node, others), 0)

    def _read_div(self, node, others):
        self._scale(node, 1 / self._operand(node, others, first=True), 0)

    def _read_identity(self, node, others):
        pass

    def _read_sigmoid(self, node, others):
        self._gate = node.output[0]

    def _read_clip(self, node, others):
        if node.input[0] != self._value or len(others) != 2 or "" in others:
            raise self._refused(node, "it needs a constant minimum and maximum")
        low, high = (float(self._constant(node, name, 0)) for name in others)
        if not low < high:
            raise self._refused(node, "its minimum must be less than its maximum")
        if (low, high) == (-1, 1):
            self._activate("cut")
            return
        middle, half = (low + high) / 2, (high - low) / 2
        self._scale(node, 1 / half, -middle / half)
        self._activate("cut")
        self._scale(node, half, middle)

    def _read_layernormalization(self, node, others):
        attributes, size = _attributes(node), len(self._bias)
        if node.input[0] != self._value or attributes.get("axis", -1) not in (-1, 1) or len(node.output) != 1:
            raise self._refused(node, "it must normalise the last dimension")
        numbers = [self._constant(node, name, 1) for name in others]
        if any(len(each) != size for each in numbers):
            raise self._refused(node, f"its constants must have {size} numbers")
        self._finish()
        self._layers.append(LayerNorm(numbers[0], numbers[1] if len(numbers) > 1 else np.zeros(size), float(attributes.get("epsilon", 1e-5))))

    def _read_unsqueeze(self, node, others):
        pass

    def _read_squeeze(self, node, others):
        pass

    def _read_gru(self, node, others):
        attributes, size = _attributes(node), len(self._bias)
        outputs, initial = attributes.get("hidden_size", 0), (list(node.input) + [""] * 6)[4:6]
        usual = attributes.get("linear_before_reset", 0) == 1 and attributes.get("direction", b"forward") == b"forward"
        if node.input[0] != self._value or not usual or set(attributes) - {"linear_before_reset", "direction", "hidden_size"} or initial[0]:
            raise self._refused(node, "it must have one direction, linear_before_reset, and the usual activations")
        if initial[1] and initial[1] not in self._states:
            raise self._refused(node, "its initial state must be an input of the model")
        if not 1 <= outputs <= MAX_LAYER_WIDTH:
            raise self._refused(node, f"it must have at most {MAX_LAYER_WIDTH} outputs")
        shapes = ((1, 3 * outputs, size), (1, 3 * outputs, outputs), (1, 6 * outputs))
        has_bias = len(node.input) > 3 and node.input[3]
        tables = [self._constant(node, name) for name in node.input[1:3]] + [self._constant(node, node.input[3]) if has_bias else np.zeros(shapes[2])]
        if tuple(table.shape for table in tables) != shapes:
            raise self._refused(node, "its constants have other shapes than a policy needs")
        self._finish()
        self._layers.append(Gru(_gates(tables[0][0]), _gates(tables[1][0]), *(_gates(half) for half in np.split(tables[2][0], 2))))
        self._bias = np.zeros(outputs)

    def _finish(self):
        """Ends a fully connected layer that has no activation."""
        if self._matrix is not None:
            self._activate("linear")

    def _operand(self, node, others, first=False):
        if len(others) != 1 or (first and node.input[0] != self._value):
            raise self._refused(node, "its other operand must be constant")
        numbers = self._constant(node, others[0])
        if numbers.size not in (1, len(self._bias)) or numbers.ndim > 2 or (numbers.ndim == 2 and numbers.shape[0] != 1):
            raise self._refused(node, f"its constant must have 1 or {len(self._bias)} numbers")
        return numbers.reshape(-1)

    def _constant(self, node, name, dimensions=None):
        tensor = self._constants.get(name)
        if tensor is None:
            raise self._refused(node, f'"{name}" is not constant')
        numbers = numpy_helper.to_array(tensor).astype(float)
        if not np.isfinite(numbers).all() or (dimensions is not None and numbers.ndim != dimensions):
            raise self._refused(node, f'"{name}" has numbers or a shape that a layer cannot have')
        return numbers

    def _scale(self, node, factor, offset):
        size = len(self._bias)
        self._apply(node, np.diag(np.broadcast_to(factor, size).astype(float)), np.broadcast_to(offset, size))

    def _apply(self, node, weights, bias):
        if weights.shape[1] != len(self._bias) or not 1 <= weights.shape[0] <= MAX_LAYER_WIDTH or np.size(bias) not in (1, weights.shape[0]):
            raise self._refused(node, f"it has {weights.shape[1]} inputs and {weights.shape[0]} outputs after {len(self._bias)} values")
        if self._matrix is not None:
            weights, bias = weights @ self._matrix, weights @ self._bias + bias
        if not np.isfinite(weights).all() or not np.isfinite(bias).all():
            raise self._refused(node, "its numbers must be finite")
        self._matrix, self._bias = weights, np.broadcast_to(bias, len(weights)).astype(float)

    def _activate(self, activation):
        if self._matrix is None and self._layers and isinstance(self._layers[-1], (Gru, LayerNorm)) and self._layers[-1].activation == "linear":
            self._layers[-1] = dataclasses.replace(self._layers[-1], activation=activation)
            return
        matrix = np.identity(len(self._bias)) if self._matrix is None else self._matrix
        self._layers.append(Dense(matrix, self._bias, activation))
        self._matrix, self._bias = None, np.zeros(len(self._bias))

    def _refused(self, node, reason=None):
        known = "Known nodes, in a chain: Gemm, MatMul, Add, Sub, Mul, Div, Clip, Tanh, Relu, Elu, Sigmoid with Mul (SiLU), LayerNormalization, GRU, Identity"
        return ValueError(f'A policy file cannot express the node "{node.name or node.output[0]}" ({node.op_type}): {reason or known}.')


def _stored(tensor):
    if tensor.data_location == TensorProto.EXTERNAL:
        raise ValueError(f'The numbers of "{tensor.name}" are in another file. Save the model as one file.')
    return tensor


def _attributes(node):
    return {attribute.name: helper.get_attribute_value(attribute) for attribute in node.attribute}


def main(words=None):
    """Runs the command line."""
    parser = argparse.ArgumentParser(prog="python -m robonewbie.onnx", description="Converts a policy file to an ONNX model, or an ONNX model to a policy file.")
    parser.add_argument("source", type=Path, help="file that ends with .policy or .onnx")
    parser.add_argument("out", type=Path, help="file of the other kind")
    parser.add_argument("--like", type=Path, metavar="POLICY", help="policy that names the inputs and outputs of the ONNX model")
    parser.add_argument("--packed", action="store_true", help="round and pack the weights of the policy file to about 2.4 bytes each")
    wanted = parser.parse_args(words)
    kinds = (wanted.source.suffix, wanted.out.suffix)
    try:
        if kinds == (".policy", ".onnx"):
            onnx.save(to_onnx(wanted.source.read_text(encoding="utf-8")), str(wanted.out))
        elif kinds == (".onnx", ".policy"):
            like = wanted.like.read_text(encoding="utf-8") if wanted.like else None
            text = to_policy(onnx.load(str(wanted.source), load_external_data=False), like, wanted.packed)
            wanted.out.write_text(text, encoding="utf-8")
        else:
            sys.exit("Name a .policy file and an .onnx file, or an .onnx file and a .policy file.")
    except Exception as wrong:  # onnx raises the errors of protobuf and of its checker, which share no base class
        sys.exit(f"{wanted.source}: {wrong}")


if __name__ == "__main__":
    main()

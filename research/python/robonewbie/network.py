"""Layers of the network in a policy file: evaluation with NumPy, and the text form, which org.robonewbie.agent.policy.PolicyText describes."""

import base64
import zlib
from dataclasses import dataclass

import numpy as np

ACTIVATIONS = {
    "tanh": np.tanh,
    "cut": lambda x: np.clip(x, -1, 1),
    "relu": lambda x: np.maximum(x, 0),
    "elu": lambda x: np.where(x > 0, x, np.exp(np.minimum(x, 0)) - 1),
    "silu": lambda x: x / (1 + np.exp(-x)),
    "linear": lambda x: x,
}

_STEPS = 8192  # that a weight of usual magnitude is packed in
_LINE = 120


@dataclass(frozen=True)
class Dense:
    """Fully connected layer: weights (outputs × inputs) and biases."""

    weights: np.ndarray
    bias: np.ndarray
    activation: str = "linear"
    biases = 1
    kind = ""

    @property
    def sizes(self):
        """The numbers of inputs and outputs."""
        return np.shape(self.weights)[::-1]

    def table(self):
        """Returns the rows of numbers in the file: biases, then weights."""
        return np.column_stack([self.bias, self.weights])

    def apply(self, values, state):
        """Returns the outputs and the new state for a batch of inputs."""
        return ACTIVATIONS[self.activation](values @ np.transpose(self.weights) + self.bias), state


@dataclass(frozen=True)
class LayerNorm:
    """Layer normalisation."""

    weights: np.ndarray
    bias: np.ndarray
    epsilon: float = 1e-5
    activation: str = "linear"
    biases = 2

    @property
    def kind(self):
        """The words after the activation in the file."""
        return f" layer-norm {self.epsilon:g}"

    @property
    def sizes(self):
        """The numbers of inputs and outputs."""
        return len(self.weights), len(self.weights)

    def table(self):
        """Returns the rows of numbers in the file."""
        return np.column_stack([self.bias, self.weights])

    def apply(self, values, state):
        """Returns the outputs and the new state for a batch of inputs."""
        mean, variance = values.mean(1, keepdims=True), values.var(1, keepdims=True)
        return ACTIVATIONS[self.activation]((values - mean) / np.sqrt(variance + self.epsilon) * self.weights + self.bias), state


@dataclass(frozen=True)
class Gru:
    """Gated recurrent unit with the parameters of torch: the rows of the reset gate, of the update gate, then of the candidate."""

    input_weights: np.ndarray
    state_weights: np.ndarray
    input_bias: np.ndarray
    state_bias: np.ndarray
    activation: str = "linear"
    biases = 2
    kind = " gru"

    @property
    def sizes(self):
        """The numbers of inputs and outputs."""
        return self.input_weights.shape[1], self.state_weights.shape[1]

    def table(self):
        """Returns the rows of numbers in the file."""
        return np.column_stack([self.input_bias, self.state_bias, self.input_weights, self.state_weights])

    def apply(self, values, state):
        """Returns the outputs and the new state for a batch of inputs. The first state is None."""
        state = np.zeros((len(values), self.sizes[1])) if state is None else state
        of_input = np.split(values @ self.input_weights.T + self.input_bias, 3, axis=1)
        of_state = np.split(state @ self.state_weights.T + self.state_bias, 3, axis=1)
        reset, update = (1 / (1 + np.exp(-(of_input[i] + of_state[i]))) for i in range(2))
        state = (1 - update) * np.tanh(of_input[2] + reset * of_state[2]) + update * state
        return ACTIVATIONS[self.activation](state), state


def lines(layers, packed=False):
    """Returns the lines of layers in a policy file, with as many digits as float32 needs, or packed. A tuple of weights, biases and activation is a Dense layer."""
    written = []
    for layer in layers:
        layer = Dense(*layer) if isinstance(layer, tuple) else layer
        inputs, outputs = layer.sizes
        head = f"layer {inputs} {outputs} {layer.activation}{layer.kind}"
        table = layer.table()
        if packed and table.shape[1] > layer.biases:
            text = _pack(table, layer.biases)
            rows = [text[i : i + _LINE] for i in range(0, len(text), _LINE)]
            head += f" packed {len(rows)}"
        else:
            rows = [" ".join(f"{float(str(number)):.9g}" for number in row) for row in np.float32(table)]
        written += [head, *rows]
    return written


def read(text):
    """Returns the layers of a policy file."""
    layers, remaining = [], iter(text.splitlines())
    for line in remaining:
        words = line.split()
        if not words or words[0] != "layer":
            continue
        inputs, outputs, activation, kind = int(words[1]), int(words[2]), words[3], words[4:5]
        rows = 3 * outputs if kind == ["gru"] else outputs
        if "packed" in words:
            packed = "".join(next(remaining).strip() for _ in range(int(words[-1])))
            biases, weights = (2, inputs + outputs) if kind == ["gru"] else (1, inputs)
            table = _unpack(packed, rows, biases, weights)
        else:
            table = np.array([[float(word) for word in next(remaining).split()] for _ in range(rows)])
        if kind == ["gru"]:
            layers.append(Gru(table[:, 2 : 2 + inputs], table[:, 2 + inputs :], table[:, 0], table[:, 1], activation))
        elif kind == ["layer-norm"]:
            layers.append(LayerNorm(table[:, 1], table[:, 0], float(words[5]), activation))
        else:
            layers.append(Dense(table[:, 1:], table[:, 0], activation))
    return layers


def _pack(table, biases):
    """Rounds weights to integers in steps of a fraction of the root mean square of their row."""
    weights = np.asarray(table[:, biases:], dtype=float)
    columns = np.sqrt(np.mean(weights**2, axis=0))
    usual = np.sqrt(np.mean(weights**2)) or 1
    exponents = np.clip(np.rint(np.log2(np.where(columns > 0, columns / usual, 1))), -126, 126).astype(np.int8)
    factors = np.ldexp(1.0, exponents)
    steps = np.float32(np.sqrt(np.mean((weights / factors) ** 2, axis=1)) / _STEPS)
    steps = np.where(steps > 0, steps, np.float32(1))
    integers = np.rint(weights / factors / steps.astype(float)[:, None]).astype(np.int64)
    zigzag = np.where(integers < 0, -2 * integers - 1, 2 * integers).astype("<u4")
    planes = np.ascontiguousarray(zigzag).view(np.uint8).reshape(-1, 4)[:, :3].T
    floats = np.column_stack([table[:, :biases], steps]).astype("<f4")
    return base64.b85encode(zlib.compress(exponents.tobytes() + floats.tobytes() + planes.tobytes(), 9)).decode()


def _unpack(text, rows, biases, weights):
    size = weights + 4 * rows * (biases + 1) + 3 * rows * weights
    content = zlib.decompressobj().decompress(base64.b85decode(text), size + 1)
    if len(content) != size:
        raise ValueError(f"The packed weights of a layer with {rows} rows are damaged. Write the policy again.")
    exponents = np.frombuffer(content, np.int8, weights)
    floats = np.frombuffer(content, "<f4", rows * (biases + 1), weights).reshape(rows, -1).astype(float)
    planes = np.frombuffer(content, np.uint8, offset=size - 3 * rows * weights).reshape(3, rows, weights).astype(np.int64)
    zigzag = planes[0] | planes[1] << 8 | planes[2] << 16
    integers = zigzag >> 1 ^ -(zigzag & 1)
    return np.column_stack([floats[:, :biases], floats[:, biases:] * np.ldexp(1.0, exponents) * integers])

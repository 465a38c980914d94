"""Conversion between policy files and ONNX models, compared with onnxruntime; skipped where onnx is not installed."""

import tempfile
import unittest
from pathlib import Path

import numpy as np

from robonewbie import evaluate, network, train
from robonewbie.network import Dense, Gru, LayerNorm

try:
    import onnx
    import onnxruntime
    from onnx import TensorProto, helper, numpy_helper

    from robonewbie import onnx as policies
except ImportError:
    onnx = None

ROOT = Path(__file__).parents[3]
LIKE = train.policy_text("Stand", ["mine"], [(f"gyro.{i}", "degrees/s") for i in range(12)], [f"J{i}" for i in range(6)], 30, [(np.ones((6, 12)), np.ones(6), "cut")])


def model_of(nodes, constants, inputs=12, outputs=6, value="y"):
    """Returns a model with the input x; nodes are tuples of operator, inputs, output and attributes."""
    made = [helper.make_node(kind, [*takes], [gives], name=f"/{gives}", **attributes) for kind, takes, gives, attributes in nodes]
    tensors = [numpy_helper.from_array(np.asarray(numbers, dtype=np.float32), name) for name, numbers in constants.items()]
    values = [helper.make_tensor_value_info(name, TensorProto.FLOAT, [None, size]) for name, size in (("x", inputs), (value, outputs))]
    graph = helper.make_graph(made, "main", values[:1], values[1:], tensors)
    return helper.make_model(graph, ir_version=8, opset_imports=[helper.make_opsetid("", 17)])


def perceptron(activation, last=(("Tanh", ["s"], "y", {}),)):
    """Returns nodes and constants of a network with normalised and clipped observations and one hidden layer, as torch writes it."""
    random = np.random.default_rng(1)
    constants = {
        "mean": random.normal(size=12), "deviation": random.uniform(0.5, 2, size=12), "low": -1.5, "high": 2.5,
        "w1": random.normal(size=(32, 12)) / 3, "b1": random.normal(size=32), "w2": random.normal(size=(32, 6)) / 5, "b2": random.normal(size=6),
    }
    nodes = [
        ("Sub", ["x", "mean"], "centred", {}), ("Div", ["centred", "deviation"], "scaled", {}), ("Clip", ["scaled", "low", "high"], "clipped", {}),
        ("Gemm", ["clipped", "w1", "b1"], "h", {"transB": 1}), *activation, ("MatMul", ["a", "w2"], "m", {}), ("Add", ["b2", "m"], "s", {}), *last,
    ]
    return nodes, constants


def run(model, observation):
    session = onnxruntime.InferenceSession(model.SerializeToString())
    return session.run(None, {session.get_inputs()[0].name: observation})[0]


@unittest.skipUnless(onnx, "onnx and onnxruntime are not installed")
class OnnxTest(unittest.TestCase):
    def setUp(self):
        self.observation = np.random.default_rng(2).normal(size=(1000, 12)).astype(np.float32)

    def test_model_becomes_a_policy_that_acts_alike(self):
        hidden = {
            "tanh": [("Tanh", ["h"], "a", {})],
            "relu": [("Relu", ["h"], "a", {})],
            "elu": [("Elu", ["h"], "a", {"alpha": 1.0})],
            "silu": [("Sigmoid", ["h"], "g", {}), ("Mul", ["h", "g"], "a", {})],
            "linear": [("Identity", ["h"], "a", {})],
        }
        for name, nodes in hidden.items():
            for end in ([("Tanh", ["s"], "y", {})], [("Clip", ["s", "lowest", "highest"], "y", {})]):
                with self.subTest(name, last=end[0][0]):
                    nodes_of_all, constants = perceptron(nodes, end)
                    limits = {"lowest": -1, "highest": 1} if end[0][0] == "Clip" else {}
                    model = model_of(nodes_of_all, {**constants, **limits})

                    text = policies.to_policy(model, LIKE)

                    self.assertTrue(text.startswith("policy 1 Stand\n# mine\n"))
                    np.testing.assert_allclose(evaluate.PlayedPolicy(text).act(self.observation), run(model, self.observation), rtol=1e-4, atol=1e-6)

    def test_policy_becomes_a_model_that_acts_alike(self):
        random = np.random.default_rng(3)
        for name in network.ACTIVATIONS:
            for last in ("tanh", "cut"):
                with self.subTest(name, last=last):
                    layers = [(random.normal(size=(32, 12)) / 3, random.normal(size=32), name), (random.normal(size=(6, 32)) / 5, random.normal(size=6), last)]
                    text = LIKE.partition("layer ")[0] + "\n".join(network.lines(layers)) + "\n"

                    model = policies.to_onnx(text)

                    np.testing.assert_allclose(run(model, self.observation), evaluate.PlayedPolicy(text).act(self.observation), rtol=1e-4, atol=1e-6)
                    again = policies.to_policy(model)
                    if name == "linear":  # becomes part of the next layer
                        np.testing.assert_allclose(evaluate.PlayedPolicy(again).act(self.observation), run(model, self.observation), rtol=1e-4, atol=1e-6)
                    else:
                        self.assertEqual(again, text)

    def test_layer_norm_and_gru_act_alike_step_by_step_and_return_unchanged(self):
        random = np.random.default_rng(4)
        layers = [
            LayerNorm(random.normal(size=12), random.normal(size=12)),
            Dense(random.normal(size=(16, 12)) / 3, random.normal(size=16)),
            LayerNorm(random.normal(size=16), random.normal(size=16), 1e-3, "elu"),
            Gru(random.normal(size=(24, 16)) / 3, random.normal(size=(24, 8)) / 3, random.normal(size=24), random.normal(size=24), "silu"),
            Gru(random.normal(size=(21, 8)) / 3, random.normal(size=(21, 7)) / 3, random.normal(size=21), random.normal(size=21)),
            Dense(random.normal(size=(6, 7)) / 3, random.normal(size=6), "tanh"),
        ]
        text = LIKE.partition("layer ")[0] + "\n".join(network.lines(layers)) + "\n"
        model = policies.to_onnx(text)

        session, policy = onnxruntime.InferenceSession(model.SerializeToString()), evaluate.PlayedPolicy(text)
        states = {"state_3": np.zeros((1, 100, 8), np.float32), "state_4": np.zeros((1, 100, 7), np.float32)}
        for observation in np.split(self.observation, 10):
            action, *after = session.run(None, {"observation": observation, **states})
            states = dict(zip(states, after))
            np.testing.assert_allclose(policy.act(observation), action, rtol=1e-4, atol=1e-6)
        self.assertEqual(policies.to_policy(model), text)

    def test_gru_of_another_form_is_refused(self):
        constants = {"w": np.zeros((1, 9, 12)), "r": np.zeros((1, 9, 3)), "m": np.ones((3, 6))}
        nodes = [("GRU", ["x", "w", "r"], "h", {"hidden_size": 3}), ("MatMul", ["h", "m"], "s", {}), ("Tanh", ["s"], "y", {})]
        with self.assertRaisesRegex(ValueError, r'"/h" \(GRU\): it must have one direction, linear_before_reset'):
            policies.to_policy(model_of(nodes, constants), LIKE)

    def test_packed_policy_of_200_000_numbers_is_small_and_acts_nearly_alike(self):
        random = np.random.default_rng(5)
        sizes = [12, 440, 440, 6]
        layers = [
            Dense(random.uniform(-1, 1, (b, a)) / np.sqrt(a), random.uniform(-1, 1, b) / np.sqrt(a), last)
            for a, b, last in zip(sizes, sizes[1:], ("elu", "elu", "tanh"))
        ]
        head = LIKE.partition("layer ")[0]
        exact, packed = (head + "\n".join(network.lines(layers, each)) + "\n" for each in (False, True))

        count = sum(b * (a + 1) for a, b in zip(sizes, sizes[1:]))
        self.assertGreater(count, 200_000)
        self.assertLess(len(packed), 500_000)
        wanted, found = (evaluate.PlayedPolicy(text).act(self.observation) for text in (exact, packed))
        self.assertLess(np.abs(found - wanted).max(), 1e-4)
        np.testing.assert_allclose(run(policies.to_onnx(packed), self.observation), found, rtol=1e-4, atol=1e-6)
        self.assertLess(len(policies.to_policy(policies.to_onnx(exact), packed=True)), 500_000)

    def test_baselines_return_unchanged(self):
        files = sorted((ROOT / "research/python/baselines").glob("*.policy"))
        self.assertTrue(files)
        for file in files:
            with self.subTest(file.name):
                text = file.read_text(encoding="utf-8")
                self.assertEqual(policies.to_policy(policies.to_onnx(text)), text)

    def test_refused_node_is_named(self):
        elu = [("Elu", ["h"], "a", {})]
        weights = {"w": np.ones((6, 12)), "odd": np.ones((6, 7)), "nan": np.full((6, 12), np.nan), "one": 1, "two": 2, "minus": -1}
        layer = ("Gemm", ["x", "w"], "s", {"transB": 1})
        cases = [
            (perceptron([("LeakyRelu", ["h"], "a", {})]), r'the node "/a" \(LeakyRelu\)'),
            (perceptron([("Elu", ["h"], "a", {"alpha": 2.0})]), r'"/a" \(Elu\): its alpha must be 1'),
            (perceptron([("Sigmoid", ["h"], "g", {}), ("Tanh", ["g"], "a", {})]), r'"/a" \(Tanh\)'),
            (perceptron([("Sigmoid", ["h"], "a", {})]), r'"/m" \(MatMul\)'),
            (perceptron(elu, [("Identity", ["s"], "y", {})]), "its last node must be Tanh, or Clip from -1 to 1"),
            (([layer, ("Clip", ["s", "minus", "two"], "y", {})], weights), "its last node must be Tanh, or Clip from -1 to 1"),
            (([layer, ("Clip", ["s", "two", "one"], "y", {})], weights), "its minimum must be less than its maximum"),
            (([layer, ("Tanh", ["s"], "a", {}), ("Add", ["a", "s"], "y", {})], weights), '"s" is not constant'),
            (([("Gemm", ["x", "w"], "s", {"transB": 1, "alpha": 2.0}), ("Tanh", ["s"], "y", {})], weights), "it must be a fully connected layer"),
            (([("Gemm", ["x", "odd"], "s", {"transB": 1}), ("Tanh", ["s"], "y", {})], weights), "it has 7 inputs and 6 outputs after 12 values"),
            (([("Gemm", ["x", "nan"], "s", {"transB": 1}), ("Tanh", ["s"], "y", {})], weights), '"nan" has numbers or a shape that a layer cannot have'),
        ]
        for (nodes, constants), message in cases:
            with self.subTest(message), self.assertRaisesRegex(ValueError, message):
                policies.to_policy(model_of(nodes, constants), LIKE)

    def test_model_must_fit_the_named_inputs_and_outputs(self):
        nodes, constants = [("Gemm", ["x", "w"], "s", {}), ("Tanh", ["s"], "y", {})], {"w": np.ones((5, 6))}
        with self.assertRaisesRegex(ValueError, "The model has 5 inputs, but the policy names 12."):
            policies.to_policy(model_of(nodes, constants, inputs=5), LIKE)
        with self.assertRaisesRegex(ValueError, "Name a policy that has the same ones"):
            policies.to_policy(model_of(nodes, constants, inputs=5))
        with self.assertRaisesRegex(ValueError, 'The input "x" needs a fixed size of 1 to 1024'):
            policies.to_policy(model_of(nodes, constants, inputs=10**9), LIKE)

    def test_numbers_in_another_file_are_refused(self):
        model = model_of([("Gemm", ["x", "w"], "s", {}), ("Tanh", ["s"], "y", {})], {"w": np.ones((12, 6))})
        tensor = model.graph.initializer[0]
        tensor.ClearField("raw_data")
        tensor.data_location = TensorProto.EXTERNAL
        tensor.external_data.add(key="location", value="weights.bin")

        with self.assertRaisesRegex(ValueError, 'The numbers of "w" are in another file'):
            policies.to_policy(model, LIKE)

    def test_command_converts_files(self):
        with tempfile.TemporaryDirectory() as folder:
            policy, model, again = (str(Path(folder, name)) for name in ("a.policy", "a.onnx", "b.policy"))
            Path(policy).write_text(LIKE, encoding="utf-8")
            policies.main([policy, model])
            policies.main([model, again])

            self.assertEqual(Path(again).read_text(encoding="utf-8"), LIKE)
            for words, message in ((["a.txt", model], "Name a .policy file and an .onnx file"), ([str(Path(folder, "no.onnx")), again], "no.onnx")):
                with self.assertRaisesRegex(SystemExit, message):
                    policies.main(words)
            Path(model).write_bytes(b"nothing of the kind")
            with self.assertRaisesRegex(SystemExit, "a.onnx: "):
                policies.main([model, again])


if __name__ == "__main__":
    unittest.main()

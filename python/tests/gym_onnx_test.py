"""ONNX files as policies: what they compute, what is refused, and files that frameworks wrote.

    python3 gym_onnx_test.py --write    # those of fixtures/policies, with torch, onnx and onnxscript
"""
import contextlib
import importlib
import io
import os
import pathlib
import struct
import sys
import tempfile
import unittest
import warnings
from unittest import mock

from gym_support import differences  # noqa: F401  first: may hide gymnasium
import numpy as np

from cls_gym import network, onnx_import
from cls_gym.network import PolicyError
from cls_gym.onnx_import import from_onnx

SOURCES = pathlib.Path(__file__).resolve().parents[2]
FIXTURES = SOURCES / "fixtures/policies"
EXPORTS = {"torch_script.onnx": False, "torch_dynamo.onnx": True}  # whether by the newer exporter
FEATURES, ACTIONS = 6, 4
ABOUT = {"feature_names": [f"f{i}" for i in range(FEATURES)],
         "action_names": [f"a{i}" for i in range(ACTIONS)], "decides": "ball"}
RANDOM = np.random.default_rng(3)
SEEN = RANDOM.normal(0, 1, (50, FEATURES)).astype(np.float32)


def numbers(*shape):
    return RANDOM.normal(0, 0.7, shape).astype(np.float32)


# A writer of the parts of ONNX that the tests need: field numbers are those of onnx.proto.

def varint(value):
    value &= (1 << 64) - 1
    out = b""
    while value > 0x7F:
        out += bytes([value & 0x7F | 0x80])
        value >>= 7
    return out + bytes([value])


def field(number, value):
    """An integer, a float, a text, or the bytes of a message."""
    if isinstance(value, float):
        return varint(number << 3 | 5) + struct.pack("<f", value)
    if isinstance(value, int):
        return varint(number << 3) + varint(value)
    content = value.encode() if isinstance(value, str) else value
    return varint(number << 3 | 2) + varint(len(content)) + content


def tensor(name, array, raw=True):
    array = np.asarray(array)
    kind, at = {"f": (1, 4), "i": (7, 7)}[array.dtype.kind]
    out = b"".join(field(1, size) for size in array.shape) + field(2, kind) + field(8, name)
    if raw:
        return out + field(9, array.astype("<f4" if kind == 1 else "<i8").tobytes())
    if kind == 1:
        return out + field(at, array.astype("<f4").tobytes())
    return out + field(at, b"".join(varint(int(one)) for one in array.ravel()))


def attribute(name, value):
    if isinstance(value, float):
        return field(1, name) + field(2, value) + field(20, 1)
    if isinstance(value, int):
        return field(1, name) + field(3, value) + field(20, 2)
    if isinstance(value, np.ndarray):
        return field(1, name) + field(5, tensor("", value)) + field(20, 4)
    return field(1, name) + b"".join(field(8, one) for one in value) + field(20, 7)


def node(op, inputs, *outputs, **attributes):
    return field(1, b"".join(field(1, one) for one in inputs)
                 + b"".join(field(2, one) for one in outputs)
                 + field(3, f"{outputs[0]}_node") + field(4, op)
                 + b"".join(field(5, attribute(*one)) for one in attributes.items()))


def port(number, name, size):
    shape = field(2, field(1, field(2, "batch")) + field(1, field(1, size)))
    return field(number, field(1, name) + field(2, field(1, field(1, 1) + shape)))


def typed(name, shape, kind, content):
    """A tensor of any type; content: its field of numbers."""
    return b"".join(field(1, one) for one in shape) + field(2, kind) + field(8, name) + content


def beside(name, shape, **where):
    """A tensor whose numbers lie in another file."""
    return typed(name, shape, 1, field(14, 1) + b"".join(
        field(13, field(1, key) + field(2, str(value))) for key, value in where.items()))


def joined(content, tensors=(), inputs=()):
    """With more of them: a second graph field continues the first one, they are one message."""
    return content + field(7, b"".join(field(5, one) for one in tensors)
                           + b"".join(port(11, *one) for one in inputs))


def model(nodes, weights, outputs=("scores",), size=FEATURES, raw=True):
    graph = b"".join(nodes) + field(2, "graph")
    graph += b"".join(field(5, tensor(name, one, raw)) for name, one in weights.items())
    graph += port(11, "seen", size) + b"".join(port(12, name, ACTIONS) for name in outputs)
    return field(1, 8) + field(7, graph) + field(8, field(2, 17))


def layers(activation="Tanh"):
    """Two layers and what they compute."""
    weights = {"w1": numbers(5, FEATURES), "b1": numbers(5), "w2": numbers(5, ACTIONS),
               "b2": numbers(ACTIONS)}
    nodes = [node("Gemm", ["seen", "w1", "b1"], "sum", transB=1),
             node(activation, ["sum"], "hidden"),
             node("MatMul", ["hidden", "w2"], "product"),
             node("Add", ["product", "b2"], "scores")]
    act = np.tanh if activation == "Tanh" else (lambda x: np.maximum(x, 0))
    return nodes, weights, act(SEEN @ weights["w1"].T + weights["b1"]) @ weights["w2"] + weights["b2"]


class OnnxFiles(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def read(self, content, **options):
        path = self.folder / "model.onnx"
        path.write_bytes(content)
        return from_onnx(path, ABOUT, **options)

    def kinds(self, net):
        return [(step.kind, step.activation) for step in net.steps]

    def check(self, net, expected):
        np.testing.assert_allclose(net.scores(SEEN), expected, atol=3e-6)
        path = self.folder / "again.policy"
        net.save(path)
        np.testing.assert_array_equal(network.load(path).exact_scores(SEEN), net.exact_scores(SEEN))

    def refusal(self, content, **options):
        with self.assertRaises(PolicyError) as caught:
            self.read(content, **options)
        self.assertTrue(str(caught.exception).isprintable())
        return str(caught.exception)


class Networks(OnnxFiles):
    def test_layers_become_steps(self):
        for activation in ("Tanh", "Relu"):
            for raw in (True, False):
                nodes, weights, expected = layers(activation)
                net = self.read(model(nodes, weights, raw=raw))
                self.assertEqual(self.kinds(net), [("dense", activation.lower()), ("dense", "none")])
                self.assertEqual([step.name for step in net.steps], ["dense1", "dense2"])
                self.check(net, expected)

    def test_normalization_is_a_step_and_what_follows_a_layer_is_in_it(self):
        mean, deviation = numbers(FEATURES), np.abs(numbers(FEATURES)) + 1
        factor, shift, average = numbers(5), numbers(5), numbers(5)
        variance = np.abs(numbers(5)) + 0.5
        nodes, weights, _ = layers()
        nodes = [node("Sub", ["seen", "mean"], "around"), node("Div", ["around", "dev"], "scaled"),
                 node("Gemm", ["scaled", "w1", "b1"], "sum", transB=1, alpha=0.5, beta=2.0),
                 node("BatchNormalization", ["sum", "factor", "shift", "average", "variance"],
                      "normed", epsilon=0.01),
                 node("Relu", ["normed"], "hidden"), node("MatMul", ["hidden", "w2"], "product"),
                 node("Mul", ["product", "half"], "less"), node("Sub", ["b2", "less"], "scores")]
        weights.update(mean=mean, dev=deviation, factor=factor, shift=shift, average=average,
                       variance=variance, half=np.float32(0.5))
        total = 0.5 * ((SEEN - mean) / deviation) @ weights["w1"].T + 2 * weights["b1"]
        normed = (total - average) / np.sqrt(variance + 0.01) * factor + shift
        net = self.read(model(nodes, weights))
        self.assertEqual([kind for kind, _ in self.kinds(net)], ["norm", "norm", "dense", "dense"])
        self.check(net, weights["b2"] - 0.5 * (np.maximum(normed, 0) @ weights["w2"]))

    def test_what_changes_nothing_is_left_out(self):
        nodes, weights, expected = layers()
        nodes[0] = node("Flatten", ["seen"], "flat")
        nodes[1:1] = [node("Constant", [], "shape", value=np.array([-1, FEATURES])),
                      node("Reshape", ["flat", "shape"], "rows"), node("Cast", ["rows"], "cast", to=1),
                      node("Transpose", ["w1"], "turned", perm=[1, 0]),
                      node("MatMul", ["cast", "turned"], "first"), node("Add", ["b1", "first"], "sum")]
        nodes += [node("Identity", ["scores"], "logits"), node("Softmax", ["logits"], "shares", axis=-1)]
        net = self.read(model(nodes, weights, outputs=["shares"]))
        self.assertEqual(len(net.steps), 2)
        self.check(net, expected)

    def test_a_layer_may_be_read_twice(self):
        nodes, weights, _ = layers()
        weights["w2"] = numbers(10, ACTIONS)
        nodes[2:2] = [node("Concat", ["sum", "hidden"], "both", axis=1)]
        nodes[3] = node("MatMul", ["both", "w2"], "product")
        total = SEEN @ weights["w1"].T + weights["b1"]
        both = np.concatenate([total, np.tanh(total)], axis=1)
        self.check(self.read(model(nodes, weights)), both @ weights["w2"] + weights["b2"])

    def test_the_output_with_a_number_per_action_is_the_scores(self):
        nodes, weights, expected = layers()
        weights["w3"] = numbers(5, 1)
        nodes += [node("MatMul", ["hidden", "w3"], "value"), node("Sigmoid", ["product"], "other")]
        net = self.read(model(nodes, weights, outputs=["value", "scores", "other"]))
        self.check(net, expected)
        several = model(nodes, weights, outputs=["value", "scores", "product"])
        self.assertIn("each of the outputs scores, product", self.refusal(several))
        self.check(self.read(several, output="product"), expected - weights["b2"])
        self.assertIn("no node computes an output 'none'", self.refusal(several, output="none"))

    def test_weights_may_lie_beside_the_file(self):
        nodes, weights, expected = layers()
        data = weights.pop("w1")
        (self.folder / "model.onnx.data").write_bytes(b"1234" + data.tobytes())

        def placed(location, offset=4, length=data.nbytes):
            return joined(model(nodes, weights), [beside("w1", data.shape, location=location,
                                                         offset=offset, length=length)])

        self.check(self.read(placed("model.onnx.data")), expected)
        os.mkfifo(self.folder / "pipe")
        (self.folder / "link").symlink_to(FIXTURES / "torch_onnx.npz")
        (self.folder / "loop").symlink_to("loop")
        outside = "is outside of the model's folder"
        for location, said in (("../model.onnx.data", outside), ("link", outside), ("", outside),
                               (str(self.folder / "model.onnx.data"), outside),
                               ("pipe", "is not a file"), ("absent", "No such file"),
                               ("loop", ""), ("a\0b", "")):
            refusal = self.refusal(placed(location))
            self.assertIn(f"Gemm 'sum_node': weights in {location!r}: ", refusal)
            self.assertIn(said, refusal)
            self.assertNotIn("is damaged", refusal)
        for offset, length in ((1 << 70, data.nbytes), (-4, data.nbytes), (5, data.nbytes),
                               (4, 1 << 70), (4, -1), ("four", data.nbytes)):
            self.assertIn("weights in 'model.onnx.data': ",
                          self.refusal(placed("model.onnx.data", offset, length)))

    def test_other_outputs_of_a_node_do_not_hinder(self):
        nodes, weights, expected = layers()
        nodes[2:2] = [node("Dropout", ["hidden"], "kept", "mask")]
        nodes[3] = node("MatMul", ["kept", "w2"], "product")
        content = model(nodes, weights, outputs=["mask", "scores"])
        self.check(self.read(content), expected)
        self.assertIn("Dropout 'kept_node': its output 'mask' is not read",
                      self.refusal(content, output="mask"))


class Refusals(OnnxFiles):
    def test_operators_are_named(self):
        nodes, weights, _ = layers()
        for op in ("Sigmoid", "LayerNormalization", "Elu"):
            nodes[1] = node(op, ["sum"], "hidden")
            self.assertIn(f"model.onnx: {op} 'hidden_node': is not one of Add, ",
                          self.refusal(model(nodes, weights)))

    def test_what_has_another_meaning_is_refused(self):
        nodes, weights, _ = layers()
        for other, said in (
                (node("Gemm", ["seen", "w1", "b1"], "sum", transA=1, transB=1), "transA"),
                (node("Gemm", ["seen", "w1", "b1"], "sum"), r"do not fit 6 numbers"),
                (node("MatMul", ["w1", "seen"], "sum"), "input 1 is fixed"),
                (node("Tanh", ["seen"], "sum"), "does not follow a Gemm or MatMul"),
                (node("Mul", ["seen", "seen"], "sum"), "input 2 is not fixed"),
                (node("Add", ["seen", "b1"], "sum"), "do not fit 6 numbers"),
                (node("Reshape", ["seen", "shape"], "sum"), "changes rows"),
                (node("Add", ["seen", "absent"], "sum"), "nothing computes 'absent'"),
                (node("Cast", ["seen"], "sum", to=10), "is not to float or double"),
                (node("Dropout", ["seen", "", "shape"], "sum", "mask"), "is that of training"),
                (node("Gemm", ["seen"], "sum"), "Gemm 'sum_node': has no input 2")):
            changed = dict(weights, shape=np.array([-1, 2]))
            self.assertIn(said, self.refusal(model([other] + nodes[1:], changed)))

    def test_networks_for_something_else_are_refused(self):
        nodes, weights, _ = layers()
        self.assertIn("input 'seen' has 7 numbers, and there are 6 features",
                      self.refusal(model(nodes, weights, size=7)))
        weights.update(w2=numbers(5, 3), b2=numbers(3))
        self.assertIn("output 'scores' has 3 numbers, and there are 4 actions",
                      self.refusal(model(nodes, weights)))

    def test_networks_with_another_input_are_refused(self):
        nodes, weights, expected = layers()
        content = joined(model(nodes, weights), inputs=[("action_masks", ACTIONS)])
        self.check(self.read(content), expected)  # nothing reads it
        for size in (0, ACTIONS, FEATURES):
            for others, said in (
                    (["action_masks"], "reads two inputs, 'seen' and 'action_masks'"),
                    (["action_masks", "h"], "reads 3 inputs, 'seen', 'action_masks' and 'h'")):
                nodes[0] = node("Concat", ["seen", *others], "sum", axis=1)
                content = joined(model(nodes, weights), inputs=[(one, size) for one in others])
                self.assertTrue(self.refusal(content).endswith(f"model.onnx: {said}"))

    def test_networks_of_sizes_that_no_match_takes_are_refused(self):
        doubled = [node("Concat", [f"x{i}"] * 2, f"x{i + 1}", axis=1) for i in range(60)]
        doubled[0] = node("Concat", ["seen", "seen"], "x1", axis=1)
        weights = {"w": numbers(FEATURES, 0), "v": numbers(0, ACTIONS)}
        for nodes, said in (
                (doubled + [node("Identity", ["x60"], "scores")],
                 "Concat 'x14_node': makes 98304 numbers, and a match takes 1 to 65536"),
                ([node("MatMul", ["seen", "w"], "empty"), node("MatMul", ["empty", "v"], "scores")],
                 "MatMul 'empty_node': makes 0 numbers, and a match takes 1 to 65536")):
            self.assertIn(f"model.onnx: {said}", self.refusal(model(nodes, weights)))
        self.assertEqual(len(self.read(self.chain(100, FEATURES)).steps), 100)
        self.assertIn("has 101 steps, and a match plays 1 to 100",
                      self.refusal(self.chain(101, FEATURES)))

    def test_networks_of_more_weights_than_a_match_takes_are_refused(self):
        self.assertIn("has 16804868 weights, and a match takes at most 16777216",
                      self.refusal(self.chain(18, 1024)))
        layer = [network.Step("layer", "dense", ["features"], width=4096)]
        self.assertEqual(network.shapes(layer, 4095), [[(4095, 4096), (4096,)]])  # as many as fit
        with self.assertRaisesRegex(PolicyError, "has 16781312 weights"):
            network.shapes(layer, 4096)
        nodes, weights, _ = layers()
        del weights["w1"]
        self.assertIn("Gemm 'sum_node': weights (8192, 4096), and a match takes at most 16777216",
                      self.refusal(joined(model(nodes, weights),
                                          [typed("w1", (8192, 4096), 1, b"")])))
        with mock.patch.object(onnx_import, "_MOST_BUILT", 30 * 100):
            self.assertEqual(len(self.read(self.chain(50, 5)).steps), 50)
            self.assertIn("layers up to here have more than 3000 weights",
                          self.refusal(self.chain(51, 8)))

    def test_the_limits_are_those_of_the_engine(self):
        header = (SOURCES / "training/policy/network.h").read_text()
        for name, value in (("kMaxSteps", str(network.MAX_STEPS)), ("kMaxNumbers", "1 << 16"),
                            ("kMaxWeights", "1 << 24")):
            self.assertRegex(header, rf"\b{name} = {value};")
        self.assertEqual((network.MAX_NUMBERS, network.MAX_WEIGHTS), (1 << 16, 1 << 24))

    def chain(self, count, width):
        """As many layers, which share their weights."""
        names = ["seen", *(f"h{i}" for i in range(1, count)), "scores"]
        weights = {"first": numbers(FEATURES, width), "w": numbers(width, width) / width,
                   "last": numbers(width, ACTIONS)}
        which = ["first", *["w"] * (count - 2), "last"]
        return model([node("MatMul", [names[i], which[i]], names[i + 1]) for i in range(count)],
                     weights)

    def test_weights_of_other_types_or_sizes_are_refused(self):
        nodes, weights, _ = layers()
        del weights["b1"]
        for shape, kind, content, said in (
                ((5,), 16, field(9, bytes(10)), "weights of bfloat16 are not read"),
                ((5,), 8, b"", "weights of data type 8 are not read"),
                ((5,), 1, field(9, bytes(16)), "weights (5,) of 4 numbers"),
                ((1 << 62, 4), 1, b"", "and a match takes at most"),
                ((-1,), 1, field(9, bytes(20)), "weights (-1,) of a negative size"),
                ((1,) * 70, 1, field(9, bytes(4)), "weights of 70 dimensions"),
                ((1,), 6, field(5, 1 << 40), "out of its range"),
                ((1,), 10, field(5, -1), "out of its range"),
                ((1,), 10, field(5, 1 << 16), "out of its range")):
            refusal = self.refusal(joined(model(nodes, weights),
                                          [typed("b1", shape, kind, content)]))
            self.assertIn("Gemm 'sum_node': weights", refusal)
            self.assertIn(said, refusal)
        for kind, content, value in ((6, field(5, -3), -3), (10, field(5, 0x3800), 0.5)):
            net = self.read(joined(model(nodes, weights), [typed("b1", (1,), kind, content)]))
            np.testing.assert_array_equal(net.steps[0].weights[1], np.full(5, value))

    def test_weights_must_be_finite(self):
        nodes, weights, _ = layers()
        for wrong in (np.nan, np.inf, 1e38):
            weights["b2"][1] = wrong
            nodes[3] = node("Gemm", ["hidden", "w2", "b2"], "scores", beta=10.0)
            self.assertIn("weights that are not finite", self.refusal(model(nodes, weights)))

    def test_damaged_files_are_refused(self):
        content = model(*layers()[:2])
        for damaged in (b"", b"PK", content[:40], field(1, 8)):
            self.assertIn("is not an ONNX model", self.refusal(damaged))
        with self.assertRaisesRegex(PolicyError, "absent.onnx: No such file"):
            from_onnx(self.folder / "absent.onnx", ABOUT)
        for at in range(0, len(content), 3):
            changed = bytearray(content)
            changed[at] ^= 1 << at % 8
            with contextlib.suppress(PolicyError):
                self.read(bytes(changed))

    def test_graphs_without_sense_are_refused(self):
        nodes, weights, _ = layers()
        tail = nodes[1:]
        loop = [node("Softmax", [f"x{1 - i}"], f"x{i}") for i in (0, 1)]
        chain = [node("Softmax", [f"x{i}"], f"x{i + 1}") for i in range(5000)]
        for wrong, output, said in (
                ([node("Constant", [], "sum"), *tail], "scores", "has a value that is not read"),
                ([node("Softmax", [], "scores")], "scores", "has no input"),
                ([node("Softmax", ["scores"], "scores")], "scores", "reads what follows from it"),
                (loop, "x1", "reads what follows from it"),
                (chain, "x5000", "no node computes an output 'x0'"),
                ([node("Relu", ["scores"], "scores")], "scores",
                 "nothing computes 'scores' before"),
                ([*nodes, nodes[0]], "scores", "it computes 'sum' twice"),
                ([node("Concat", ["seen"], "sum"), *tail], "scores", "not along the numbers"),
                ([node("Cast", ["seen"], "sum"), *tail], "scores", "is not to float or double"),
                ([node("Gemm", ["seen", "w1"], "sum", transB=1, alpha=[1, 2]), *tail], "scores",
                 "is damaged"),
                ([node("Gemm", ["seen", "w1", "b1"], "", "sum"), *tail], "scores",
                 "nothing computes 'sum'")):
            self.assertIn(said, self.refusal(model(wrong, weights, outputs=[output])))

    def test_a_want_of_memory_is_told(self):
        content = model(*layers()[:2])
        for failing in ("read", "_steps_to"):
            with mock.patch.object(onnx_import, failing, side_effect=MemoryError):
                self.assertIn("takes more memory than there is", self.refusal(content))
        with mock.patch.dict(onnx_import._HANDLERS, Gemm=mock.Mock(side_effect=MemoryError)):
            self.assertIn("takes more memory than there is", self.refusal(content))

    def test_names_of_a_file_are_printed_without_control_characters(self):
        hostile = "\x1b[31m\r\u202e\n"
        nodes, weights, _ = layers()
        nodes[1] = node(hostile, ["sum"], "hidden")
        content = model(nodes, weights, outputs=["scores", hostile])
        shown = r"\x1b[31m\r\u202e\n"
        self.assertIn(f"model.onnx: {shown} 'hidden_node': is not one of", self.refusal(content))
        self.assertIn(f"outputs: scores, {shown}", self.refusal(content, output="none"))
        nodes[1] = node("x" * 5000, ["sum"], "hidden")
        self.assertLess(len(self.refusal(model(nodes, weights))), 1100)


class Frameworks(OnnxFiles):
    """Files of exporters, and their meaning by other programs where these are installed."""

    def module(self, name):
        try:
            return importlib.import_module(name)
        except ImportError:
            self.skipTest(f"no {name}")

    def test_exports_of_torch_compute_what_torch_did(self):
        stored = np.load(FIXTURES / "torch_onnx.npz")
        for name in EXPORTS:
            net = from_onnx(FIXTURES / name, ABOUT)
            self.assertEqual(self.kinds(net)[-3:],
                             [("dense", "tanh"), ("dense", "relu"), ("dense", "none")])
            np.testing.assert_allclose(net.scores(stored["seen"]), stored["scores"], atol=3e-6)

    def test_the_reference_of_onnx_computes_the_same(self):
        evaluator = self.module("onnx.reference").ReferenceEvaluator
        parse = self.module("onnx").load_model_from_string
        for activation in ("Tanh", "Relu"):
            content = model(*layers(activation)[:2])
            expected = evaluator(parse(content)).run(None, {"seen": SEEN})[0]
            np.testing.assert_allclose(self.read(content).scores(SEEN), expected, atol=3e-6)

    def test_onnxruntime_computes_the_same(self):
        runtime = self.module("onnxruntime")
        for activation in ("Tanh", "Relu"):
            content = model(*layers(activation)[:2])
            session = runtime.InferenceSession(content, providers=["CPUExecutionProvider"])
            expected = session.run(None, {"seen": SEEN})[0]
            np.testing.assert_allclose(self.read(content).scores(SEEN), expected, atol=3e-6)

    def test_a_module_of_torch_is_exported_and_read(self):
        torch = self.module("torch")
        self.module("onnx")
        module = torch.nn.Sequential(torch.nn.Linear(FEATURES, 8), torch.nn.Tanh(),
                                     torch.nn.Linear(8, ACTIONS))
        seen = torch.from_numpy(SEEN)
        path = self.folder / "exported.onnx"
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            torch.onnx.export(module, (seen,), str(path), dynamo=False)
        expected = module(seen).detach().numpy()
        np.testing.assert_allclose(from_onnx(path, ABOUT).scores(SEEN), expected, atol=3e-6)


class Command(OnnxFiles):
    def test_writes_a_policy_of_a_match(self):
        weights = {"w": numbers(817, 84), "b": numbers(84)}
        path, out = self.folder / "model.onnx", self.folder / "mine.policy"
        path.write_bytes(model([node("Gemm", ["seen", "w", "b"], "scores")], weights, size=817))
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            self.assertEqual(onnx_import.main([str(path), str(out), "--decides", "all"]), 0)
        self.assertEqual(printed.getvalue(), f"{out}: dense 84\n")
        net = network.load(out)
        self.assertEqual((net.about["decides"], net.about["features"]), ("all", "team"))
        np.testing.assert_array_equal(net.steps[0].weights[0], weights["w"])


def write_exports():
    """A network of PyTorch with normalization, batch normalization and a second output."""
    import onnx
    import torch

    class Actor(torch.nn.Module):
        def __init__(self):
            super().__init__()
            self.register_buffer("mean", torch.linspace(-1, 1, FEATURES))
            self.register_buffer("deviation", torch.linspace(1, 2, FEATURES))
            normalization = torch.nn.BatchNorm1d(5)
            normalization.running_mean.copy_(torch.linspace(-0.5, 0.5, 5))
            normalization.running_var.copy_(torch.linspace(0.5, 1.5, 5))
            self.scores = torch.nn.Sequential(
                torch.nn.Flatten(), torch.nn.Linear(FEATURES, 8), torch.nn.Tanh(),
                torch.nn.Linear(8, 5), normalization, torch.nn.ReLU(), torch.nn.Dropout(),
                torch.nn.Linear(5, ACTIONS, bias=False))
            self.value = torch.nn.Linear(FEATURES, 1)

        def forward(self, seen):
            seen = (seen - self.mean) / self.deviation
            return self.scores(seen), self.value(seen)

    torch.manual_seed(7)
    actor, seen = Actor().eval(), torch.randn(3, FEATURES)
    for name, newer in EXPORTS.items():
        options = {"external_data": False} if newer else {"dynamic_axes": {"seen": {0: "batch"}}}
        torch.onnx.export(actor, (seen,), str(FIXTURES / name), dynamo=newer, input_names=["seen"],
                          output_names=["scores", "value"], **options)
        exported = onnx.load(FIXTURES / name)
        for one in [exported, exported.graph, *exported.graph.node, *exported.graph.input,
                    *exported.graph.output, *exported.graph.initializer,
                    *exported.graph.value_info]:
            del one.metadata_props[:]  # stack traces
        onnx.save(exported, FIXTURES / name)
    np.savez(FIXTURES / "torch_onnx.npz", seen=seen.numpy(),
             scores=actor(seen)[0].detach().numpy())


if __name__ == "__main__":
    if "--write" in sys.argv:
        write_exports()
    else:
        unittest.main()

"""Neural networks as ONNX files. The format is Protocol Buffers: numbered fields, with the numbers of onnx.proto."""

import numpy as np

FLOAT, DOUBLE = 1, 11
SIGNATURE, HIDDEN, FEATURES = 100, 24, 12


def _varint(value):
    """A whole number >= 0 in groups of 7 bits, the lowest first."""
    groups = []
    while True:
        value, low = value >> 7, value & 127
        groups.append(low | (128 if value else 0))
        if not value:
            return bytes(groups)


def _field(number, value):
    """A field with a whole number, a text or a message."""
    if isinstance(value, int):
        return _varint(number << 3) + _varint(value)
    content = value.encode() if isinstance(value, str) else value
    return _varint(number << 3 | 2) + _varint(len(content)) + content


def _attribute(name, value):
    """One whole number, or a list of them."""
    if isinstance(value, int):
        return _field(1, name) + _field(3, value) + _field(20, 2)
    return _field(1, name) + b"".join(_field(8, each) for each in value) + _field(20, 7)


def _node(operation, inputs, output, attributes):
    return b"".join([_field(1, name) for name in inputs] + [_field(2, output), _field(4, operation)] +
                    [_field(5, _attribute(*each)) for each in attributes.items()])


def _value(name, sizes, kind):
    """An input or output; a size that is a text is open."""
    dimensions = b"".join(_field(1, _field(1 if isinstance(size, int) else 2, size)) for size in sizes)
    return _field(1, name) + _field(2, _field(1, _field(1, kind) + _field(2, dimensions)))


def _tensor(name, values):
    values = np.asarray(values, dtype="<f4")
    return b"".join(_field(1, size) for size in values.shape) + _field(2, FLOAT) + _field(8, name) + \
        _field(9, values.tobytes())


def network(nodes, inputs, outputs, constants=None, kind=FLOAT):
    """The bytes of an ONNX file.

    nodes: (operation, inputs, output, attributes). inputs, outputs: sizes by name. constants: arrays by name.
    kind: of the numbers of inputs and outputs.
    """
    graph = b"".join(
        [_field(1, _node(*node)) for node in nodes] + [_field(2, "network")] +
        [_field(5, _tensor(*each)) for each in (constants or {}).items()] +
        [_field(11, _value(name, sizes, kind)) for name, sizes in inputs.items()] +
        [_field(12, _value(name, sizes, kind)) for name, sizes in outputs.items()])
    version, operations = 7, 11
    return _field(1, version) + _field(7, graph) + _field(8, _field(1, "") + _field(2, operations))


def random_features():
    """A network that describes points, of the kind that is trained elsewhere.

    Its weights are random. Its output depends on the heat and wave kernel signatures alone, so bending a surface
    changes it little.
    """
    rng = np.random.default_rng(2)

    def layer(columns, rows):
        """Weights and biases that keep the size of random inputs."""
        return rng.standard_normal((rows, columns)) / np.sqrt(columns), 0.1 * rng.standard_normal(rows)

    first, first_bias = layer(2 * SIGNATURE, HIDDEN)
    second, second_bias = layer(HIDDEN, FEATURES)
    return (network(
        [("Concat", ["HeatKernelSignature", "WaveKernelSignature"], "signatures", {"axis": 1}),
         ("Gemm", ["signatures", "first", "first_bias"], "hidden", {"transB": 1}),
         ("Relu", ["hidden"], "active", {}),
         ("Gemm", ["active", "second", "second_bias"], "Features", {"transB": 1})],
        {name: ["points", SIGNATURE] for name in ("HeatKernelSignature", "WaveKernelSignature")},
        {"Features": ["points", FEATURES]},
        {"first": first, "first_bias": first_bias, "second": second, "second_bias": second_bias}),)

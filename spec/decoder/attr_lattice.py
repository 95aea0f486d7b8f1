"""Attributes on lattices: attr_lattice.md, ATTR-55 to ATTR-59."""
import math
import struct
from itertools import groupby

import numpy as np

from coder import BitModel, Coder, NumberModel, clamp
from container import must, unzigzag
from floats import FLT_1_bits, FloatCoder
from lattice import POSN_8_table, PredictedCoder

CONSTANT, AS_BEFORE, TIMES, RATIO, LISTED, FLOAT = range(6)

class Component:
    """[ATTR-55]"""
    def __init__(self, r, a, before):
        self.type, size, self.kind = a.type, int(a.type[1]), r.u8()
        self.times, self.over, self.cells = 1.0, 1.0, 0
        must(self.kind <= FLOAT, "ATTR-55", f"kind {self.kind}")
        must(self.kind != FLOAT or self.type == "f4", "ATTR-55", f"floats of type {self.type}")
        must(self.kind != AS_BEFORE or before, "ATTR-55", "the first component is as none before")
        if self.kind in (CONSTANT, LISTED):
            self.cells = r.varint(4096, "CON-2") - 1 if self.kind == LISTED else 0
            must(self.cells >= 0, "ATTR-55", "an empty list")
            self.list = [r.bytes(size) for _ in range(self.cells + 1)]
            self.rest = next((i for i, value in enumerate(self.list) if not any(value)), 0)  # [ATTR-59]
        elif self.kind == FLOAT:
            self.exponent = r.u8()
            must(self.exponent <= 254, "ATTR-55", f"exponent {self.exponent}")
        else:
            if self.kind == AS_BEFORE:
                self.times, self.over = before.times, before.over
            else:
                self.times, self.over = r.number("f"), r.number("f") if self.kind == RATIO else 1.0
            must(0 < self.times < math.inf, "ATTR-55", f"times {self.times}")
            must(0 < self.over < math.inf, "ATTR-55", f"over {self.over}")
            self.base = unzigzag(r.varint(2**53, "CON-2"))
            self.cells = r.varint(2**28, "CON-2")
            self.rest = clamp(-self.base, 0, self.cells)
            ends = np.frombuffer(self.value(0) + self.value(self.cells), dtype="<" + self.type)
            must(np.all(np.isfinite(ends)), "ATTR-55", "a point is not finite")

    def value(self, q):
        """The bytes of the value that q stands for."""
        if self.kind in (CONSTANT, LISTED):
            return self.list[q]
        if self.kind == FLOAT:
            return struct.pack("<I", FLT_1_bits(q))
        x = float(self.base + q) * self.times / self.over
        if self.type[0] != "f":
            x = clamp(math.floor(x + 0.5), np.iinfo(self.type).min, np.iinfo(self.type).max)
        return np.array(x).astype("<" + self.type).tobytes()

def ATTR_55_lattice(r, a, surface):
    components = []
    for _ in range(a.k):
        components.append(Component(r, a, components[-1] if components else None))
        components[-1].numbers = [0] * surface.n
    varying = [c for c in components if c.kind != CONSTANT]
    if varying:
        coder = Coder(r)
        first, known = surface.joined(coder.raw(1))
        while varying:  # [ATTR-56] groups
            group = list(next(groupby(varying, lambda c: c.kind == FLOAT))[1])[:3]
            varying = varying[len(group):]
            for c, column in zip(group, ATTR_56_group(coder, group, first, known)):
                must(c.kind == FLOAT or all(0 <= q <= c.cells for q in column), "ATTR-56", "a number above its cells")
                c.numbers = column
    data = b"".join(c.value(c.numbers[v]) for v in range(surface.n) for c in components)
    return np.frombuffer(data, dtype="<" + a.type)

def ATTR_56_group(coder, group, first, known):
    """[ATTR-57] The columns of x, y and z."""
    width, resting = len(group), None
    if group[0].kind == FLOAT:
        units, width = [max(c.exponent, 1) - 153 for c in group] + [1 - 153] * (3 - width), 3
        lattice = FloatCoder(coder, known, units)
    else:
        lattice = PredictedCoder(coder, known, POSN_8_table(coder), [c.cells for c in group], coder.raw(1))
        lattice.rule = "ATTR-56"
        resting = Resting(coder, lattice, [c.rest for c in group], first[-1]) if coder.raw(1) else None
    return list(zip(*ATTR_58_copies(coder, first, lattice.decode, width, resting))) or [[]] * 3

class Resting:
    """[ATTR-59] Runs of vertices at rest."""
    def __init__(self, coder, lattice, rest, n):
        self.coder, self.lattice, self.rest, self.n, self.model, self.end = coder, lattice, rest, n, NumberModel(), None

    def length(self, row, v):
        """Of the run from vertex `row` on, the first copy of v."""
        around = self.lattice.known[v].corners[:4] or ([v - 1] if v else [])
        if row == self.end or any(self.lattice.rows[u] != self.rest for u in around):
            return 0
        length = self.model.decode(self.coder)
        must(length <= self.n - row, "ATTR-56", f"{length} vertices at rest")
        self.end = row + length
        return length

    def keep(self, v):
        self.lattice.rows[v], self.lattice.sizes[v], self.lattice.residuals[v] = self.rest, [0] * 3, [0] * 3

def ATTR_58_copies(coder, first, decode, width, resting=None):
    """The rows of all vertices; `decode(v)` reads those of first copies."""
    rows, same, last, models = [], [BitModel(), BitModel()], 1, [NumberModel() for _ in range(width)]
    for g in range(len(first) - 1):
        if resting and first[g] == len(rows):
            rows += [resting.rest] * resting.length(len(rows), g)
        if first[g] < len(rows):
            resting.keep(g)
        else:
            rows.append(list(decode(g)))
        while len(rows) < first[g + 1]:
            row, last = list(rows[-1]), same[last].decode(coder)
            if not last:
                for i in range(width):
                    row[i] = (row[i] + unzigzag(models[i].decode(coder)) + 2**31) % 2**32 - 2**31
            rows.append(row)
    return rows

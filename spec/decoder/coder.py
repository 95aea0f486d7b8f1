"""The coder and the models of the compact coding: compact.md, rules CMP."""
import copy
from bisect import bisect_right
from collections import defaultdict
from logging import debug
from types import SimpleNamespace

from container import must

WEIGHT_SUM, NUMBER_WEIGHTS = 32994, (8, 8, 8, 8, 7, 6, 5, 4, 3, 2, 2, 1, 1, 1, 1, 1)

def bits(x):
    return x.bit_length()

def clamp(x, low, high):
    return min(max(x, low), high)

def divide(a, b):
    """The quotient cut towards 0."""
    return abs(a) // abs(b) * (1 if (a < 0) == (b < 0) else -1)

def log4(y):  # POSN-6, FLD-15, ATTR-37, ATTR-52
    """4 floor(log2 y) plus the two bits below the leading one of y."""
    return 4 * bits(y) - 4 + (4 * y >> (bits(y) - 1) & 3)

class SymbolModel:
    """[CMP-4, CMP-5]"""
    def __init__(self, weights):
        self.lanes, self.counter = [sum(weights[:i + 1]) * 32512 // sum(weights) for i in range(16)], 0

    def learn(self, s):  # CMP-5
        n, lanes = self.counter, self.lanes
        rate = 2 if n < 2 else 3 if n < 10 else 4 if n < 26 else 5 if n < 58 else 6 if n < 122 else 7
        goal = 32512 + 2**rate - 1
        self.lanes = [x + (-x >> rate) for x in lanes[:s]] + [x + ((goal - x) >> rate) for x in lanes[s:]]
        self.counter = min(n + 1, 122)

class BitModel:
    """[CMP-7]"""
    def __init__(self, start=32768):
        self.f = self.g = start

    def decode(self, coder):
        p = clamp((self.f + self.g) >> 2, 32, 32736)
        bit = coder.slot() < p
        coder.take(*((0, p) if bit else (p, 2**15 - p)))
        self.f += (65535 * bit - self.f) >> 4
        self.g += (65535 * bit - self.g) >> 7
        return int(bit)

class CountedBit:
    """[GRD-2]"""
    def __init__(self, first=32768):
        self.f, self.counter = first, 0

    def decode(self, coder):
        p = clamp(self.f >> 1, 32, 32736)
        bit = coder.slot() < p
        coder.take(*((0, p) if bit else (p, 2**15 - p)))
        self.f += (65535 * bit - self.f) >> (min(bits(self.counter + 1), 6) if self.counter < 80 else 7)
        self.counter += 1
        return int(bit)

class Fresh(dict):
    """[CMP-4, GRD-2] Models by their numbers, each of which begins as `make` of the number says."""
    def __init__(self, make):  # CMP-4, GRD-2
        self.make = make

    def __missing__(self, number):  # CMP-4, GRD-2
        return self.setdefault(number, self.make(number))

def symbol_models(weights):  # CMP-4
    return defaultdict(lambda: SymbolModel(weights))

def bit_models():  # CMP-7
    return defaultdict(BitModel)

class Mixture:
    """[CMP-6] Two tables of models, and sets of weights."""
    def __init__(self, weights):
        self.models, self.weights = symbol_models(weights), defaultdict(lambda: [WEIGHT_SUM // 2] * 2)

    def of(self, first, second, weights):
        """Models and weights of these indices."""
        return [self.models[0, first], self.models[1, second]], self.weights[weights]

class Coder:
    """[CMP-1 to CMP-3, CMP-6, CMP-12] Reads the decisions of one stream, all that a reader has left."""
    def __init__(self, r):
        self.data, r.coder = r.rest(), self
        must(self.data, "CMP-1", "no sizes of states")
        must(max(self.data[0] & 15, self.data[0] >> 4) <= 8, "CMP-1", "a state of more than 8 bytes")
        middle = 1 + (self.data[0] & 15)
        self.at, self.turn = middle + (self.data[0] >> 4), 0
        must(self.at <= len(self.data), "CMP-1", "the states are cut")
        self.states = [int.from_bytes(part, "little") for part in (self.data[1:middle], self.data[middle:self.at])]
        must(all(2**15 <= s < 2**63 for s in self.states), "CMP-1", "a state is out of range")

    def refill(self):
        """[CMP-2] A word where the state is low; then it is the other state's turn."""
        state = self.states[self.turn]
        if state < 2**31 and self.at + 4 <= len(self.data):
            self.states[self.turn] = state << 32 | int.from_bytes(self.data[self.at:self.at + 4], "little")
            self.at += 4
        must(self.states[self.turn] >= 2**15, "CMP-3", "the stream ends within its decisions")
        self.turn ^= 1

    def slot(self):  # CMP-2
        return self.states[self.turn] & 0x7fff

    def take(self, start, size):
        """[CMP-2] Ends a decision whose interval is [start, start + size)."""
        state = self.states[self.turn]
        debug("decision: state %s %s, interval %s + %s", self.turn, state, start, size)
        self.states[self.turn] = size * (state >> 15) + (state & 0x7fff) - start
        self.refill()

    def shift_out(self, n):  # CMP-2, CMP-12
        state = self.states[self.turn]
        self.states[self.turn] = state >> n
        debug("bits: %s of state %s %s", n, self.turn, state)
        return state & (2**n - 1)

    def raw(self, n):
        """[CMP-2] n raw bits."""
        if n > 16:
            low = self.raw(16)
            return low | self.raw(n - 16) << 16
        value = self.shift_out(n)
        self.refill()
        return value

    def find(self, models, weights):
        """[CMP-6] The symbol whose interval holds the slot, and the interval."""
        ends = [2 * (i + 1) + (sum(m.lanes[i] * w for m, w in zip(models, weights)) >> 15) for i in range(15)]
        ends = [0] + ends + [2**15]
        s = bisect_right(ends, self.slot()) - 1
        return s, ends[s], ends[s + 1] - ends[s]

    def learn(self, models, weights, s, size):
        """[CMP-6] What weights and models learn from symbol s, whose interval has this size."""
        debug("symbol: %s by weights %s of models %s", s, weights, [model.lanes for model in models])
        if len(models) == 2:
            lanes, w = models[0].lanes, weights[0]
            p = lanes[s] - (lanes[s - 1] if s else 0)
            w += (((w * p * (16256519 // size)) >> 24) + 512 - w) >> 5
            weights[:] = w, WEIGHT_SUM - w
        for model in models:
            model.learn(s)

    def symbol(self, models, weights=(WEIGHT_SUM,)):
        """[CMP-6] A symbol by a mixture; without weights that of one model."""
        s, start, size = self.find(models, weights)
        self.take(start, size)
        self.learn(models, weights, s, size)
        return s

    def CMP_12_symbol(self, models, weights, c, estimates):
        """A symbol with c bits below it: (symbol, bits)."""
        if c == 0:
            return self.symbol(models, weights), 0
        low = self.shift_out(c - 1)
        s, start, size = self.find(models, weights)
        parts = 1 + (((size - 2) * estimates[s]) >> 16)
        is_set = self.slot() < start + parts
        self.take(*((start, parts) if is_set else (start + parts, size - parts)))
        estimates[s] += (65535 * is_set - estimates[s]) >> 6
        self.learn(models, weights, s, size)
        return s, low | int(is_set) << (c - 1)

    def CMP_3_end(self):
        must(self.at == len(self.data), "CMP-3", f"{len(self.data) - self.at} bytes are left over")
        must(self.states in ([2**15] * 2, [2**31] * 2), "CMP-3", f"the states end as {self.states}")

class NumberModel:
    """[CMP-8]"""
    def __init__(self):
        self.length, self.bits = SymbolModel(NUMBER_WEIGHTS), bit_models()

    def decode(self, coder):
        length = coder.symbol([self.length])
        length = min(15 + coder.raw(5), 32) if length == 15 else length
        value = min(length, 1)
        for i in range(min(length - 1, 2)):
            value = value * 2 + self.bits[length, i, value].decode(coder)
        return value << (length - 3) | coder.raw(length - 3) if length > 3 else value

class ScaledCoder(Mixture):
    """[CMP-15] Numbers of one set, with all their mixtures."""
    def __init__(self):
        super().__init__((1, 2, 3, 4, 8, 14, 24, 40, 24, 14, 8, 4, 3, 2, 1, 3))
        self.estimates, self.below, self.excess = [2**15] * 16, BitModel(), NumberModel()

    def CMP_15_number(self, coder, first, second, weights, shift):
        c = min(shift, 17)
        s, low = coder.CMP_12_symbol(*self.of(first, second, weights), c, self.estimates)
        h = s - 7
        if s == 15:
            is_below, size = self.below.decode(coder), 8 + self.excess.decode(coder)
            h = -size if is_below else size
        x = (h << c) + low
        return (x << (shift - c)) + coder.raw(shift - c) if shift > c else x

class States:
    """[CMP-16] `before` has the models that another stream left, by what they are of, or is None; `after` those of this stream."""
    def __init__(self, before=None):
        self.before, self.after = before or {}, {}

    def models(self, of, **fresh):
        """The models with which a coder begins; it learns in place."""
        copies = {}  # of all that the models are made of
        self.after[of] = copy.deepcopy(self.before.get(of, SimpleNamespace(**fresh)), copies)
        for model in copies.values():
            if hasattr(model, "counter"):
                model.counter = min(model.counter, 26)
        return self.after[of]

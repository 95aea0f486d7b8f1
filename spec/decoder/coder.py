"""The coder and the models of the compact coding: compact.md, rules CMP."""
from container import must

WEIGHT_SUM = 32994
NUMBER_WEIGHTS = (8, 8, 8, 8, 7, 6, 5, 4, 3, 2, 2, 1, 1, 1, 1, 1)


def bits(x):
    return x.bit_length()


def clamp(x, low, high):
    return min(max(x, low), high)


def CMP_9_ratio(a, b):
    w = bits(b)
    t = b >> (w - 10) if w >= 10 else b << (10 - w)
    return clamp((a * (2**25 // t)) >> (w + 3), -2**15, 2**15)


class SymbolModel:
    """[CMP-4, CMP-5]"""

    def __init__(self, weights):
        total, so_far, self.lanes, self.counter = sum(weights), 0, [], 0
        for w in weights:
            so_far += w
            self.lanes.append(so_far * 32512 // total)

    def learn(self, s):
        n = self.counter
        rate = 2 if n < 2 else 3 if n < 10 else 4 if n < 26 else 5 if n < 58 else 6 if n < 122 else 7
        goal = 32512 + 2**rate - 1
        lanes = self.lanes
        self.lanes = [x + (-x >> rate) for x in lanes[:s]] + [x + ((goal - x) >> rate) for x in lanes[s:]]
        self.counter = min(n + 1, 122)


class BitModel:
    """[CMP-7]"""

    def __init__(self, start=32768):
        self.f = self.g = start

    def decode(self, coder):
        p = clamp((self.f + self.g) >> 2, 32, 32736)
        bit = coder.slot() < p
        coder.take(0, p) if bit else coder.take(p, 2**15 - p)
        goal = 65535 if bit else 0
        self.f += (goal - self.f) >> 4
        self.g += (goal - self.g) >> 7
        return int(bit)


class Models(dict):
    """A table of models that are made when they are first used."""

    def __init__(self, make):
        super().__init__()
        self.make = make

    def __missing__(self, key):
        model = self[key] = self.make()
        return model


def symbol_models(weights):
    return Models(lambda: SymbolModel(weights))


def mixing_weights(count):
    """[CMP-6] The first weights of mixtures of so many models."""
    each = WEIGHT_SUM // count
    return Models(lambda: [each] * (count - 1) + [WEIGHT_SUM - each * (count - 1)])


def bit_models(start=32768):
    return Models(lambda: BitModel(start))


class Coder:
    """[CMP-1 to CMP-3, CMP-6, CMP-12] Reads the decisions of one stream."""

    def __init__(self, data):
        must(len(data) >= 1, "CMP-1", "no byte of sizes")
        sizes = [data[0] & 15, data[0] >> 4]
        must(max(sizes) <= 8 and len(data) >= 1 + sum(sizes), "CMP-1", "states are cut or too long")
        at = 1 + sizes[0]
        self.states = [int.from_bytes(data[1:at], "little"), int.from_bytes(data[at:at + sizes[1]], "little")]
        must(all(2**15 <= s < 2**63 for s in self.states), "CMP-1", "a state is out of range")
        self.data, self.at, self.turn = data, at + sizes[1], 0

    def refill(self):
        """[CMP-2] A word where the state is low; then the other state's turn begins."""
        if self.states[self.turn] < 2**31:
            if self.at + 4 <= len(self.data):
                word = int.from_bytes(self.data[self.at:self.at + 4], "little")
                self.states[self.turn] = self.states[self.turn] << 32 | word
                self.at += 4
            else:
                must(self.states[self.turn] >= 2**15, "CMP-3", "the stream ends within its decisions")
        self.turn ^= 1

    def slot(self):
        return self.states[self.turn] & 0x7fff

    def take(self, start, size):
        """[CMP-2] Ends a decision whose interval is [start, start + size)."""
        state = self.states[self.turn]
        self.states[self.turn] = size * (state >> 15) + (state & 0x7fff) - start
        self.refill()

    def shift_out(self, n):
        state = self.states[self.turn]
        self.states[self.turn] = state >> n
        return state & (2**n - 1)

    def raw(self, n):
        """[CMP-2] n raw bits."""
        if n > 16:
            low = self.raw(16)
            return low | self.raw(n - 16) << 16
        value = self.shift_out(n)
        self.refill()
        return value

    def CMP_10_below(self, limit):
        value = ((self.slot() + 1) * limit - 1) >> 15
        start = 2**15 * value // limit
        self.take(start, 2**15 * (value + 1) // limit - start)
        return value

    def find(self, models, weights):
        """[CMP-6] The symbol whose interval holds the slot, and the interval."""
        def end(i):
            if i == 15:
                return 2**15
            return 2 * (i + 1) + sum((2 * m.lanes[i] * w) >> 16 for m, w in zip(models, weights))
        slot, low, high = self.slot(), 0, 15
        while low < high:
            middle = (low + high) // 2
            low, high = (low, middle) if slot < end(middle) else (middle + 1, high)
        start = end(low - 1) if low else 0
        return low, start, end(low) - start

    def learn(self, models, weights, s, size, weigh=True):
        """[CMP-6] What weights and models learn from symbol s, whose interval has this size."""
        k = len(models)
        if k > 1 and weigh:
            inverse = ((WEIGHT_SUM - 512 * k) * 2**24 // WEIGHT_SUM) // (size + k - 2)
            for i in range(k - 1):
                lanes = models[i].lanes
                p = lanes[s] - (lanes[s - 1] if s else 0)
                weights[i] += (((weights[i] * p * inverse) >> 24) + 512 - weights[i]) >> 5
            weights[k - 1] = WEIGHT_SUM - sum(weights[:k - 1])
        for model in models:
            model.learn(s)

    def symbol(self, models, weights=(WEIGHT_SUM,), weigh=True):
        """[CMP-6] A symbol by a mixture; without weights that of one model."""
        s, start, size = self.find(models, weights)
        self.take(start, size)
        self.learn(models, weights, s, size, weigh)
        return s

    def CMP_12_symbol(self, models, weights, c, estimates, weigh=True):
        """A symbol with c bits below it: (symbol, bits)."""
        if c == 0:
            return self.symbol(models, weights, weigh), 0
        low = self.shift_out(c - 1)
        s, start, size = self.find(models, weights)
        parts = 1 + (((size - 2) * estimates[s]) >> 16)
        is_set = self.slot() < start + parts
        self.take(start, parts) if is_set else self.take(start + parts, size - parts)
        estimates[s] += ((65535 if is_set else 0) - estimates[s]) >> 6
        self.learn(models, weights, s, size, weigh)
        return s, low | int(is_set) << (c - 1)

    def end(self):
        """[CMP-3]"""
        must(self.at == len(self.data), "CMP-3", f"{len(self.data) - self.at} bytes are left over")
        must(self.states[0] == self.states[1] and self.states[0] in (2**15, 2**31), "CMP-3",
             f"the states end as {self.states}")


class LowBits:
    """[CMP-8] The bits of a number below its leading one, the length being known."""

    def __init__(self):
        self.models = bit_models()

    def decode(self, coder, length):
        if length < 2:
            return length
        value = 2 + self.models[length].decode(coder)
        if length > 2:
            value = value * 2 + self.models[length, value].decode(coder)
        if length > 3:
            value = value << (length - 3) | coder.raw(length - 3)
        return value


class NumberModel:
    """[CMP-8]"""

    def __init__(self):
        self.length, self.low = SymbolModel(NUMBER_WEIGHTS), LowBits()

    def decode(self, coder):
        length = coder.symbol([self.length])
        if length == 15:
            length = min(15 + coder.raw(5), 32)
        return self.low.decode(coder, length)

"""Compact chunks whose decisions are, from one on, others than an encoder's: found by decoding with decisions of chance, which are then
encoded [CMP-1, CMP-2]."""
import sys

from reference_decoder_test import decode
from container import Broken
from coder import Coder

LOW, HIGH = 2**31, 2**62


class ChanceCoder:
    """Stands in for the methods of Coder while one stream is decoded: decisions of the chunk `payload` come from `rng` from number `first` on,
    and all of them are written down."""
    def __init__(self, payload, first, rng):
        self.payload, self.first, self.rng, self.decisions, self.kept, self.fields = payload, first, rng, [[]], None, payload
        self.real = {name: getattr(Coder, name) for name in ("slot", "take", "shift_out", "refill")}

    def is_mine(self, coder):
        """Whether the coder's stream is what the payload ends with; `fields` is what comes before."""
        if not self.payload.endswith(coder.data):
            return False
        self.fields = self.payload[:len(self.payload) - len(coder.data)]
        return True

    def is_by_chance(self):
        return len(self.decisions) > self.first

    def slot(self, coder):
        if not self.is_mine(coder) or not self.is_by_chance():
            return self.real["slot"](coder)
        if self.kept is None:
            self.kept = self.rng.choice((0, 2**15 - 1, *(self.rng.randrange(2**15) for _ in range(6))))
        return self.kept

    def take(self, coder, start, size):
        if not self.is_mine(coder):
            return self.real["take"](coder, start, size)
        self.decisions[-1].append((15, start, size))
        self.kept = None
        return self.refill(coder) if self.is_by_chance() else self.real["take"](coder, start, size)

    def shift_out(self, coder, n):
        if not self.is_mine(coder):
            return self.real["shift_out"](coder, n)
        value = self.rng.choice((0, 2**n - 1, self.rng.randrange(2**n))) if self.is_by_chance() else self.real["shift_out"](coder, n)
        self.decisions[-1].append((n, value, 1))
        return value

    def refill(self, coder):
        if not self.is_mine(coder):
            return self.real["refill"](coder)
        by_chance = self.is_by_chance()
        self.decisions.append([])
        return None if by_chance else self.real["refill"](coder)

    def run(self, stream, decode_it=decode):
        """Decodes; leaves when a rule is broken."""
        for name in self.real:
            setattr(Coder, name, lambda coder, *rest, name=name: getattr(self, name)(coder, *rest))
        try:
            decode_it(stream)
        except Broken:
            pass
        finally:
            for name, method in self.real.items():
                setattr(Coder, name, method)

    def encoded(self, ends):
        """The payload with these decisions; behind them it ends, or goes on with others of chance."""
        if self.fields == self.payload:
            return self.payload
        states, words = [2**15 if ends else self.rng.randrange(LOW, HIGH) for _ in range(2)], []
        for number in range(len(self.decisions) - 1, -1, -1):
            x, parts = states[number % 2], self.decisions[number]
            if parts and x >= parts[-1][2] << (63 - sum(n for n, _, _ in parts)):
                words.append(x % 2**32)
                x >>= 32
            for n, start, size in reversed(parts):
                x = (x // size << n) + x % size + start
            states[number % 2] = x
        sizes = [(x.bit_length() + 7) // 8 for x in states]
        return self.fields + bytes([sizes[0] | sizes[1] << 4]) + b"".join(x.to_bytes(size, "little") for x, size in zip(states, sizes)) + \
            b"".join(word.to_bytes(4, "little") for word in reversed(words))


def with_other_decisions(stream, payload, first, rng, ends=False):
    """The payload of a stream's compact chunk with other decisions from number `first` on; below 0: counted from the last. Where it `ends`, it
    does so behind the last that the decoder asks for."""
    if first < 0:
        coder = ChanceCoder(payload, sys.maxsize, rng)
        coder.run(stream)
        first = max(len(coder.decisions) - 1 + first, 0)
    coder = ChanceCoder(payload, first, rng)
    coder.run(stream)
    return coder.encoded(ends)

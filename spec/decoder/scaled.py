"""Numbers as a symbol, the bits below it, and a tail: FLD-5 and FLD-6, which POSN-6 and attributes use as well."""
from coder import LowBits, symbol_models

SYMBOL_WEIGHTS = (1, 2, 3, 4, 8, 14, 24, 40, 24, 14, 8, 4, 3, 2, 1, 3)
TAIL_WEIGHTS = (12, 8, 10, 7, 8, 5, 6, 4, 4, 3, 3, 2, 2, 1, 1, 1)

class ScaledCoder:
    """The estimates of [CMP-12] and the models of the tail [FLD-6] of one field."""
    def __init__(self):
        self.estimates, self.tails, self.low = [2**15] * 16, symbol_models(TAIL_WEIGHTS), LowBits()

    def FLD_5_number(self, coder, models, weights, shift, tail):
        c = min(shift, 17)
        s, low = coder.CMP_12_symbol(models, weights, c, self.estimates)
        h = s - 7 if s < 15 else self.FLD_6_tail(coder, tail)
        x = (h << c) + low
        return (x << (shift - c)) + coder.raw(shift - c) if shift > c else x

    def FLD_6_tail(self, coder, context):
        s = coder.symbol([self.tails[context]])
        length = s >> 1
        if length == 7:
            length = min(7 + coder.raw(5), 32)
        size = 8 + self.low.decode(coder, length)
        return -size if s & 1 else size

def FLD_5_quantity(x):
    """Q"""
    y = x + 4
    return min(4 * (y.bit_length() - 3) + ((y >> (y.bit_length() - 3)) & 3), 23)

def FLD_5_near(near, s):
    """u"""
    return sum(k <= (near * (2**20 // (s + 2))) >> 16 for k in (2, 5, 10, 16, 27))

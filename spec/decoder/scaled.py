"""Scaled numbers: CMP-15, and the classes of their contexts, which attributes use as well."""
from coder import BitModel, NumberModel

SYMBOL_WEIGHTS = (1, 2, 3, 4, 8, 14, 24, 40, 24, 14, 8, 4, 3, 2, 1, 3)

class ScaledCoder:
    """[CMP-15]"""
    def __init__(self):
        self.estimates, self.below, self.excess = [2**15] * 16, BitModel(), NumberModel()

    def CMP_15_number(self, coder, models, weights, shift):
        c = min(shift, 17)
        s, low = coder.CMP_12_symbol(models, weights, c, self.estimates)
        h = s - 7 if s < 15 else self.other(coder)
        x = (h << c) + low
        return (x << (shift - c)) + coder.raw(shift - c) if shift > c else x

    def other(self, coder):
        is_below = self.below.decode(coder)
        size = 8 + self.excess.decode(coder)
        return -size if is_below else size

def FLD_15_quantity(x):
    """Q"""
    y = x + 4
    return min(4 * (y.bit_length() - 3) + ((y >> (y.bit_length() - 3)) & 3), 23)

def ATTR_52_near(near, s):
    """e"""
    return sum(k <= (near * (2**20 // (s + 2))) >> 16 for k in (2, 5, 10, 16, 27))

"""Scaled numbers: CMP-15, and the classes of their contexts, which attributes use as well."""
from coder import BitModel, Mixture, NumberModel, bits

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

def FLD_15_quantity(x):
    """Q"""
    leading = bits(x + 4) - 3
    return min(4 * leading + ((x + 4) >> leading & 3), 23)

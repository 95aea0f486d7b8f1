"""FLT: floats to the last bit as ordinals: posn_floats.md."""
from coder import bits, clamp
from container import must
from lattice import POSN_8_table, PredictedCoder

LARGEST = 2139095039

def FLT_1_bits(ordinal):
    must(-1 - LARGEST <= ordinal <= LARGEST, "FLT-1", f"ordinal {ordinal} is that of no finite float")
    return ordinal if ordinal >= 0 else 2**31 - 1 - ordinal

def FLT_2_last_place(ordinal):
    return max(max(ordinal, -1 - ordinal) >> 23, 1) - 150

def shifted(x, by):  # FLT-2, FLT-3
    return x << by if by >= 0 else x >> -by

def FLT_2_units(ordinal, unit):
    z = max(ordinal, -1 - ordinal)
    size = min(shifted(z if z < 2**23 else z & (2**23 - 1) | 2**23, FLT_2_last_place(z) - unit), 2**27)
    return size if ordinal >= 0 else -size

def FLT_3_ordinal(u, unit):
    place = max(bits(abs(u)) - 24 + unit, -149)
    z = min(shifted(abs(u), unit - place) + (place + 149) * 2**23, LARGEST)
    return 0 if u == 0 else z if u > 0 else -1 - z

class FloatCoder(PredictedCoder):
    """[FLT-1 to FLT-4]"""
    def __init__(self, coder, known, units):
        super().__init__(coder, known, POSN_8_table(coder), [0] * 3)
        self.units, self.ordinals, self.limits = units, {}, [(-2**27, 2**27)] * 3

    def read(self, v, x):
        """[FLT-4]"""
        known, unit, expected = self.known[v], self.units[x.axis], FLT_3_ordinal(x.whole, self.units[x.axis])
        ordinal = self.FLT_4_guess(known, x, [self.ordinals[u][x.axis] for u in known.corners], expected)
        if ordinal is None:
            shift = clamp(bits(x.scale) - 6 + unit - FLT_2_last_place(expected), 0, 24)
            ordinal = expected + self.POSN_6_number(x, shift)
            FLT_1_bits(ordinal)
        self.ordinals.setdefault(v, []).append(ordinal)
        return FLT_2_units(ordinal, unit)

    def decode(self, v):  # FLT-1
        """Ordinals."""
        super().decode(v)
        return self.ordinals[v]

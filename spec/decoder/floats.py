"""FLT: floats to the last bit as ordinals."""
from coder import bits, clamp
from container import must
from lattice import Context, GuessCoder, Kept, NumberCoder, POSN_4_expect, POSN_5_coded

LARGEST = 2139095039

def FLT_1_ordinal(pattern):
    return pattern if pattern < 2**31 else -1 - (pattern - 2**31)

def FLT_1_bits(ordinal):
    must(-1 - LARGEST <= ordinal <= LARGEST, "FLT-1", f"ordinal {ordinal} is that of no finite float")
    return ordinal if ordinal >= 0 else 2**31 + -1 - ordinal

def magnitude(ordinal):
    """z"""
    return ordinal if ordinal >= 0 else -1 - ordinal

def FLT_2_last_place(z):
    return max(z >> 23, 1) - 150

def FLT_2_units(ordinal, unit):
    z = magnitude(ordinal)
    mantissa = z if z < 2**23 else z & (2**23 - 1) | 2**23
    by = FLT_2_last_place(z) - unit
    size = min(mantissa << by if by >= 0 else mantissa >> -by, 2**27)
    return size if ordinal >= 0 else -size

def FLT_3_ordinal(u, unit):
    if u == 0:
        return 0
    place = max(bits(abs(u)) - 24 + unit, -149)
    by = unit - place
    mantissa = abs(u) << by if by >= 0 else abs(u) >> -by
    z = min(mantissa + (place + 149) * 2**23, LARGEST)
    return z if u > 0 else -1 - z

class FloatCoder:
    """[FLT-1 to FLT-4] Ordinals of vertices; an axis without a unit is lacking, its ordinals are 0."""
    def __init__(self, coder, known, table, units):
        self.coder, self.known, self.table, self.units = coder, known, table, units
        self.ordinals, self.rows, self.kept = {}, {}, Kept()
        self.numbers, self.guess = NumberCoder(), GuessCoder()

    def vertex(self, v):
        """[FLT-4]"""
        known = self.known[v]
        G, R = self.kept.sums(known.faces)
        before = self.rows[v - 1] if v else [0, 0, 0]
        ordinals, row, off, places, missed = [0, 0, 0], [0, 0, 0], [], [], set()
        for a in range(3):
            unit = self.units[a]
            place, spread = POSN_4_expect(known, self.table, self.rows.__getitem__, a, before[a])
            places.append(place)
            whole = clamp((place + 8) >> 4, -2**27, 2**27)
            expected = FLT_3_ordinal(whole, unit)
            ordinal = None
            if known.faces:
                values = [self.ordinals[u][a] for x, y, _ in known.faces for u in (x, y)]
                ordinal = self.guess.decode(self.coder, a, values, expected, known, missed)
            if ordinal is None:
                missed.add(a)
                x = Context(a, place, spread, G, R[a], known.sources, POSN_5_coded(a, off), whole)
                shift = clamp(bits(x.scale) - 6 + unit - FLT_2_last_place(magnitude(expected)), 0, 24)
                ordinal = expected + self.numbers.decode(self.coder, x, shift)
                FLT_1_bits(ordinal)
            ordinals[a], row[a] = ordinal, FLT_2_units(ordinal, unit)
            off.append(row[a] - whole)
        self.ordinals[v], self.rows[v] = ordinals, row
        self.kept.keep(v, row, places, known.sources, G)

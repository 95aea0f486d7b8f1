def DELT_7_positions(large, anchors, around, of, cycles, dump):
    from delt import DELT_4_least_squares
    for c in large:
        yield c, DELT_4_least_squares(*of(c))

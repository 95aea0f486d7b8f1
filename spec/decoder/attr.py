"""ATTR: one per-vertex attribute; its descriptor, the order: attr.md."""
import math
from importlib import import_module

import numpy as np

from container import must
from graph import corners
from lattice import POSN_3_known
from plain import PLN_6_values

NORMAL, COLOUR, UV, GENERIC, TANGENT, JOINTS, WEIGHTS = range(7)
TYPES = ["i1", "u1", "i2", "u2", "i4", "u4", "f4", "f8"]
USUAL = [None, (b"NORMAL", 0, "f4", 3), (b"TANGENT", 4, "f4", 4), (b"TEXCOORD_0", 2, "f4", 2), (b"TEXCOORD_1", 2, "f4", 2),
         (b"COLOR_0", 1, "u1", 4), (b"COLOR_0", 1, "u1", 3), (b"COLOR_0", 1, "u2", 4), (b"COLOR_0", 1, "u2", 3),
         (b"COLOR_0", 1, "f4", 4), (b"COLOR_0", 1, "f4", 3), (b"JOINTS_0", 5, "u1", 4), (b"JOINTS_0", 5, "u2", 4),
         (b"WEIGHTS_0", 6, "f4", 4), (b"WEIGHTS_0", 6, "u1", 4), (b"WEIGHTS_0", 6, "u2", 4), (b"nx", 0, "f4", 3),
         (b"red", 1, "u1", 3), (b"red", 1, "u1", 4), (b"s", 2, "f4", 2), (b"vn", 0, "f4", 3), (b"vt", 2, "f4", 2)]

MEASURES = ["u1", "u2", "f4"]
# Numbers of components by kind, none for every shape; types; who decodes.
CODINGS = {4: ({NORMAL: [3]}, ["f4"], "attr_normals", "ATTR_20_normals"), 5: ({UV: [2]}, ["f4"], "attr_uvs", "ATTR_31_uvs"),
           6: ({TANGENT: [4]}, ["f4"], "attr_tangents", "ATTR_38_tangents"),
           7: ({COLOUR: [3, 4]}, MEASURES, "attr_colors", "ATTR_45_colours"), 8: ({}, [], "attr_lattice", "ATTR_55_lattice"),
           9: ({WEIGHTS: [4]}, MEASURES, "attr_skin", "ATTR_63_weights"), 10: ({JOINTS: [4]}, ["u1", "u2"], "attr_skin", "ATTR_60_joints"),
           11: ({COLOUR: [3, 4], GENERIC: [1]}, MEASURES, "attr_haar", "HAAR_6_values")}

def usual_flags(name, kind, type_):  # ATTR-1
    return int(kind in (COLOUR, WEIGHTS) and type_ != "f4") + (2 if name == b"COLOR_0" else 0)

class Attribute:
    """[ATTR-1] The descriptor; `values`, when it is decoded, is an array of n rows and k columns of `type`."""
    def __init__(self, r):
        row = r.u8()
        has_error, has_rms, row = row & 128, row & 64, row & 63
        must(row < len(USUAL), "ATTR-1", f"row {row}")
        if row:
            self.name, self.kind, self.type, self.k = USUAL[row]
            self.flags = usual_flags(self.name, self.kind, self.type)
        else:
            self.kind, type_number, self.k, self.flags = (r.u8() for _ in range(4))
            must(self.kind <= 6, "ATTR-1", f"kind {self.kind}")
            must(type_number <= 7, "ATTR-1", f"type {type_number}")
            must(1 <= self.k <= 16, "ATTR-1", f"{self.k} components")
            must(self.flags <= (3 if self.kind == COLOUR else 1), "ATTR-1", f"flags {self.flags}")
            self.type = TYPES[type_number]
            self.name = r.bytes(r.u8())
        self.error = r.f24() if has_error else 0.0
        must(0 <= self.error < math.inf, "ATTR-1", f"error {self.error}")
        self.rms = r.f24() if has_rms else 0.0
        must(0 <= self.rms < math.inf, "ATTR-1", f"rms {self.rms}")
        is_usual = (self.name, self.kind, self.type, self.k) in USUAL and self.flags == usual_flags(self.name, self.kind, self.type)
        self.is_shortest = not has_error and not has_rms and (row > 0 or not is_usual)
        self.values = None

    def is_shape(self, kind, types, counts):
        return self.kind == kind and self.type in types and self.k in counts

class Surface:
    """[ATTR-10] What attributes may know: faces over vertices, copies, positions and attributes decoded before."""
    def __init__(self, seams, positions, geometric_faces, attributes, states, known=None):
        self.faces, self.first, self.geometric, self.positions = seams.faces, seams.first, seams.geometric, positions
        self.geometric_faces, self.attributes, self.n, self.states = geometric_faces, attributes, len(seams.geometric), states
        self.corners, self.known = corners(self.faces, self.n), known

    def joined(self, is_joined):
        """[ATTR-58] Of the vertices that numbers are coded over their first copies, and what is known [POSN-3]."""
        if is_joined:
            return self.first, POSN_3_known(self.geometric_faces, len(self.first) - 1)
        return range(self.n + 1), POSN_3_known(self.faces, self.n)

def ATTR_11_decode(chunks, surface):
    """All attributes: tangents and weights after all others."""
    for chunk in sorted(chunks, key=lambda chunk: chunk.descriptor.kind in (TANGENT, WEIGHTS)):
        chunk.descriptor.values = ATTR_2_values(chunk, surface)

def ATTR_2_values(chunk, surface):
    """Rows of the attribute's type, to which numbers are rounded."""
    a = chunk.descriptor
    if chunk.is_compact:
        coding, exceptions = chunk.u8(), []
        if coding >= 128:
            coding -= 128
            exceptions = ATTR_12_exceptions(chunk, a, surface.n)
        must(coding in CODINGS, "ATTR-2", f"coding {coding}")
        shapes, types, module, decode = CODINGS[coding]
        must(not shapes or (a.type in types and a.k in shapes.get(a.kind, [])), "ATTR-2", f"coding {coding} is not of this shape")
        values = getattr(import_module(module), decode)(chunk, a, surface)
    else:
        values, exceptions = PLN_6_values(chunk, a, surface.n), []
    chunk.end()
    values = np.array(values, dtype="<" + a.type).reshape(surface.n, a.k)
    for begin, end, value in exceptions:
        values[begin:end] = value
    return values

def ATTR_12_exceptions(r, a, n):
    """Begin, end and value of each run."""
    m = r.varint(n, "CON-2")
    must(m >= 1, "ATTR-12", "no value")
    rows = np.frombuffer(r.bytes(m * a.k * int(a.type[1])), dtype="<" + a.type).reshape(m, a.k)
    count, end, runs = r.varint(n, "CON-2"), 0, []
    must(count >= 1, "ATTR-12", "no run")
    for _ in range(count):
        must(end < n, "ATTR-12", "a run beyond the last vertex")
        begin = end + r.varint(n - end - 1, "CON-2")
        end = begin + 1 + r.varint(n - begin - 1, "CON-2")
        runs.append((begin, end, rows[r.varint(m - 1, "CON-2") if m > 1 else 0]))
    return runs

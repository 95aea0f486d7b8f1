"""A whole stream to a mesh: the order of the chunks, and GEO-1."""
from collections import defaultdict

import numpy as np

from coder import States
from attr import ATTR_11_decode, Attribute, Surface
from anch import ANCH_1_read
from container import NO_CHUNK, CNT_1_stream, HIGHPASS, must
from delt import DELT_1_positions
from fgrp import FGRP_1_read
from glue import CONN_8_faces
from graph import components, neighbours
from ordr import ORDR_1_read
from posn import POSN_1_positions
from seam import SEAM_1_read

class Mesh:
    """`positions` (f32), `faces`, `groups` (or None) and `attributes` of the decoded mesh; `header`; `exact`, whether all
    decoders have the same bits of positions."""

def nothing(name, value):
    """Where intermediate values are not asked for."""

def GEO_1_round(positions):
    """Doubles to f32."""
    rounded = np.asarray(positions, dtype=np.float64).reshape(-1, 3).astype(np.float32)
    must(np.all(np.isfinite(rounded)), "GEO-1", "a coordinate is not finite")
    return rounded

def decode(data, dump=nothing, states=None):
    return decode_chunks(*CNT_1_stream(data, Attribute), states or States(), dump)

def decode_chunks(header, listed, states, dump=nothing):
    mesh = Mesh()
    mesh.header = header
    chunks = defaultdict(lambda: NO_CHUNK, {chunk.tag: chunk for chunk in listed if chunk.tag != "ATTR"})
    faces = CONN_8_faces(chunks["CONN"], header.triangles, header.geometric, states)
    around = neighbours(faces, header.geometric)
    parts = components(around)
    must(len(parts) == header.components, "HDR-7", f"{len(parts)} components in place of {header.components}")
    seams = SEAM_1_read(chunks["SEAM"], faces, header.geometric, header.vertices)
    dump("faces", faces)
    dump("seams", seams.faces)
    groups = FGRP_1_read(chunks["FGRP"], seams.faces)
    mesh.exact = header.coder != HIGHPASS
    if mesh.exact:
        positions = GEO_1_round(POSN_1_positions(chunks["POSN"], header, faces, states, dump))
    else:
        anchors = ANCH_1_read(chunks["ANCH"], header, header.geometric, parts)
        positions = GEO_1_round(DELT_1_positions(chunks, header, around, parts, anchors, dump))
    mesh.positions = positions[seams.geometric]
    known = mesh.positions if mesh.exact else None  # [ATTR-10]
    attributes = [chunk for chunk in listed if chunk.tag == "ATTR"]
    mesh.attributes = [chunk.descriptor for chunk in attributes]
    ATTR_11_decode(attributes, Surface(seams, known, faces, mesh.attributes, states))
    mesh.faces, mesh.groups = seams.faces, groups
    if header.restore_order:
        restore(mesh, *ORDR_1_read(chunks["ORDR"], seams.faces, header.vertices))
    return mesh

def restore(mesh, places, face_places, rotations):
    """[ORDR-2, ORDR-3]"""
    coded = np.argsort(np.array(places, dtype=np.int64))
    mesh.positions = mesh.positions[coded]
    for a in mesh.attributes:
        a.values = a.values[coded]
    faces, groups = [None] * len(mesh.faces), mesh.groups and [None] * len(mesh.faces)
    for i, (face, place, rotation) in enumerate(zip(mesh.faces, face_places, rotations)):
        moved = [places[v] for v in face]
        faces[place] = tuple(moved[(k - rotation) % 3] for k in range(3))
        if groups:
            groups[place] = mesh.groups[i]
    mesh.faces, mesh.groups = faces, groups

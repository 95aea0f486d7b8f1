"""A whole stream to a mesh: the order of the chunks, and GEO-1."""
from collections import defaultdict
from logging import debug

import numpy as np

from coder import States
from attr import ATTR_11_decode, Attribute, Surface
from anch import ANCH_1_read
from container import CNT_1_stream, Chunk, HIGHPASS, VOXELS, must
from delt import DELT_1_positions
from fgrp import FGRP_1_read
from glue import CONN_8_faces
from grid import GRD_12_read
from graph import components, neighbours
from ordr import ORDR_1_read
from plain import FGRP_1_plain, PLN_1_is_plain, PLN_2_faces, PLN_5_positions
from posn import POSN_1_positions
from seam import SEAM_1_read

class Mesh:
    """`positions` (f32), `faces`, `groups` (or None) and `attributes` of the decoded mesh; `header`; `exact`, whether all
    decoders have the same bits of positions; of a part of a map, `of_stream`, its positions with border vertices where its stream has them."""

def GEO_1_round(positions):
    """Doubles to f32."""
    rounded = np.asarray(positions, dtype=np.float64).reshape(-1, 3).astype(np.float32)
    must(np.all(np.isfinite(rounded)), "GEO-1", "a coordinate is not finite")
    return rounded

def decode(data):  # CNT-1
    return decode_chunks(*CNT_1_stream(data, Attribute), States())

def decode_chunks(header, listed, states, known=None):  # DIR-8, HDR-7
    mesh, attributes = Mesh(), [chunk for chunk in listed if chunk.tag == "ATTR"]
    chunks = defaultdict(Chunk, {chunk.tag: chunk for chunk in listed})
    is_plain, seams, positions = PLN_1_is_plain(header, listed), None, None
    if header.coder == VOXELS:
        faces, positions = GRD_12_read(chunks, header, states, known)
    elif is_plain:
        faces, seams = PLN_2_faces(chunks["CONN"], chunks["SEAM"], header)
    else:
        faces = CONN_8_faces(chunks["CONN"], header.triangles, header.geometric, states)
    around = neighbours(faces, header.geometric)
    parts = components(around)
    must(len(parts) == header.components or positions is not None, "HDR-7", f"{len(parts)} components in place of {header.components}")
    seams = seams or SEAM_1_read(chunks["SEAM"], faces, header.geometric, header.vertices)
    debug("faces: %s\nseams: %s", faces, seams.faces)
    mesh.header, mesh.faces = header, seams.faces
    mesh.groups = FGRP_1_plain(chunks["FGRP"], header.triangles) if is_plain else FGRP_1_read(chunks["FGRP"], seams.faces)
    mesh.exact = header.coder != HIGHPASS
    if mesh.exact and positions is None:
        chunk = chunks["POSN"]
        positions = PLN_5_positions(chunk, header) if is_plain else POSN_1_positions(chunk, header, faces, states)
    elif not mesh.exact:
        anchors = ANCH_1_read(chunks["ANCH"], header, header.geometric, parts, is_plain)
        positions = DELT_1_positions(chunks["DELT"], header, around, parts, anchors, is_plain)
    mesh.positions = GEO_1_round(positions)[seams.geometric]
    exact = mesh.positions if mesh.exact else None  # [ATTR-10]
    mesh.attributes = [chunk.descriptor for chunk in attributes]
    ATTR_11_decode(attributes, Surface(seams, exact, faces, mesh.attributes, states, known))
    if header.restore_order and not is_plain:
        restore(mesh, *ORDR_1_read(chunks["ORDR"], seams.faces, header.vertices))
    return mesh

def restore(mesh, places, face_places, rotations):
    """[ORDR-2, ORDR-3]"""
    coded, coded_faces = np.argsort(places), np.argsort(face_places)
    mesh.positions = mesh.positions[coded]
    for a in mesh.attributes:
        a.values = a.values[coded]
    faces = [tuple(places[face[(k - by) % 3]] for k in range(3)) for face, by in zip(mesh.faces, rotations)]
    mesh.faces = [faces[f] for f in coded_faces]
    mesh.groups = mesh.groups and [mesh.groups[f] for f in coded_faces]

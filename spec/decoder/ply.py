"""Binary PLY files."""
import numpy as np

from attr import COLOUR, NORMAL, UV

NAMES = {"i1": "char", "u1": "uchar", "i2": "short", "u2": "ushort", "i4": "int", "u4": "uint", "f4": "float", "f8": "double"}

def usual_first(attributes):
    """Pairs of an attribute and its properties' names: the first normals, texture coordinates and colours, then others."""
    usual = [(NORMAL, ["f4"], [3], ["nx", "ny", "nz"]), (UV, ["f4"], [2], ["s", "t"]),
             (COLOUR, ["u1"], [3, 4], ["red", "green", "blue", "alpha"])]
    found = []
    for kind, types, counts, names in usual:
        found += [(a, names[:a.k]) for a in attributes if a.is_shape(kind, types, counts)][:1]
    for a in attributes:
        if all(a is not f for f, _ in found):
            name = a.name.decode("utf-8", "replace").replace(" ", "_")
            found.append((a, [name] if a.k == 1 else [f"{name}_{i}" for i in range(a.k)]))
    return found

def write(path, mesh):
    """The place of a vertex is origin + position [HDR-12], in doubles where there is an origin."""
    origin = mesh.header.origin
    places = mesh.positions.astype("<f8") + origin if any(origin) else mesh.positions.astype("<f4")
    properties = [(axis, places[:, i]) for i, axis in enumerate("xyz")]
    for attribute, names in usual_first(mesh.attributes):
        properties += [(name, attribute.values[:, i]) for i, name in enumerate(names)]
    corners = np.array(mesh.faces, dtype="<i4").reshape(-1, 3)
    rows = np.rec.fromarrays([values for _, values in properties])
    faces = np.rec.fromarrays([np.full(len(corners), 3, dtype="u1"), *corners.T])
    lines = ["ply", "format binary_little_endian 1.0", f"element vertex {len(rows)}"]
    lines += [f"property {NAMES[values.dtype.str[1:]]} {name}" for name, values in properties]
    lines += [f"element face {len(faces)}", "property list uchar int vertex_indices", "end_header"]
    with open(path, "wb") as file:
        file.write(("\n".join(lines) + "\n").encode() + rows.tobytes() + faces.tobytes())

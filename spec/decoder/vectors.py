"""Vectors of two or three doubles or f32, every operation rounded, sums from the left; and rules that several codings use."""
import math

import numpy as np

from container import must

np.seterr(all="ignore")

F = np.float32  # of a number, or of several as a vector

def dot(x, y):  # ATTR-22, ATTR-32
    """Of vectors, or of rows of vectors."""
    p = (x * y).T
    return p[0] + p[1] if len(p) == 2 else p[0] + p[1] + p[2]

def square(x):  # ATTR-22, ATTR-32
    return dot(x, x)

def cross(x, y):  # ATTR-22, ATTR-32
    """Of vectors, or of rows of vectors; of two components a number."""
    if x.shape[-1] == 2:
        return x.T[0] * y.T[1] - x.T[1] * y.T[0]
    (x0, x1, x2), (y0, y1, y2) = x.T, y.T
    return np.stack([x1 * y2 - x2 * y1, x2 * y0 - x0 * y2, x0 * y1 - x1 * y0]).T

def ATTR_22_edges(values, faces):
    """From the values at corner 0 of faces to those at corners 1 and 2, all times 2^e, in f32."""
    largest = float(np.abs(values).max()) if values.size else 0.0
    e = -math.frexp(largest)[1] if largest and math.isfinite(largest) else 0
    at = (values.astype(F) * F(2.0**min(max(e, -126), 126)))[np.array(faces, dtype=int).reshape(-1, 3)]
    return at[:, 1] - at[:, 0], at[:, 2] - at[:, 0]

def ATTR_22_angle(x, y):
    z = np.abs(x)
    t = np.where(y > z, z / y, y / z)
    s = t * t
    arc = t * (F(0.9998660) + s * (F(-0.3302995) + s * (F(0.1801410) + s * (F(-0.0851330) + s * F(0.0208351)))))
    h = F(1.57079633)
    acute = np.where(y > z, h - arc, arc)
    return np.where(x < 0, F(2) * h - acute, acute)

def ATTR_22_corner_angles(a, b, y):
    """The angles at the three corners of faces."""
    f, g = ATTR_22_angle(dot(a, b), y), ATTR_22_angle(F(0) - dot(a, b - a), y)
    return np.stack([f, g, F(3.14159265) - f - g], axis=1)

def sum_at_corners(surface, counted, values):  # ATTR-22, ATTR-40
    """Sums for each vertex, over its corners in ascending order, of values [face, corner] of counted faces."""
    sums = np.zeros((surface.n, *values.shape[2:]), dtype=F)
    np.add.at(sums, np.array(surface.faces, dtype=int).reshape(-1, 3)[counted], values[counted])
    return sums

def ATTR_23_frame(P, v):
    """Pole, first and second axis."""
    w = cross(P, v)
    if not F(1e-12) * square(P) < square(w) < F(1e36):
        w = cross(P, np.eye(3, dtype=F)[np.argmin(abs(P))])
    pole, second = (F(1) / np.sqrt(square(P))) * P, (F(1) / np.sqrt(square(w))) * w
    return pole, cross(second, pole), second

def ATTR_24_point(a, b, pole, first, second):
    """The direction of a place in the plane around the pole."""
    z, s = a * a + b * b, F(1)
    if not z <= 1:
        must(z <= 9, "ATTR-24", "a place too far from the pole")
        d = np.sqrt(z)
        factor = (F(2) - d) / d if d < 2 else F(0)
        a, b, s = a * factor, b * factor, F(-1)
        z = a * a + b * b
    i = F(1) / (F(1) + z)
    return (s * (F(1) - z)) * i * pole + ((F(2) * a) * i) * first + ((F(2) * b) * i) * second

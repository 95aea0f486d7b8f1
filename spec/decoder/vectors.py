"""Vectors of two or three doubles or f32, every operation rounded, sums from the left; and rules ATTR-22 and ATTR-24."""
import math

import numpy as np

from container import must

np.seterr(all="ignore")

def vector(*numbers):
    return np.array(numbers, dtype=np.float64)

def dot(x, y):
    """Of vectors, or of rows of vectors."""
    p = (x * y).T
    return p[0] + p[1] if len(p) == 2 else p[0] + p[1] + p[2]

def cross(x, y):
    """Of vectors, or of rows of vectors; of two components a number."""
    if x.shape[-1] == 2:
        return x[0] * y[1] - x[1] * y[0]
    (x0, x1, x2), (y0, y1, y2) = x.T, y.T
    return np.stack([x1 * y2 - x2 * y1, x2 * y0 - x0 * y2, x0 * y1 - x1 * y0]).T

def unit(x):
    """None where it does not exist."""
    square = dot(x, x)
    return (1 / np.sqrt(square)) * x if 1e-300 < square < 1e300 else None

def to_f32(x):
    return x.astype(np.float32).astype(np.float64)

def ATTR_22_scaled(values):
    """Values times 2^e, in f32."""
    largest = float(np.abs(values).max()) if values.size else 0.0
    e = -math.frexp(largest)[1] if largest and math.isfinite(largest) else 0
    return values.astype(np.float32) * np.float32(2.0**min(max(e, -126), 126))

def ATTR_22_angle(x, y):
    F, z = np.float32, np.abs(x)
    t = np.where(y > z, z / y, y / z)
    s = t * t
    arc = t * (F(0.9998660) + s * (F(-0.3302995) + s * (F(0.1801410) + s * (F(-0.0851330) + s * F(0.0208351)))))
    h = F(1.57079633)
    acute = np.where(y > z, h - arc, arc)
    return np.where(x < 0, F(2) * h - acute, acute)

def ATTR_22_corner_angles(a, b, y):
    """The angles at the three corners of faces."""
    f, g = ATTR_22_angle(dot(a, b), y), ATTR_22_angle(np.float32(0) - dot(a, b - a), y)
    return np.stack([f, g, np.float32(3.14159265) - f - g], axis=1)

def sum_at_corners(faces, counted, values, n):
    """Sums for each vertex, over its corners in ascending order, of values [face, corner] of counted faces."""
    sums = np.zeros((n,) + values.shape[2:], dtype=np.float32)
    np.add.at(sums, faces[counted].reshape(-1), values[counted].reshape((-1,) + values.shape[2:]))
    return sums

def ATTR_24_point(a, b, P, first, second):
    """The f32 direction of a place in the plane around P."""
    z, s = a * a + b * b, 1.0
    if not z <= 1:
        must(z <= 9, "ATTR-24", "a place too far from the pole")
        d = np.sqrt(z)
        factor = (2 - d) / d if d < 2 else 0.0
        a, b, s = a * factor, b * factor, -1.0
        z = a * a + b * b
    i = 1 / (1 + z)
    return to_f32((s * (1 - z)) * i * P + ((2 * a) * i) * first + ((2 * b) * i) * second)

"""Vectors of three doubles, every operation rounded, sums from the left; and rule ATTR-22, which several codings use."""
import math

import numpy as np

from container import must

def dot(x, y):
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]

def cross(x, y):
    return (x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0])

def sub(x, y):
    return tuple(a - b for a, b in zip(x, y))

def add(x, y):
    return tuple(a + b for a, b in zip(x, y))

def times(f, x):
    return tuple(f * a for a in x)

def unit(x):
    """None where it does not exist."""
    square = dot(x, x)
    return times(1 / math.sqrt(square), x) if 1e-300 < square < 1e300 else None

def to_f32(x):
    with np.errstate(over="ignore"):
        return tuple(float(np.float32(a)) for a in x)

def ATTR_22_scaled(values):
    """Values times 2^e, in f32."""
    largest = float(np.abs(values).max()) if values.size else 0.0
    e = -math.frexp(largest)[1] if largest and math.isfinite(largest) else 0
    return values.astype(np.float32) * np.float32(2.0**min(max(e, -126), 126))

def f32_dot(x, y):
    return x[:, 0] * y[:, 0] + x[:, 1] * y[:, 1] + x[:, 2] * y[:, 2]

def f32_cross(x, y):
    return np.stack([x[:, 1] * y[:, 2] - x[:, 2] * y[:, 1], x[:, 2] * y[:, 0] - x[:, 0] * y[:, 2],
                     x[:, 0] * y[:, 1] - x[:, 1] * y[:, 0]], axis=1)

def ATTR_22_angle(x, y):
    F = np.float32
    z = np.abs(x)
    t = np.where(y > z, z / y, y / z)
    s = t * t
    arc = t * (F(0.9998660) + s * (F(-0.3302995) + s * (F(0.1801410) + s * (F(-0.0851330) + s * F(0.0208351)))))
    h = F(1.57079633)
    acute = np.where(y > z, h - arc, arc)
    return np.where(x < 0, F(2) * h - acute, acute)

def ATTR_22_corner_angles(a, b, y):
    """The angles at the three corners of faces."""
    f, g = ATTR_22_angle(f32_dot(a, b), y), ATTR_22_angle(np.float32(0) - f32_dot(a, b - a), y)
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
        d = math.sqrt(z)
        factor = (2 - d) / d if d < 2 else 0.0
        a, b, s = a * factor, b * factor, -1.0
        z = a * a + b * b
    i = 1 / (1 + z)
    return to_f32(add(add(times((s * (1 - z)) * i, P), times((2 * a) * i, first)), times((2 * b) * i, second)))

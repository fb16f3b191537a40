#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes sky.exr: a clear sky of zenith luminance 1 with a sun of 0.02 rad, equirectangular, half floats.

Needs only Python's standard library: python3 make_sky.py sky.exr
"""
import math
import struct
import sys
import zlib

WIDTH, HEIGHT = 256, 128
SUN_DIAMETER = 0.02  # radians
SUN_ELEVATION, SUN_AZIMUTH = math.radians(35), math.radians(55)  # azimuth from -Z towards +X
SUN_ILLUMINANCE = 12.0  # on a surface that faces it; the sky itself gives about 3.7
SUN_COLOR = (1.12, 0.98, 0.82)
SUBPIXELS = 8  # the sun's edge, per axis


def direction(x, y):
    """Of the point (x, y) in pixels: centre column to -Z, top row to +Y."""
    azimuth = (x / WIDTH - 0.5) * 2 * math.pi
    elevation = (0.5 - y / HEIGHT) * math.pi
    return (math.cos(elevation) * math.sin(azimuth), math.sin(elevation), -math.cos(elevation) * math.cos(azimuth))


SUN = (math.cos(SUN_ELEVATION) * math.sin(SUN_AZIMUTH), math.sin(SUN_ELEVATION),
       -math.cos(SUN_ELEVATION) * math.cos(SUN_AZIMUTH))


def sky(d):
    """A blue zenith, a bright horizon, a glow around the sun, a brown ground."""
    cosine = sum(a * b for a, b in zip(d, SUN))
    if d[1] < 0:
        shade = math.exp(4 * d[1])
        return [0.22 + 0.5 * shade, 0.18 + 0.45 * shade, 0.14 + 0.42 * shade]
    haze = math.exp(-5 * d[1])
    glow = 2.5 * max(cosine, 0) ** 60 + 0.5 * max(cosine, 0) ** 6
    base, pale = (0.46, 0.95, 2.1), (1.9, 2.1, 2.4)
    return [1.05 * (b * (1 - haze) + p * haze) + glow * c for b, p, c in zip(base, pale, SUN_COLOR)]


def sun_share(x, y):
    """How much of the pixel the sun's disk covers."""
    inside, step = 0, 1 / SUBPIXELS
    for i in range(SUBPIXELS):
        for j in range(SUBPIXELS):
            d = direction(x + (i + 0.5) * step, y + (j + 0.5) * step)
            chord = math.dist(d, SUN)
            inside += 2 * math.asin(min(chord / 2, 1)) < SUN_DIAMETER / 2
    return inside / SUBPIXELS ** 2


def pixels():
    """Rows of (r, g, b). The sun's luminance follows from the solid angle that the pixels really give it."""
    rows = [[sky(direction(x + 0.5, y + 0.5)) for x in range(WIDTH)] for y in range(HEIGHT)]
    shares, total = {}, 0.0
    for y in range(HEIGHT):
        row_angle = 2 * math.pi / WIDTH * (math.sin((0.5 - y / HEIGHT) * math.pi)
                                           - math.sin((0.5 - (y + 1) / HEIGHT) * math.pi))
        for x in range(WIDTH):
            if math.dist(direction(x + 0.5, y + 0.5), SUN) > 0.1:
                continue
            share = sun_share(x, y)
            if share > 0:
                shares[x, y] = share
                total += share * row_angle
    for (x, y), share in shares.items():
        rows[y][x] = [v + share * SUN_ILLUMINANCE / total * c for v, c in zip(rows[y][x], SUN_COLOR)]
    return rows


def attribute(name, kind, value):
    return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(value)) + value


def zipped(raw):
    """EXR's ZIP: odd bytes after even ones, differences, deflate; as it is when that does not help."""
    split = raw[0::2] + raw[1::2]
    delta = bytes([split[0]]) + bytes((split[i] - split[i - 1] + 128) & 255 for i in range(1, len(split)))
    packed = zlib.compress(delta, 9)
    return packed if len(packed) < len(raw) else raw


def exr(rows):
    """OpenEXR 2 scan lines, channels B, G, R as half, blocks of 16 rows."""
    channels = b"".join(name + b"\0" + struct.pack("<iBxxxii", 1, 0, 1, 1) for name in (b"B", b"G", b"R")) + b"\0"
    box = struct.pack("<4i", 0, 0, WIDTH - 1, HEIGHT - 1)
    header = struct.pack("<ii", 20000630, 2)
    header += attribute("channels", "chlist", channels) + attribute("compression", "compression", b"\x03")
    header += attribute("dataWindow", "box2i", box) + attribute("displayWindow", "box2i", box)
    header += attribute("lineOrder", "lineOrder", b"\0")
    header += attribute("pixelAspectRatio", "float", struct.pack("<f", 1))
    header += attribute("screenWindowCenter", "v2f", struct.pack("<ff", 0, 0))
    header += attribute("screenWindowWidth", "float", struct.pack("<f", 1)) + b"\0"
    blocks = []
    for top in range(0, HEIGHT, 16):
        raw = b"".join(struct.pack(f"<{WIDTH}e", *(pixel[c] for pixel in row))
                       for row in rows[top:top + 16] for c in (2, 1, 0))
        data = zipped(raw)
        blocks.append(struct.pack("<ii", top, len(data)) + data)
    offsets, at = [], len(header) + 8 * len(blocks)
    for block in blocks:
        offsets.append(at)
        at += len(block)
    return header + struct.pack(f"<{len(offsets)}Q", *offsets) + b"".join(blocks)


if __name__ == "__main__":
    with open(sys.argv[1], "wb") as file:
        file.write(exr(pixels()))

#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes still-life.srad with its meshes and textures: a table with a vase of leaves, a bowl of fruit, a lantern.

Everything is computed here, from the standard library alone; the same bytes on every run.
    projects/still-life/make.py [FOLDER]
"""
import json
import math
import random
import struct
import sys
import zlib
from pathlib import Path

folder = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent)
assets = folder / "still-life.assets"


# --- vectors ---------------------------------------------------------------------------------------------------------
def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(v):
    length = math.sqrt(sum(x * x for x in v)) or 1.0
    return tuple(x / length for x in v)


# --- meshes ----------------------------------------------------------------------------------------------------------
class Mesh:
    def __init__(self, name):
        self.name, self.positions, self.uvs, self.triangles = name, [], [], []

    def sheet(self, columns, rows, point, flip=False):
        """Rows x columns squares over (u, v) in [0, 1]^2; faces cross(d/du, d/dv)."""
        first = len(self.positions)
        for j in range(rows + 1):
            for i in range(columns + 1):
                u, v = i / columns, j / rows
                self.positions.append(point(u, v))
                self.uvs.append((u, v))
        for j in range(rows):
            for i in range(columns):
                a = first + j * (columns + 1) + i
                b, c, d = a + 1, a + columns + 1, a + columns + 2
                for t in ((a, b, d), (a, d, c)):
                    self.triangles.append(t[::-1] if flip else t)
        return self

    def normals(self):
        """Area-weighted; vertices at the same place share one, so seams of the texture do not show."""
        sums = {}
        key = lambda p: tuple(round(x * 1e5) for x in p)
        for t in self.triangles:
            a, b, c = (self.positions[i] for i in t)
            n = cross(sub(b, a), sub(c, a))
            for i in t:
                k = key(self.positions[i])
                sums[k] = tuple(x + y for x, y in zip(sums.get(k, (0.0, 0.0, 0.0)), n))
        return [unit(sums.get(key(p), (0.0, 1.0, 0.0))) for p in self.positions]

    def data(self):
        pack = lambda code, rows: b"".join(struct.pack("<%d%s" % (len(r), code), *r) for r in rows)
        return (b"SRADMESH" + struct.pack("<IIQQ", 1, 1 | 4, len(self.positions), len(self.triangles)) +
                pack("f", self.positions) + pack("I", self.triangles) + pack("f", self.normals()) + pack("f", self.uvs))


def lathe(name, profile, columns=48, rows=48):
    """A closed profile [(radius, height), ...], outer side first going up, turned around Y."""
    steps = [math.dist(a, b) for a, b in zip(profile, profile[1:])]
    total = sum(steps)

    def at(v):
        x = v * total
        for (a, b), step in zip(zip(profile, profile[1:]), steps):
            if x <= step or b is profile[-1]:
                f = min(x / step, 1.0)
                return a[0] + (b[0] - a[0]) * f, a[1] + (b[1] - a[1]) * f
            x -= step

    def point(u, v):
        r, y = at(v)
        return (r * math.cos(2 * math.pi * u), y, -r * math.sin(2 * math.pi * u))

    return Mesh(name).sheet(columns, rows, point)


def curve(points, steps=8):
    """Catmull-Rom through the points."""
    ends = [points[0]] + points + [points[-1]]
    made = []
    for a, b, c, d in zip(ends, ends[1:], ends[2:], ends[3:]):
        for k in range(steps):
            t = k / steps
            made.append(tuple(0.5 * (2 * q + (r - p) * t + (2 * p - 5 * q + 4 * r - s) * t * t + (3 * q - p - 3 * r + s) * t ** 3)
                              for p, q, r, s in zip(a, b, c, d)))
    return made + [points[-1]]


def fruit(name, radius, dent):
    def point(u, v):
        polar, azimuth = math.pi * (1 - v), 2 * math.pi * u
        r = radius * (1 - dent * math.exp(-(polar / 0.35) ** 2) - 0.6 * dent * math.exp(-((math.pi - polar) / 0.3) ** 2) +
                      0.02 * math.cos(5 * azimuth) * math.sin(polar) ** 2)
        return (r * math.sin(polar) * math.cos(azimuth), r * math.cos(polar), -r * math.sin(polar) * math.sin(azimuth))

    return Mesh(name).sheet(48, 32, point)


def tableTop(name, width, depth, thickness, corner):
    """A board with rounded edges, the grain along x: u runs 1 per metre."""
    mesh = Mesh(name)
    outline = []
    for quarter in range(4):
        cx, cz = ((width, depth), (-width, depth), (-width, -depth), (width, -depth))[quarter]
        for k in range(9):
            a = (quarter + k / 8) * math.pi / 2
            outline.append((cx / 2 - math.copysign(corner, cx) + corner * math.cos(a), cz / 2 - math.copysign(corner, cz) + corner * math.sin(a)))
    bevel = 0.012
    angles = [k / 4 * math.pi / 2 for k in range(5)]
    insets = [(bevel * (1 - math.sin(a)), -bevel * (1 - math.cos(a))) for a in angles] + [(0.0, -thickness)]

    def ring(inset, y):
        scale = lambda p, size: p * (1 - 2 * inset / size)
        first = len(mesh.positions)
        for x, z in outline + outline[:1]:
            mesh.positions.append((scale(x, width), y, scale(z, depth)))
            mesh.uvs.append((x + 0.01 * y, z - y))
        return first

    firsts = [ring(*inset) for inset in insets]
    for a, b in zip(firsts, firsts[1:]):
        for i in range(len(outline)):
            mesh.triangles += [(a + i, a + i + 1, b + i + 1), (a + i, b + i + 1, b + i)]
    centre = len(mesh.positions)
    mesh.positions.append((0.0, 0.0, 0.0))
    mesh.uvs.append((0.0, 0.0))
    for i in range(len(outline)):
        mesh.triangles.append((centre, firsts[0] + i + 1, firsts[0] + i))
    return mesh


def leaf(name, length, width, droop):
    """A card bent along its length; its texture cuts the leaf out."""
    def point(u, v):
        along, across = length * v, width * (u - 0.5)
        return (across, along * math.cos(droop * v) + 0.15 * abs(across), along * math.sin(droop * v))

    return Mesh(name).sheet(6, 12, point)


def cloth(name, size):
    def point(u, v):
        x, z = size * (u - 0.5), size * (v - 0.5)
        height = 0.006 * math.sin(23 * x + 4 * math.sin(9 * z)) + 0.004 * math.sin(31 * z + 2 * x) + 0.011
        return (x + 0.02 * math.sin(7 * z), height, z + 0.02 * math.sin(6 * x))

    return Mesh(name).sheet(64, 64, point, flip=True)


# --- textures --------------------------------------------------------------------------------------------------------
class Noise:
    """Smooth periodic value noise."""
    def __init__(self, seed, columns, rows=None):
        source = random.Random(seed)
        self.columns, self.rows = columns, rows or columns
        self.values = [[source.random() for _ in range(self.columns)] for _ in range(self.rows)]

    def at(self, x, y):
        m, n = self.columns, self.rows
        i, j = math.floor(x), math.floor(y)
        fx, fy = x - i, y - j
        fx, fy = fx * fx * (3 - 2 * fx), fy * fy * (3 - 2 * fy)
        v = self.values
        a, b = v[j % n][i % m], v[j % n][(i + 1) % m]
        c, d = v[(j + 1) % n][i % m], v[(j + 1) % n][(i + 1) % m]
        return (a + (b - a) * fx) * (1 - fy) + (c + (d - c) * fx) * fy


def mixed(a, b, t):
    t = min(max(t, 0.0), 1.0)
    return tuple(x + (y - x) * t for x, y in zip(a, b))


def wood(u, v):
    warp = growth.at(u * 2, v * 4)
    grain = 0.5 + 0.5 * math.sin(2 * math.pi * (6 * v + 1.6 * warp))
    fibre = fibres.at(u * 8, v * 64)
    plank = math.floor(v * 4)
    tone = 0.12 * (rings.at(plank * 1.7 + 0.5, 0.5) - 0.5)
    gap = min((v * 4) % 1, 1 - (v * 4) % 1)
    color = mixed((0.40, 0.24, 0.13), (0.60, 0.40, 0.23), 0.55 * grain + 0.35 * fibre + 2 * tone)
    return mixed((0.12, 0.07, 0.04), color, gap / 0.012), 0.35 + 0.3 * fibre, min(gap / 0.02, 1.0) * 0.6 + 0.25 * fibre


def normalMap(height, strength):
    def texel(x, y, n):
        at = lambda i, j: height((i % n) / n, (j % n) / n)
        dx, dy = (at(x + 1, y) - at(x - 1, y)) * strength, (at(x, y + 1) - at(x, y - 1)) * strength
        normal = unit((-dx, dy, 1.0))  # y counts upward, rows downward
        return tuple(0.5 + 0.5 * c for c in normal) + (1.0,)

    return texel


rings, fine, blotches = Noise(1, 16), Noise(2, 64), Noise(3, 8)
growth, fibres = Noise(4, 2, 4), Noise(5, 8, 64)  # of wood


def leafAlpha(u, v):
    half = 0.46 * math.sin(math.pi * min(v, 1.0) ** 0.8) ** 0.9
    teeth = 0.025 * abs(((v * 14) % 1) - 0.5)
    return 1.0 if abs(u - 0.5) < half - teeth else 0.0


def leafColor(u, v):
    side = abs(u - 0.5)
    vein = min(abs(((v - side * 0.9) * 9) % 1 - 0.5) * 2, side * 24)
    return mixed((0.46, 0.58, 0.26), (0.16, 0.34, 0.10), min(vein, 1.0) * 0.8 + 0.2 * fine.at(u * 32, v * 32))


def appleSkin(u, v):
    streak = fine.at(u * 64, v * 3)
    blush = 0.5 + 0.5 * math.sin(2 * math.pi * u) * math.sin(math.pi * v)
    color = mixed((0.78, 0.66, 0.18), (0.66, 0.07, 0.06), 1.5 * blush + 0.5 * streak - 0.35)
    speck = 1.0 if fine.at(u * 64 + 0.3, v * 64) > 0.9 else 0.0
    return mixed(color, (0.85, 0.75, 0.5), 0.5 * speck)


def weave(u, v):
    x, y = u * 64, v * 64
    over = (math.floor(x) + math.floor(y)) % 2
    a, b = math.sin(math.pi * (x % 1)), math.sin(math.pi * (y % 1))
    return 0.35 + 0.65 * (a if over else b)


def stripes(u, v):
    band = 1.0 if (v * 6) % 1 < 0.16 or 0.24 < (v * 6) % 1 < 0.28 else 0.0
    color = mixed((0.86, 0.82, 0.74), (0.13, 0.24, 0.42), band)
    return tuple(c * (0.85 + 0.15 * weave(u, v)) for c in color)


def glaze(u, v):
    drip = v + 0.05 * math.sin(2 * math.pi * 5 * u) + 0.06 * rings.at(u * 16, 3.0)
    return mixed((0.62, 0.42, 0.27), mixed((0.10, 0.33, 0.38), (0.16, 0.48, 0.50), blotches.at(u * 8, v * 8)), (drip - 0.17) * 40)


def glow(u, v):
    """A lantern's paper: brighter in the middle, ribs dark."""
    rib = abs(((v * 9) % 1) - 0.5) * 2
    return tuple(c * (0.25 + 0.75 * math.sin(math.pi * v)) * (1.0 if rib < 0.9 else 0.35) for c in (1.0, 0.78, 0.52))


def png(width, height, texel):
    rows = b""
    for y in range(height):
        rows += b"\0" + bytes(min(max(int(c * 255 + 0.5), 0), 255) for x in range(width) for c in texel(x, y))
    chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    channels = len(texel(0, 0))
    header = struct.pack(">IIBBBBB", width, height, 8, {3: 2, 4: 6}[channels], 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b"")


def shown(function, size, channels=3):
    return png(size, size, lambda x, y: function((x + 0.5) / size, (y + 0.5) / size)[:channels])


# --- the scene -------------------------------------------------------------------------------------------------------
project = {"steradian": 2, "name": "Still life", "render": {"width": 960, "height": 640, "maxBounces": 8},
           "display": {"exposure": 0.3}, "meshes": [], "textures": [], "materials": [], "objects": []}
ids = iter(range(1, 1000))


def asset(data, ending):
    """FNV-1a names it, as the editor does when it saves."""
    value = 0xcbf29ce484222325
    for byte in data:
        value = ((value ^ byte) * 0x100000001b3) & 0xffffffffffffffff
    assets.mkdir(parents=True, exist_ok=True)
    name = "%016x.%s" % (value, ending)
    (assets / name).write_bytes(data)
    return "still-life.assets/" + name


def mesh(made):
    number = len(project["meshes"]) + 1
    project["meshes"].append({"id": number, "name": made.name, "asset": asset(made.data(), "mesh")})
    return {"mesh": {"id": number}}


def texture(name, data, **place):
    number = len(project["textures"]) + 1
    project["textures"].append({"id": number, "name": name, "asset": asset(data, "png")})
    return {"texture": number, **place}


def material(name, **fields):
    project["materials"].append({"id": next(ids), "name": name, **fields})
    return project["materials"][-1]["id"]


def add(name, content, material=None, at=(0, 0, 0), turn=(0, 0, 0, 1), scale=(1, 1, 1)):
    made = {"id": next(ids), "name": name, "translation": list(at), "rotation": [round(x, 7) for x in turn], "scale": list(scale), **content}
    if material:
        made["material"] = material
    project["objects"].append(made)


def about(axis, degrees):
    a = math.radians(degrees) / 2
    return tuple(x * math.sin(a) for x in unit(axis)) + (math.cos(a),)


def after(p, q):
    """The rotation q, then p."""
    (ax, ay, az, aw), (bx, by, bz, bw) = p, q
    return (aw * bx + ax * bw + ay * bz - az * by, aw * by - ax * bz + ay * bw + az * bx, aw * bz + ax * by - ay * bx + az * bw,
            aw * bw - ax * bx - ay * by - az * bz)


planks = material("Planks", albedo=[1, 1, 1], roughness=1.0,
                  albedoTexture=texture("planks", shown(lambda u, v: wood(u, v)[0], 256)),
                  metallicRoughnessTexture=texture("planks, roughness", shown(lambda u, v: (1.0, wood(u, v)[1], 0.0), 128)),
                  normalTexture=texture("planks, normals", png(256, 256, lambda x, y: normalMap(lambda u, v: wood(u, v)[2], 1.5)(x, y, 256)[:3])))
linen = material("Linen", albedo=[1, 1, 1], roughness=0.9, specular=0.4, albedoTexture=texture("linen", shown(stripes, 256)),
                 normalTexture=texture("linen, normals", png(128, 128, lambda x, y: normalMap(lambda u, v: weave(u / 8, v / 8), 0.8)(x, y, 128)[:3]),
                                       transform=[8, 0, 0, 0, 8, 0]))
stoneware = material("Glazed stoneware", albedo=[1, 1, 1], roughness=0.45, clearcoat=1, clearcoatRoughness=0.08,
                     albedoTexture=texture("glaze", shown(glaze, 256)))
leaves = material("Leaf", albedo=[1, 1, 1], roughness=0.45, alphaMode="mask",
                  albedoTexture=texture("leaf", shown(lambda u, v: leafColor(u, 1 - v) + (leafAlpha(u, 1 - v),), 256, 4), wrapU="clamp", wrapV="clamp"))
apple = material("Apple", albedo=[1, 1, 1], roughness=0.3, clearcoat=0.6, clearcoatRoughness=0.15, albedoTexture=texture("apple", shown(appleSkin, 256)))
lemon = material("Lemon", albedo=[0.87, 0.66, 0.07], roughness=0.4,
                 normalTexture=texture("peel", png(128, 128, lambda x, y: normalMap(lambda u, v: blotches.at(u * 64, v * 64), 0.7)(x, y, 128)[:3]),
                                       transform=[2, 0, 0, 0, 1, 0]))
copper = material("Hammered copper", albedo=[0.93, 0.52, 0.38], metallic=1, roughness=0.25, normalScale=0.6,
                  normalTexture=texture("hammered", png(128, 128, lambda x, y: normalMap(lambda u, v: 1.6 * rings.at(u * 16, v * 16), 0.9)(x, y, 128)[:3]),
                                        transform=[3, 0, 0, 0, 2, 0]))
paper = material("Lantern paper", albedo=[0.8, 0.75, 0.65], roughness=0.9, specular=0.2, emissionLuminance=5,
                 emissionTexture=texture("lantern", shown(glow, 128)))
glass = material("Glass", albedo=[1, 1, 1], roughness=0, transmission=1)
wall = material("Wall", albedo=[0.55, 0.52, 0.48], roughness=0.95)

add("Camera", {"camera": {"fovY": 0.52, "fNumber": 2.8, "focusDistance": 1.85}}, at=(0.1, 0.53, 1.85), turn=about((1, 0, 0), -11))
add("Sky", {"environmentLight": {"intensity": 0.6, "color": [0.55, 0.72, 1.0], "horizon": [1.5, 1.15, 0.9], "ground": [0.6, 0.45, 0.35]}})
add("Window", {"rectLight": {"size": [0.9, 1.2], "intensity": 17, "temperature": 5600}}, at=(-1.5, 1.1, 0.7),
    turn=after(about((0, 1, 0), -62), about((1, 0, 0), -22)))
add("Table", mesh(tableTop("board", 1.9, 1.0, 0.045, 0.05)), planks)
add("Cloth", mesh(cloth("cloth", 0.62)), linen, at=(0.2, 0.0, 0.06), turn=about((0, 1, 0), 14))
add("Wall", {"rect": {"size": [6, 3]}}, wall, at=(0, 0.6, -1.1), turn=about((1, 0, 0), 90))

vaseOuter = curve([(0.0, 0.0), (0.055, 0.0), (0.092, 0.07), (0.098, 0.13), (0.06, 0.22), (0.043, 0.265), (0.055, 0.30)])
vaseInner = curve([(0.049, 0.30), (0.037, 0.265), (0.053, 0.22), (0.09, 0.13), (0.084, 0.07), (0.05, 0.012), (0.0, 0.01)])
add("Vase", mesh(lathe("vase", vaseOuter + vaseInner, 48, 72)), stoneware, at=(-0.33, 0.0, -0.12))
card = mesh(leaf("leaf card", 0.22, 0.11, 0.8))
source = random.Random(5)
for i in range(16):
    turn = after(about((0, 1, 0), 137.5 * i + source.uniform(-15, 15)), about((1, 0, 0), 12 + 3.2 * i))
    add("Leaf %d" % (i + 1), card, leaves, at=(-0.33, 0.27 + 0.012 * (16 - i) + source.uniform(0, 0.02), -0.12), turn=turn,
        scale=[round(source.uniform(0.8, 1.25), 3)] * 3)

bowlOuter = curve([(0.0, 0.0), (0.06, 0.002), (0.12, 0.035), (0.165, 0.09)])
bowlInner = curve([(0.161, 0.092), (0.115, 0.041), (0.058, 0.009), (0.0, 0.007)])
add("Bowl", mesh(lathe("bowl", bowlOuter + bowlInner, 64, 48)), copper, at=(0.2, 0.02, 0.02))
ball = mesh(fruit("apple", 0.05, 0.28))
for i, (x, y, z, tilt) in enumerate([(0.15, 0.082, 0.0, 20), (0.25, 0.083, 0.03, -35), (0.2, 0.083, -0.07, 60), (0.2, 0.15, 0.0, 10)]):
    add("Apple %d" % (i + 1), ball, apple, at=(x, y, z), turn=after(about((1, 0, 0.4), tilt), about((0, 1, 0), 80 * i)))


def lemonPoint(u, v):
    polar, azimuth = math.pi * (1 - v), 2 * math.pi * u
    r = 0.033 * math.sin(polar) ** 0.9
    y = 0.042 * math.cos(polar) + 0.012 * math.cos(polar) ** 9
    return (r * math.cos(azimuth), y, -r * math.sin(azimuth))


fruitOfTree = mesh(Mesh("lemon").sheet(32, 32, lemonPoint))
add("Lemon 1", fruitOfTree, lemon, at=(-0.06, 0.034, 0.22), turn=after(about((0, 1, 0), 30), about((1, 0, 0), 90)))
add("Lemon 2", fruitOfTree, lemon, at=(0.03, 0.044, 0.3), turn=after(about((0, 1, 0), -50), about((1, 0, 0), 86)))

lantern = [(0.02, 0.0), (0.06, 0.006)] + [(0.06 + 0.045 * math.sin(math.pi * k / 36) + 0.003 * math.cos(math.pi * k), 0.006 + 0.19 * k / 36) for k in range(1, 36)] + [(0.06, 0.196), (0.02, 0.202)]
add("Lantern", mesh(lathe("lantern", lantern, 40, 80)), paper, at=(0.52, 0.0, -0.2))
add("Marble", {"sphere": {"radius": 0.032}}, glass, at=(-0.13, 0.032, 0.36))

folder.mkdir(parents=True, exist_ok=True)
(folder / "still-life.srad").write_text(json.dumps(project, indent=1) + "\n")

#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes many-lights.srad: a room under 1,000 lamps of very different strength, always the same.

Needs only Python's standard library: python3 make_many_lights.py many-lights.srad
"""
import json
import random
import sys

SIZE = (12.0, 3.6, 12.0)  # metres
GRID = (25, 40)           # lamps along x and z
RIGHT = 0.7071067811865476

MATERIALS = [
    {"id": 1, "name": "Plaster", "albedo": [0.7, 0.68, 0.64], "roughness": 1, "specular": 0},
    {"id": 2, "name": "Floor", "albedo": [0.32, 0.24, 0.17], "roughness": 0.3},
    {"id": 3, "name": "Copper", "albedo": [0.95, 0.64, 0.54], "metallic": 1, "roughness": 0.25},
    {"id": 4, "name": "Porcelain", "albedo": [0.8, 0.8, 0.78], "roughness": 0.15},
    {"id": 5, "name": "Slate", "albedo": [0.12, 0.14, 0.17], "roughness": 0.6},
]


def room():
    x, y, z = SIZE
    yield {"name": "Camera", "translation": [-4.6, 1.6, 5.4], "rotation": [-0.0259237, -0.3299819, -0.0090658, 0.9435877],
           "camera": {"fovY": 0.9}}
    yield {"name": "Floor", "rect": {"size": [x, z]}, "material": 2}
    yield {"name": "Ceiling", "translation": [0, y, 0], "rotation": [1, 0, 0, 0], "rect": {"size": [x, z]}, "material": 1}
    for name, place, turn, size in (("Back wall", [0, y / 2, -z / 2], [RIGHT, 0, 0, RIGHT], [x, y]),
                                    ("Front wall", [0, y / 2, z / 2], [-RIGHT, 0, 0, RIGHT], [x, y]),
                                    ("Left wall", [-x / 2, y / 2, 0], [0, 0, -RIGHT, RIGHT], [y, z]),
                                    ("Right wall", [x / 2, y / 2, 0], [0, 0, RIGHT, RIGHT], [y, z])):
        yield {"name": name, "translation": place, "rotation": turn, "rect": {"size": size}, "material": 1}


def furniture(rng):
    for i in range(12):
        radius = round(rng.uniform(0.25, 0.6), 3)
        place = [round(rng.uniform(-4.5, 4.5), 3), radius, round(rng.uniform(-4.5, 2.5), 3)]
        if i % 3:
            yield {"name": f"Ball {i}", "translation": place, "sphere": {"radius": radius}, "material": 3 + i % 3}
        else:
            yield {"name": f"Block {i}", "translation": place, "box": {"size": [2 * radius] * 3}, "material": 3 + i % 3}


def lamps(rng):
    """In a jittered grid; strengths over more than two decades, so that a few of them matter everywhere."""
    for i in range(GRID[0]):
        for j in range(GRID[1]):
            place = [round((i + rng.random()) / GRID[0] * 11.6 - 5.8, 3), round(rng.uniform(2.2, 3.5), 3),
                     round((j + rng.random()) / GRID[1] * 11.6 - 5.8, 3)]
            light = {"intensity": round(10 ** rng.uniform(-2.2, 0.1), 4), "temperature": round(rng.uniform(2700, 14000))}
            yield {"name": f"Lamp {i * GRID[1] + j + 1}", "translation": place, "pointLight": light}


def main():
    rng = random.Random(1)
    objects = [*room(), *furniture(rng), *lamps(rng)]
    line = lambda entry: "    " + json.dumps(entry)
    numbered = [{"id": len(MATERIALS) + 1 + i, **entry} for i, entry in enumerate(objects)]
    text = ('{\n  "steradian": 1,\n  "name": "Many lights",\n  "render": {"height": 720, "lightSamples": 4},\n  "display": {"exposure": -2},\n'
            '  "materials": [\n' + ",\n".join(map(line, MATERIALS)) + '\n  ],\n  "objects": [\n'
            + ",\n".join(map(line, numbered)) + "\n  ]\n}\n")
    with open(sys.argv[1], "w", encoding="utf-8") as file:
        file.write(text)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the mesh scene of the comparison with Cycles: hills and a bumpy ball under a rectangular lamp and a grey sky.

    tests/peers/terrain.py FOLDER [--triangles 300000] [--steradian ./steradian]

FOLDER/terrain.ply is what both renderers trace; FOLDER/terrain.srad is the scene around it. Then:

    tests/peers/time_to_error.py --project FOLDER/terrain.srad --bounces 8
"""

import argparse
import json
import math
import os
import struct
import subprocess

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def waves(x, y, z):
    total, amplitude, frequency = 0.0, 0.5, 2.7
    for _ in range(6):
        total += amplitude * math.sin(frequency * x + 1.3) * math.sin(frequency * y + 0.7) * math.sin(frequency * z + 2.1)
        amplitude, frequency = 0.5 * amplitude, 1.97 * frequency
    return total


def hill(u, v):
    x, z = 8.0 * u - 4.0, 8.0 * v - 4.0
    return x, 0.6 * waves(x, 1.0, z) - 0.2, z


def ball(u, v):
    phi, theta = 2.0 * math.pi * u, math.pi * v
    n = (math.sin(theta) * math.cos(phi), math.cos(theta), math.sin(theta) * math.sin(phi))
    radius = 0.8 + 0.25 * waves(2.0 * n[0], 2.0 * n[1], 2.0 * n[2])
    return radius * n[0], 0.8 + radius * n[1], radius * n[2]


def grid(place, side, first):
    """side x side squares of the unit square, each as two triangles, mapped to space."""
    points = [place(x / side, y / side) for y in range(side + 1) for x in range(side + 1)]
    faces = []
    for y in range(side):
        for x in range(side):
            a = first + y * (side + 1) + x
            b = a + side + 1
            faces += [(a, b, a + 1), (a + 1, b, b + 1)]
    return points, faces


def write_ply(path, points, faces):
    header = (
        f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\n"
        "property float x\nproperty float y\nproperty float z\n"
        f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    with open(path, "wb") as file:
        file.write(header.encode())
        file.writelines(struct.pack("<3f", *point) for point in points)
        file.writelines(struct.pack("<B3i", 3, *face) for face in faces)


def surroundings(scene):
    """Lamp, sky and camera around the imported mesh."""
    half = math.sqrt(0.5)
    down = math.radians(-16.26) / 2  # the camera looks at the ball
    scene["objects"] = [item for item in scene["objects"] if "mesh" in item]
    for item in scene["objects"]:
        item.update(name="terrain", material=2)
    scene["materials"] = [
        {"id": 2, "name": "clay", "albedo": [0.7, 0.6, 0.5], "roughness": 1.0, "metallic": 0.0, "specular": 0.0}
    ]
    scene["objects"] += [
        {"name": "lamp", "translation": [0, 4, 0], "rotation": [-half, 0, 0, half],
         "rectLight": {"size": [1.5, 1.5], "intensity": 20.0}},
        {"name": "sky", "environmentLight": {"intensity": 0.3}},
        {"name": "camera", "translation": [0, 1.4, 3.6], "rotation": [math.sin(down), 0, 0, math.cos(down)],
         "camera": {"fovY": 0.7853982}},
    ]
    return scene


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder")
    parser.add_argument("--triangles", type=int, default=300_000)
    parser.add_argument("--steradian", default=os.path.join(ROOT, "steradian"), help="the launcher or binary")
    arguments = parser.parse_args()
    os.makedirs(arguments.folder, exist_ok=True)
    side = round(math.sqrt(arguments.triangles / 4))
    hills = grid(hill, side, 0)
    balls = grid(ball, side, len(hills[0]))
    ply, srad = (os.path.join(arguments.folder, name) for name in ("terrain.ply", "terrain.srad"))
    write_ply(ply, hills[0] + balls[0], hills[1] + balls[1])
    subprocess.run([arguments.steradian, "convert", ply, srad], check=True)
    with open(srad, encoding="utf-8") as file:
        scene = json.load(file)
    with open(srad, "w", encoding="utf-8") as file:
        json.dump(surroundings(scene), file, indent=1)
    print(f"{srad}: {len(hills[1]) + len(balls[1])} triangles")


if __name__ == "__main__":
    main()

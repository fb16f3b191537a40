#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Time to 5 % and 1 % relative error: Steradian against Cycles on the same scene, alternating, in one run.

    tests/peers/time_to_error.py [--project projects/thesis-room/thesis-room.srad] [--folder build/peers]

Needs Debian's `blender` (3.4.1). Each renderer is measured against its own long reference of another seed, with
relRMSE = sqrt(mean((a-b)^2 / (b^2 + 0.01))); the two references are then compared with each other, which shows how far
the material models differ. Seconds are render seconds, without loading the scene and (Steradian) without compiling.
"""

import argparse
import json
import math
import os
import shutil
import subprocess
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
TARGETS = (0.05, 0.01)
REFERENCE_SEED, TEST_SEED = 7, 1


def same_task(project, folder, size, bounces):
    """The project as both renderers get it: same size, bounces, a box filter of one pixel; one joint sequence, no meter."""
    with open(project, encoding="utf-8") as file:
        scene = json.load(file)
    width, height = map(int, size.split("x"))
    scene.setdefault("render", {}).update(width=width, height=height, maxBounces=bounces, filter="box", errorMeter=False)
    path = os.path.join(folder, "room.srad")
    for mesh in scene.get("meshes", []):
        target = os.path.join(folder, mesh["asset"])
        os.makedirs(os.path.dirname(target), exist_ok=True)
        if not os.path.exists(target):
            shutil.copy(os.path.join(os.path.dirname(project), mesh["asset"]), target)
    with open(path, "w", encoding="utf-8") as file:
        json.dump(scene, file)
    return path


def run(command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)}\nended with {done.returncode}\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
    return done.stdout


def render_cycles(task, path, spp, seed):
    script = os.path.join(HERE, "cycles_scene.py")
    out = run(
        ["blender", "-b", "--factory-startup", "--python-exit-code", "1", "-P", script, "--", task.room, "-o", path]
        + ["--spp", str(spp), "--seed", str(seed), "--bounces", str(task.bounces), "--size", task.size]
        + ["--threads", str(task.threads), "--materials", task.materials]
    )
    line = next(line for line in out.splitlines() if line.startswith('{"samples"'))
    return json.loads(line)["seconds"]


def render_steradian(task, path, spp, seed):
    report = path.replace(".exr", ".json")
    run(
        [task.steradian, "render", task.room, "-o", path, "--spp", str(spp), "--seed", str(seed), "--report", report]
        + ["--size", task.size, "--bounces", str(task.bounces)]
        + (["--device", task.device] if task.device else [])
    )
    with open(report, encoding="utf-8") as file:
        seconds = json.load(file)["seconds"]
    return seconds["trace"]


def compare(task, a, b):
    return json.loads(run([task.steradian, "compare", "--json", a, b]))


class Peer:
    def __init__(self, name, render, levels, reference_spp):
        self.name, self.render, self.levels, self.reference_spp = name, render, levels, reference_spp
        self.points = []  # (samples, seconds, relRMSE)

    def image(self, task, what):
        return os.path.join(task.folder, f"{self.name}-{what}.exr")

    def make_reference(self, task):
        seconds = self.render(task, self.image(task, "reference"), self.reference_spp, REFERENCE_SEED)
        print(f"{self.name}: reference of {self.reference_spp} samples in {seconds:.1f} s", flush=True)

    def measure(self, task, spp):
        path = self.image(task, f"{spp}spp")
        seconds = self.render(task, path, spp, TEST_SEED)
        error = compare(task, path, self.image(task, "reference"))["relRmse"]
        self.points.append((spp, seconds, error))
        print(f"{self.name:>10} {spp:6d} samples {seconds:9.2f} s   relRMSE {100 * error:7.2f} %", flush=True)

    def fit(self):
        """Least squares of log error over log samples: (intercept, slope)."""
        x = [math.log(spp) for spp, _, _ in self.points]
        y = [math.log(error) for _, _, error in self.points]
        mx, my = sum(x) / len(x), sum(y) / len(y)
        slope = sum((a - mx) * (b - my) for a, b in zip(x, y)) / sum((a - mx) ** 2 for a in x)
        return my - slope * mx, slope

    def seconds_to(self, error):
        """The samples that the fit asks for, at the pace of the longest run."""
        intercept, slope = self.fit()
        spp, seconds, _ = max(self.points)
        return math.exp((math.log(error) - intercept) / slope) * seconds / spp

    def reaches(self, error):
        return min(point[2] for point in self.points) <= error


def print_result(cycles, steradian, task):
    print()
    for peer in (cycles, steradian):
        print(f"{peer.name}: error falls as samples^{peer.fit()[1]:.2f}")
    for target in TARGETS:
        a, b = cycles.seconds_to(target), steradian.seconds_to(target)
        marks = ["" if peer.reaches(target) else " (extrapolated)" for peer in (cycles, steradian)]
        print(f"time to {100 * target:.0f} %: cycles {a:.1f} s{marks[0]}, steradian {b:.1f} s{marks[1]}, ratio {a / b:.1f}")
    models = compare(task, steradian.image(task, "reference"), cycles.image(task, "reference"))
    ratio = ", ".join(f"{value:.4f}" for value in models["meanRatio"])
    print(f"steradian's reference against cycles': mean ratio {ratio}, relRMSE {100 * models['relRmse']:.2f} %")


def numbers(text):
    return [int(part) for part in text.split(",")]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--project", default=os.path.join(ROOT, "projects", "thesis-room", "thesis-room.srad"))
    parser.add_argument("--folder", default=os.path.join(ROOT, "build", "peers"))
    parser.add_argument("--steradian", default=os.path.join(ROOT, "steradian"), help="the launcher or binary")
    parser.add_argument("--size", default="256x256")
    parser.add_argument("--bounces", type=int, default=32)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--device", default="", help="Steradian's device, by name part or index")
    parser.add_argument("--materials", choices=["principled", "layered"], default="layered")
    parser.add_argument("--cycles-samples", type=numbers, default=[16, 32, 64, 128, 256])
    parser.add_argument("--cycles-reference", type=int, default=4096)
    parser.add_argument("--steradian-samples", type=numbers, default=[16, 32, 64, 128, 256])
    parser.add_argument("--steradian-reference", type=int, default=8192)
    task = parser.parse_args()
    os.makedirs(task.folder, exist_ok=True)
    task.room = same_task(task.project, task.folder, task.size, task.bounces)

    cycles = Peer("cycles", render_cycles, task.cycles_samples, task.cycles_reference)
    steradian = Peer("steradian", render_steradian, task.steradian_samples, task.steradian_reference)
    start = time.monotonic()
    for peer in (cycles, steradian):
        peer.make_reference(task)
    for level in range(max(len(cycles.levels), len(steradian.levels))):
        for peer in (cycles, steradian):
            if level < len(peer.levels):
                peer.measure(task, peer.levels[level])
    print_result(cycles, steradian, task)
    print(f"whole comparison: {time.monotonic() - start:.0f} s")


if __name__ == "__main__":
    main()

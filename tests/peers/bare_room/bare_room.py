#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Rays per second of the full tracer against a kernel that knows the thesis room alone, alternating, in one run.

    tests/peers/bare_room/bare_room.py [--build build/release] [--times 5] [--seconds 3] [--device NAME]

Rays per second divide by device time, as each program measures it. Medians of all runs are printed, and their ratios.
"""

import argparse
import json
import os
import statistics
import subprocess

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))))
FIGURES = ("msPerSample", "mraysPerSecond")


def output(command):
    return json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout)


def bare(options, device):
    return output([os.path.join(options.build, "bin", "bare_room"), "--size", options.size, "--seconds",
                   str(options.seconds), "--samples-per-dispatch", str(options.samples_per_dispatch)] + device)


def full(options, device):
    return output([os.path.join(options.build, "bin", "steradian"), "bench", options.project, "--size", options.size,
                   "--bounces", "3", "--seconds", str(options.seconds), "--runs", "1", "--no-target",
                   "--no-first-pixel", "--json"] + device)[0]["special"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default=os.path.join(ROOT, "build", "release"))
    parser.add_argument("--project", default=os.path.join(ROOT, "projects", "thesis-room"))
    parser.add_argument("--times", type=int, default=5)
    parser.add_argument("--seconds", type=float, default=3.0)
    parser.add_argument("--size", default="1280x720")
    parser.add_argument("--samples-per-dispatch", type=int, default=16)
    parser.add_argument("--device")
    options = parser.parse_args()
    device = ["--device", options.device] if options.device else []
    runs = {"bare": [], "full": []}
    for _ in range(options.times):
        runs["bare"].append(bare(options, device))
        runs["full"].append(full(options, device))
    median = {name: {f: statistics.median(run[f] for run in of) for f in FIGURES} for name, of in runs.items()}
    for name, figures in median.items():
        print(f"{name}: {figures['msPerSample']:8.2f} ms/sample  {figures['mraysPerSecond']:8.2f} Mrays/s")
    for f in FIGURES:
        print(f"full / bare, {f}: {median['full'][f] / median['bare'][f]:.3f}")


if __name__ == "__main__":
    main()

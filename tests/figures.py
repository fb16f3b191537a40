#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measured figures of the numbered accuracy tests (rowNN_..., tests/measured.hpp), as a Markdown table.

    tests/figures.py [BUILD]         runs the programs that hold such tests, one by one (BUILD: build/release)
    tests/figures.py --xml FOLDER    reads what GTEST_OUTPUT=xml:FOLDER/ left there, from any machine
    tests/figures.py --sources       only checks that each row has a test and each such test records a figure

Fails when a row has no figure, a figure lies beyond its gate, or a test failed.
"""
import argparse
import json
import os
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml
from collections import Counter
from pathlib import Path

ROWS = range(1, 43)
HERE = Path(__file__).resolve().parent


def run(build, folder):
    """Runs every program with a row test in it; False when one fails."""
    listing = subprocess.check_output(["ctest", "--test-dir", build, "--show-only=json-v1"])
    names = []
    for test in json.loads(listing)["tests"]:
        program = Path(test.get("command", [""])[-1])
        if program.is_file() and re.search(rb"row\d\d_\w", program.read_bytes()):
            names.append(test["name"])
    environment = dict(os.environ, GTEST_OUTPUT=f"xml:{folder}/", GTEST_FILTER="*row*")
    command = ["ctest", "--test-dir", build, "--output-on-failure", "-R", f"^({'|'.join(names)})$"]
    return subprocess.run(command, env=environment, stdout=sys.stderr).returncode == 0


def figures(folder):
    """(row, test, measured, figure, gate, device) of each record, and the names of failed row tests."""
    found, failed = [], []
    for file in sorted(Path(folder).glob("*.xml")):
        for suite in xml.parse(file).getroot().iter("testsuite"):
            for case in suite.iter("testcase"):
                row = re.match(r"row(\d+)_(?:\d+_)?(\w+)", case.get("name"))
                if row and case.find("failure") is not None:
                    failed.append(case.get("name"))
                for p in case.iter("property") if row else []:
                    if p.get("name").startswith("measured "):
                        value, gate = p.get("value").split(" ", 1)
                        found.append((int(row[1]), row[2].replace("_", " "), p.get("name")[9:], value, gate,
                                      suite.get("device", "host")))
    return found, failed


def beyond(figure, gate):
    relation, bound = gate.split()
    return not (float(figure) >= float(bound) if relation == ">=" else float(figure) <= float(bound))


def shown(number):
    return f"{float(number):.3g}" if abs(float(number)) < 1000 else f"{float(number):.0f}"


def table(found):
    """One line per record; tests that state the same thing of a row share one."""
    same = Counter((f[0], *f[2:]) for f in found)
    print("| row | test | measured | figure | gate | device |\n|---|---|---|---|---|---|")
    for row, test, what, figure, gate, device in sorted(found, key=lambda f: f[0]):
        count = same.pop((row, what, figure, gate, device), 0)
        if count:
            name = f"{count} tests" if count > 1 else test
            relation, bound = gate.split()
            print(f"| {row} | {name} | {what} | {shown(figure)} | {relation} {shown(bound)} | {device} |")


def unrecorded():
    """Row tests that neither record a figure nor call an expect... function that does; and the rows that have tests."""
    text = "\n".join(f.read_text() for f in sorted(HERE.rglob("*_test.cpp")) + sorted(HERE.rglob("*.hpp")))
    records = {"measured", "measuredAtLeast"}
    helpers = re.findall(r"^( *)(?:static |inline )*[\w:<>]+ (expect\w+)\([^;{]*\{\n(.*?)^\1\}", text, re.M | re.S)
    for _ in helpers:  # one may call another
        records |= {name for _, name, body in helpers if records & set(re.findall(r"\w+(?=\()", body))}
    suites = set(re.findall(r"class (\w+) : public \w+ \{[^}]*TearDown\(\) override \{ measured\(", text))
    tests = re.findall(r"^TEST(?:_F)?\((\w+),\s+(row(\d+)_\w+)\) \{\n(.*?)^\}", text, re.M | re.S)
    silent = [name for suite, name, _, body in tests
              if suite not in suites and not records & set(re.findall(r"\w+(?=\()", body))]
    return silent, {int(row) for _, _, row, _ in tests}


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("build", nargs="?", default=HERE.parent / "build/release")
    arguments.add_argument("--xml", metavar="FOLDER")
    arguments.add_argument("--sources", action="store_true")
    given, faults = arguments.parse_args(), []
    if given.sources:
        silent, rows = unrecorded()
        faults += [f"{name} records no figure" for name in silent]
    else:
        with tempfile.TemporaryDirectory() as folder:
            if not given.xml and not run(given.build, folder):
                faults.append("a test program failed")
            found, failed = figures(given.xml or folder)
        table(found)
        rows = {f[0] for f in found}
        faults += [f"{name} failed" for name in failed]
        faults += [f"row {f[0]}, {f[1]}: {f[2]}: {f[3]} is beyond {f[4]}" for f in found if beyond(f[3], f[4])]
    faults += [f"row {row} has no figure" for row in ROWS if row not in rows]
    for fault in faults:
        print(fault, file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""Compares one evaluation of a model in C with a step of MuJoCo: the same chain of hinges.

python benchmarks/export_speed.py [--mech ./mech] [LINKS ...]

The chain is imported from MJCF, written as C by `mech build --c`, and compiled with cc -O2
-ffp-contract=off. MuJoCo (pip install mujoco) steps it natively, explicit Euler, contacts and
constraints off, so that a step is one evaluation of the accelerations and an addition. Times are
medians of the thread's processor time; the accelerations of both are compared.
"""
import argparse
import glob
import math
import subprocess
import tempfile
import time

import mujoco
import numpy as np

AXES = ["0 1 0", "0 0 1", "0 1 0", "1 0 0"]

TIMER = r"""
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdio.h>
#include <time.h>
#include "chain.h"
enum { CALLS = 100000, ROUNDS = 9 };
int main(void) {
  static chain_t m;
  double x[chain_NX], dx[chain_NX];
  chain_init(&m);
  for (int i = 0; i < chain_NX; i++) x[i] = 0.3 * sin(i + 1.0);
  chain_derivatives(&m, 0, x, dx);
  for (int i = chain_NX / 2; i < chain_NX; i++) printf("%.17g ", dx[i]);
  for (int r = 0; r < ROUNDS; r++) {
    struct timespec a, b;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &a);
    for (int k = 0; k < CALLS; k++) {
      x[0] += 1e-12;
      chain_derivatives(&m, 0, x, dx);
    }
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &b);
    printf("%.6g ", ((b.tv_sec - a.tv_sec) * 1e6 + (b.tv_nsec - a.tv_nsec) / 1e3) / CALLS);
  }
  return 0;
}
"""


def chain(links):
    geom = '<geom type="capsule" fromto="0 0 0 0.3 0 0" size=".03"/>'
    body = ""
    for i in reversed(range(links)):
        place = "" if i == 0 else ' pos=".3 0 0"'
        body = f'<body{place}><joint name="j{i}" type="hinge" axis="{AXES[i % 4]}"/>{geom}{body}</body>'
    return ('<mujoco model="chain"><option timestep="1e-5" integrator="Euler" gravity="0 0 -9.81">'
            f'<flag contact="disable" constraint="disable"/></option><worldbody>{body}</worldbody></mujoco>')


def of_c(mech, folder):
    subprocess.run([mech, "import", f"{folder}/chain.mjcf.xml", "-o", f"{folder}/chain.xml"],
                   check=True, capture_output=True)
    subprocess.run([mech, "build", f"{folder}/chain.xml", "--c", f"{folder}/c", "--columns", "joints"],
                   check=True, capture_output=True)
    with open(f"{folder}/timer.c", "w", encoding="utf-8") as file:
        file.write(TIMER)
    sources = [name for name in glob.glob(f"{folder}/c/*.c") if not name.endswith("example.c")]
    subprocess.run(["cc", "-std=c99", "-O2", "-ffp-contract=off", f"-I{folder}/c", f"{folder}/timer.c",
                    *sources, "-lm", "-o", f"{folder}/timer"], check=True)
    said = subprocess.run([f"{folder}/timer"], check=True, capture_output=True, text=True).stdout
    numbers = np.array(said.split(), dtype=float)
    return numbers[:-9], np.median(numbers[-9:])


def of_mujoco(links, text):
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    data.qpos[:] = [0.3 * math.sin(i + 1) for i in range(links)]
    data.qvel[:] = [0.3 * math.sin(i + 1 + links) for i in range(links)]
    mujoco.mj_forward(model, data)
    accelerations = data.qacc.copy()
    rounds = []
    for _ in range(9):
        began = time.thread_time()
        mujoco.mj_step(model, data, nstep=20000)
        rounds.append((time.thread_time() - began) / 20000 * 1e6)
    return accelerations, np.median(rounds)


def main():
    options = argparse.ArgumentParser()
    options.add_argument("--mech", default="./mech")
    options.add_argument("links", nargs="*", type=int, default=[2, 6, 12, 24])
    given = options.parse_args()
    print("| hinges | C, µs | MuJoCo, µs | ratio | largest difference of accelerations, relative |")
    print("|---:|---:|---:|---:|---:|")
    for links in given.links:
        with tempfile.TemporaryDirectory() as folder:
            text = chain(links)
            with open(f"{folder}/chain.mjcf.xml", "w", encoding="utf-8") as file:
                file.write(text)
            ours, mine = of_c(given.mech, folder)
        theirs, yours = of_mujoco(links, text)
        off = np.abs(ours - theirs).max() / np.abs(theirs).max()
        print(f"| {links} | {mine:.3f} | {yours:.2f} | {yours / mine:.1f} | {off:.0e} |", flush=True)


if __name__ == "__main__":
    main()

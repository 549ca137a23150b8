#!/usr/bin/env python3
"""growth.py: how a frame's time grows with triangles, pixels, threads and overdraw, measured and drawn as SVG files.

  growth.py BENCH FOLDER [--processor-time]   runs BENCH, a raster_bench, and writes FOLDER/growth.json and the plots
  growth.py --plot FOLDER                     draws the plots again from FOLDER/growth.json

The plots are drawn by gnuplot (Debian: gnuplot-nox)."""
import json
import os
import subprocess
import sys

ROUNDS = 3  # the best of each row counts: on a shared machine whole rounds may be slow
THREADS = sorted({1, 2, os.cpu_count() or 1})
SWEEPS = {
    "triangles": dict(scenes=[f"torus:{n}" for n in (10**3, 10**4, 10**5, 10**6, 10**7)], sizes=["1920x1080"], threads=[1],
                      x=lambda row: row["triangles"], label="triangles (torus, Gouraud, 1920 x 1080, one thread)"),
    "pixels": dict(scenes=["s1"], sizes=[f"{n}x{n}" for n in (64, 128, 256, 512, 1024, 2048, 4096, 8192)], threads=[1],
                   x=lambda row: row["width"] * row["height"], label="pixels (s1, one thread)"),
    "threads": dict(scenes=["s1", "s3", "s5"], sizes=["1920x1080"], threads=THREADS,
                    x=lambda row: row["threads"], label="threads (1920 x 1080)"),
    "overdraw": dict(scenes=[f"layers:{n}" for n in (1, 4, 16, 64, 256)], sizes=["1920x1080"], threads=[1],
                     x=lambda row: row["triangles"] // 2, label="full-screen layers, back to front (1920 x 1080, one thread)"),
}


def measure(bench, options):
    rows = {}
    for name, sweep in SWEEPS.items():
        command = [bench, "--json", "--alone", "--frames", "7", "--warm-up", "2", "--scene", ",".join(sweep["scenes"]),
                   "--size", ",".join(sweep["sizes"]), "--threads", ",".join(map(str, sweep["threads"])), *options]
        rounds = []
        for _ in range(ROUNDS):
            run = subprocess.run(command, capture_output=True, text=True)
            if run.returncode not in (0, 1):  # 1: a row says what is wrong
                sys.exit(run.stderr)
            rounds.append(json.loads(run.stdout))
        rows[name] = [min(row, key=lambda r: r.get("ours_best", 0)) for row in zip(*rounds)]
    return rows


def plot(rows, folder):
    for name, sweep in SWEEPS.items():
        lines = {}
        for row in rows[name]:
            if "error" in row:
                sys.exit(f"growth.py: {row['error']}")
            key = row["scene"].split(":")[0]
            lines.setdefault(key, []).append((sweep["x"](row), row["ours_best"]))
        data = "".join(f"${key} << end\n" + "".join(f"{x} {y}\n" for x, y in sorted(points)) + "end\n"
                       for key, points in lines.items())
        curves = ", ".join(f"${key} with linespoints title '{key}'" for key in lines)
        scale = "set xtics 1\nset yrange [0:*]" if name == "threads" else "set logscale xy\nset format x '10^{%L}'"
        script = f"""set terminal svg size 640,400 font 'sans-serif,13' background 'white'
set output '{folder}/growth-{name}.svg'
set xlabel '{sweep["label"]}'
set ylabel 'ms a frame, best'
set key top {'right' if name == 'threads' else 'left'}
set grid
{scale}
{data}plot {curves}
"""
        subprocess.run(["gnuplot"], input=script, text=True, check=True)


def main(arguments):
    if len(arguments) == 2 and arguments[0] == "--plot":
        folder = arguments[1]
        with open(f"{folder}/growth.json", encoding="utf-8") as file:
            plot(json.load(file), folder)
    elif len(arguments) >= 2 and not arguments[0].startswith("-"):
        rows = measure(arguments[0], arguments[2:])
        with open(f"{arguments[1]}/growth.json", "w", encoding="utf-8") as file:
            json.dump(rows, file, indent=1)
            file.write("\n")
        plot(rows, arguments[1])
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main(sys.argv[1:])

#!/usr/bin/env python3
"""Whether 30 pictures get the same answer, byte for byte in JSON: with one thread and with eight, beside four other diagnoses, and by other builds.
Needs a built raycaster (RAYCASTER, or what "dotnet build -c Release src/RayCaster.Cli" leaves).
Usage: same.py [the command of another build, as one argument…]"""
import concurrent.futures, csv, os, shlex, subprocess, sys
import foreign

rows = list(csv.DictReader(open(foreign.here / "expected.csv")))
rows = rows[::len(rows) // 30][:30]


def answer(row, *command, threads=1):
    done = subprocess.run([*(command or [foreign.raycaster]), "diagnose", foreign.here / "scenes" / row["scene"],
                           foreign.here / "pictures" / (row["picture"] + ".png"), "--json", "--done", foreign.FINISHED, "-t", str(threads)],
                          capture_output=True, text=True)
    return done.stdout or done.stderr


def beside_others(row):
    with concurrent.futures.ThreadPoolExecutor(5) as pool:
        return [pool.submit(answer, row, threads=2) for _ in range(5)][0].result()


ways = {"eight threads": lambda row: answer(row, threads=8), "beside four others": beside_others}
ways |= {command: lambda row, command=command: answer(row, *shlex.split(command)) for command in sys.argv[1:]}
different = 0
for row in rows:
    alone = answer(row)
    for way, ask in ways.items():
        if ask(row) != alone:
            print(f"{row['picture']}: {way} says something else than one thread alone")
            different += 1
print(f"{len(rows)} pictures, {len(ways) + 1} ways: {different} answers differ")
sys.exit(1 if different else 0)

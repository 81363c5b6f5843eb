#!/usr/bin/env python3
"""Asks "diagnose" about every picture of expected.csv, prints each answer that is wrong and a table, and fails if too many are or
it fails itself.
README.md says how an answer is counted. Needs a built raycaster (RAYCASTER, or what "dotnet build -c Release src/RayCaster.Cli" leaves).
Usage: foreign.py [what the names of the pictures contain…]"""
import collections, concurrent.futures, csv, json, os, pathlib, statistics, struct, subprocess, sys, tempfile, zlib

here = pathlib.Path(__file__).resolve().parent
raycaster = os.environ.get("RAYCASTER", str(here.parents[2] / "src/RayCaster.Cli/bin/Release/net10.0/raycaster"))
FINISHED = "plane,sphere,aabb,circle,triangle,attenuation,clipping"  # the three programs draw all of it
LEAST = {"single, first": 93, "single, in three": 95, "pair, one": 84, "right": 100, "foreign": 100}


def diagnose(row):
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        process = subprocess.Popen([raycaster, "diagnose", here / "scenes" / row["scene"], here / "pictures" / (row["picture"] + ".png"),
                                    "--json", "--done", FINISHED, "-t", "1"], stdout=out, stderr=err)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        out.seek(0), err.seek(0)
        if process.returncode not in (0, 1):
            return {"finding": err.read().decode().splitlines()[0], "failed": True}, 0
        return json.loads(out.read()), usage.ru_utime + usage.ru_stime


def named(answer):
    """The suspects that are named, as lists of the sets of mistakes that would draw the suspect's picture; the first, then the less likely."""
    if answer["finding"] not in ("mistake", "unfinished"):
        return []
    groups = []
    for suspect in answer["suspects"]:
        same = [frozenset(m["id"] for m in suspect["mistakes"])] + [frozenset([twin]) for twin in suspect["twins"]]
        if groups and suspect["rank"] == "as likely":
            groups[0] += same
        else:
            groups.append(same)
    return groups


def tells_nothing(row, answer):
    """Whether that is the answer, and right: a picture of one colour shows no mistake of its own."""
    data = (here / "pictures" / (row["picture"] + ".png")).read_bytes()
    start = data.index(b"IDAT") + 4
    lines = zlib.decompress(data[start:data.index(b"IEND", start) - 8])
    width, height = struct.unpack(">II", data[16:24])
    plain = b"\2" + lines[1:4] * width + (b"\2" + bytes(3 * width)) * (height - 1)  # each line is the difference from the one above
    return answer["finding"] == "tells nothing" and lines == plain


def judge(row, answer):
    """What is asked of the answer, and whether it holds; nothing does if there is none."""
    asked = expected(row, answer)
    return dict.fromkeys(asked, False) if "failed" in answer else asked


def expected(row, answer):
    if row["mistakes"] == "right":
        return {"right": answer["finding"] == "matches"}
    suspects = named(answer)
    if row["mistakes"] == "none":
        return {"foreign": not suspects and answer["finding"] != "matches"}
    planted = frozenset(row["mistakes"].split("+"))
    empty = tells_nothing(row, answer)
    if len(planted) == 1:
        return {"single, first": empty or planted in sum(suspects[:1], []), "single, in three": empty or planted in sum(suspects[:3], [])}
    first = sum(suspects[:1], [])
    return {"pair, one": empty or any(planted & guess for guess in first), "pair, both": empty or planted in first}


def words(answer):
    suspects = [" = ".join("+".join(sorted(guess)) for guess in group) for group in named(answer)[:3]]
    return answer["finding"] + (": " + ", then ".join(suspects) if suspects else "")


def main():
    parts = sys.argv[1:] or [""]
    with open(here / "expected.csv", newline="") as file:
        rows = [row for row in csv.DictReader(file) if any(part in row["picture"] for part in parts)]
    counts, empty, times, failed = collections.defaultdict(list), 0, [], False
    pool = concurrent.futures.ThreadPoolExecutor(os.cpu_count())
    for row, (answer, time) in zip(rows, pool.map(diagnose, rows)):
        times.append(time)
        verdict = judge(row, answer)
        failed |= "failed" in answer
        empty += tells_nothing(row, answer)
        for name, holds in verdict.items():
            counts[name].append(holds)
        if not all(verdict.values()):
            wrong = ", not ".join(name for name, holds in verdict.items() if not holds)
            print(f"{row['picture']} of {row['scene']}, not {wrong}: {words(answer)}", flush=True)
    print(f"\n{'':18}  right   of      %  least")
    for name, holds in counts.items():
        percent, least = 100 * sum(holds) / len(holds), LEAST.get(name, 0)
        failed |= percent < least
        print(f"{name:18} {sum(holds):6} {len(holds):4} {percent:6.1f} {least or '':6}")
    print(f"{empty} of them tell nothing: they are of one colour")
    print(f"processor time of a picture, s: mean {statistics.mean(times):.2f}, median {statistics.median(times):.2f}, greatest {max(times):.2f}")
    sys.exit(failed)


if __name__ == "__main__":
    main()

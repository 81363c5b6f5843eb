#!/usr/bin/env python3
"""Plants the slips of a file, one at a time, in a hand-out that is written up to the slip's step, runs what its README says (draw, --pixel, the
step's tests), and judges whether the first screen that tells of something wrong leads to the slip. Needs a built raycaster (RAYCASTER, or what
"dotnet build -c Release src/RayCaster.Cli" leaves) and the hand-out's test packages.
Usage: slips.py [which slips: 3 for each third one [a file like slips.txt]]"""
import collections, os, pathlib, re, subprocess, sys, tempfile

here = pathlib.Path(__file__).resolve().parent
root = here.parents[2]
raycaster = os.environ.get("RAYCASTER") or root / "src/RayCaster.Cli/bin/Release/net10.0/raycaster"
BODY = re.compile(r'( *// BEGIN SOLUTION "([^"\n]+)"\n)(.*?)( *// END SOLUTION\n)', re.S)


def run(lab, *command):
    done = subprocess.run([str(part) for part in command], cwd=lab, capture_output=True, text=True, timeout=600)
    return done.returncode, done.stdout + done.stderr


def read(file):
    """The slips: step, file, names, right text, slip."""
    found = []
    for line in file.read_text().splitlines():
        if header := re.match(r"(\d+) (\S+\.cs) (.*)", line):
            found.append([int(header[1]), header[2], header[3].split("  "), "", ""])
        elif line[:2] in ("- ", "+ "):
            found[-1][3 if line[0] == "-" else 4] = line[2:]
    return found


def named(text, names):
    return any(re.search(r"(?<![\w²])" + re.escape(name) + r"(?![\w²])", text) for name in names)


def screen_of_pixel(said):
    """The first wrong line, its slides, and the numbers below it that are wrong, or whose own are not known."""
    lines = said.splitlines()
    for i, line in enumerate(lines):
        if "the first wrong value" in line:
            below = [text.strip() for text in lines[i + 1:] if text.startswith("    ")]
            text = "\n".join([line.split(": yours")[0]] + [text.split(":")[0] for text in below if "right" in text])
            return text, re.search(r'Slide "(.*)"', line)[1].split('" or "')


def screen_of_tests(said):
    failed = re.search(r"Error Message:\n(.*?)Slide \"([^\"]*)\"", said, re.S)
    return (failed[1], [failed[2]]) if failed else (said, [""]) if re.search(r"\[FAIL\]|Failed Lab", said) else None


def main(slips):
    counts = collections.Counter()
    with tempfile.TemporaryDirectory() as folder:
        lab = pathlib.Path(folder) / "lab"
        subprocess.run([raycaster, "handout", "-q", lab], check=True)
        step_of = {slide: int(step) for step, slide in re.findall(r'\((\d+), "([^"]+)", "', (lab / "src/Lab/Template/Todo.cs").read_text())}
        open_files = {file.name: file.read_text() for file in (lab / "src/Lab").glob("*.cs")}
        solved = {name: (root / "src/RayCaster.Lab" / name).read_text() for name in open_files}
        bodies = {name: [re.sub(r" *// STUB.*\n", "", body[3]) for body in BODY.finditer(text)] for name, text in solved.items()}
        file_of = {body[2]: name for name, text in open_files.items() for body in BODY.finditer(text)}
        readme = (lab / "README.md").read_text()
        for step, file, names, right, slip in slips:
            for name, text in open_files.items():
                written = iter(bodies[name])
                text = BODY.sub(lambda body: body[1] + (next(written), body[3])[step_of[body[2]] > step] + body[4], text)
                if name == file:
                    # in the step's own body: Ray.cs and Camera.cs have those of two
                    place = next((body for body in BODY.finditer(text) if step_of[body[2]] == step and right in body[3]), None)
                    if place is None: sys.exit(f"{file} does not have \"{right}\" in a body of step {step}")
                    at = text.index(right, place.start(3))
                    text = text[:at] + slip + text[at + len(right):]
                (lab / "src/Lab" / name).write_text(text)
            failed, said = run(lab, "dotnet", "build", "tests/Lab.Tests", "-v", "q")
            if failed: sys.exit(f"the slip \"{slip}\" does not build\n{said}")
            part = readme.split(f"## Step {step}:")[1].split("\n## ")[0]
            commands = re.findall(r"dotnet run --project src/Lab -- (.*)", part) if step > 3 else ["scenes/room.json --pixel 325 359"]
            screen, by = None, "nothing"
            for command in commands:
                failed, said = run(lab, "dotnet", "src/Lab/bin/Debug/net10.0/Lab.dll", *command.split())
                if "--pixel" in command and (screen := screen_of_pixel(said)): by = "--pixel"
                if place := re.search(r"src/Lab/(\w+\.cs)\(\d+\): ", said): # an exception
                    screen, by = (" ".join(names), [slide for slide in file_of if file_of[slide] == place[1]]), "draw"
                if screen: break
            if not screen:
                failed, said = run(lab, "dotnet", "test", "--no-build", "--filter", f"step={step}")
                if failed: screen, by = screen_of_tests(said) or ("", [""]), "tests"
            text, slides = screen or ("", [])
            steps = {step_of.get(slide) for slide in slides}
            result = "unnoticed" if not screen else "misled" if step not in steps \
                else "line" if any(file_of[slide] == file for slide in slides if step_of.get(slide) == step) and named(text, names) else "step"
            counts[step, result] += 1
            counts[result] += 1
            print(f"{result:9} step {step:2} {file:11} {slip}  ({by}{': ' + slides[0] if slides else ''})", flush=True)
            if result != "line": print("          " + text.strip().replace("\n", "\n          ")[:600], flush=True)
    results = ["line", "step", "misled", "unnoticed"]
    print(f"{'step':>5} " + " ".join(f"{result:>9}" for result in results))
    for step in range(1, 11): print(f"{step:5} " + " ".join(f"{counts[step, result]:9}" for result in results))
    print(f"{'all':>5} " + " ".join(f"{counts[result]:9}" for result in results))
    # The same limits for any number of slips: 55 of 60 are led to their line, none is misled, none is not noticed.
    return counts["line"] * 60 < 55 * len(slips) or counts["misled"] or counts["unnoticed"]


if __name__ == "__main__":
    each = int(sys.argv[1]) if len(sys.argv) > 1 else 1
    sys.exit(1 if main(read(pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else here / "slips.txt")[each // 2::each]) else 0)

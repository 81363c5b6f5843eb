#!/usr/bin/env python3
"""What a student waits for, in multiples of what an empty project of the same SDK takes on the same machine.

    python3 tests/Tools/Benchmarks/loop.py      the whole table, least of five; some minutes on a machine that does nothing else
    python3 tests/Tools/Benchmarks/loop.py --rounds 3

Works in a copy of the project's files, changes nothing here, and prints the table of CONTRIBUTING.md. It fails if a row is above its limit.
"""
import argparse, os, pathlib, re, shutil, subprocess, sys, tempfile, time

ROOT = pathlib.Path(__file__).resolve().parents[3]
SPHERE, LAB_SPHERE = "src/RayCaster/Shapes/Sphere.cs", "src/RayCaster.Lab/Sphere.cs"
ENVIRONMENT = dict(os.environ, DOTNET_NOLOGO="1", DOTNET_CLI_TELEMETRY_OPTOUT="1")
ENVIRONMENT.pop("Strict", None)

CONSOLE = """<Project Sdk="Microsoft.NET.Sdk">
  <PropertyGroup><OutputType>Exe</OutputType><TargetFramework>net10.0</TargetFramework></PropertyGroup>
</Project>
"""
XUNIT = """<Project Sdk="Microsoft.NET.Sdk">
  <PropertyGroup><OutputType>Exe</OutputType><TargetFramework>net10.0</TargetFramework></PropertyGroup>
  <ItemGroup>{packages}</ItemGroup>
</Project>
"""


def copy_project(target):
    """The files that git knows, as they are now: what a fresh clone holds."""
    names = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, check=True).stdout.decode().split("\0")
    for name in filter(None, names):
        if (ROOT / name).is_file():
            (target / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(ROOT / name, target / name)


def write_empty_projects(folder):
    packages = "".join(re.findall(r"<PackageReference [^>]*/>", (ROOT / "tests/Directory.Build.props").read_text()))
    for name, project in (("console", CONSOLE), ("tests", XUNIT.format(packages=packages))):
        (folder / name).mkdir(parents=True)
        (folder / name / f"{name}.csproj").write_text(project)
        shutil.copyfile(ROOT / "global.json", folder / name / "global.json")
    edit_console(folder / "console", 0)
    edit_xunit(folder / "tests", 0)


def edit_console(folder, i):
    (folder / "Program.cs").write_text(f'System.Console.WriteLine("Hello {i}");\n')


def edit_xunit(folder, i):
    (folder / "Tests.cs").write_text(f"public class Tests {{ [Xunit.Fact] public void Adds() => Xunit.Assert.Equal({i + 1}, {i} + 1); }}\n")


def edit_sphere(clone, i, sphere=SPHERE, radius="Radius"):
    """Another body of the same meaning: what is added to R is lost in rounding."""
    file = clone / sphere
    text = file.read_text()
    changed = re.sub(rf"(?:\b{radius}|\({radius} \+ 1e-\d+\)) \* {radius}\b", f"({radius} + 1e-{300 - i}) * {radius}", text, count=1)
    assert changed != text, f"{sphere} has no line to edit"
    file.write_text(changed)


def seconds(folder, *command):
    start = time.perf_counter()
    done = subprocess.run(command, cwd=folder, env=ENVIRONMENT, capture_output=True, text=True)
    taken = time.perf_counter() - start
    if done.returncode:
        sys.exit(f"{' '.join(command)} in {folder} ends with {done.returncode}:\n{done.stdout}{done.stderr}")
    return taken


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--rounds", type=int, default=5, help="how often each is measured; the least counts")
    rounds = arguments.parse_args().rounds
    draw = ("dotnet", "run", "--project", "src/RayCaster.Cli", "--", "scenes/room.json", "-o", "room.png", "-q")
    draw_lab = ("dotnet", "run", "--project", "src/RayCaster.Lab", "--", "scenes/room.json")
    empty_run, empty_test = ("dotnet", "run"), ("dotnet", "test")
    course = ("dotnet", "test", "--project", "tests/RayCaster.Tests")
    everything = ("dotnet", "test", "-c", "Release")

    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        clone, console, xunit = folder / "clone", folder / "console", folder / "tests"
        write_empty_projects(folder)
        seconds(console, *empty_run)  # the compiler's server is there from now on
        seconds(xunit, *empty_test)

        first, minimum = [], []
        for _ in range(min(rounds, 3)):
            for times, commands in ((first, [draw]), (minimum, [("dotnet", "build", "src/RayCaster.Cli", "-v", "quiet"),
                                                               ("dotnet", "src/RayCaster.Cli/bin/Release/net10.0/raycaster.dll", *draw[5:])])):
                shutil.rmtree(clone, ignore_errors=True)
                copy_project(clone)
                times.append(sum(seconds(clone, *command) for command in commands))

        seconds(clone, *everything)  # builds all
        pairs = {"sphere": ([], []), "lab": ([], []), "tests": ([], [])}
        for i in range(1, rounds + 1):
            edit_console(console, i)
            pairs["sphere"][1].append(seconds(console, *empty_run))
            edit_sphere(clone, i)
            pairs["sphere"][0].append(seconds(clone, *draw))
            edit_console(console, i + 100)
            pairs["lab"][1].append(seconds(console, *empty_run))
            edit_sphere(clone, i, LAB_SPHERE, "R")
            pairs["lab"][0].append(seconds(clone, *draw_lab))
            edit_xunit(xunit, i)
            pairs["tests"][1].append(seconds(xunit, *empty_test))
            edit_sphere(clone, i + 100)
            pairs["tests"][0].append(seconds(clone, *course))
        for sphere in (SPHERE, LAB_SPHERE):
            shutil.copyfile(ROOT / sphere, clone / sphere)  # some tests quote its lines
        seconds(clone, "dotnet", "build", "-c", "Release")
        all_tests = min(seconds(clone, *everything) for _ in range(2))

    def ratio(name):
        return min(pairs[name][0]) / min(pairs[name][1])

    rows = [
        ("edit a body in `Sphere.cs`, then `dotnet run … scenes/room.json`", "an empty console project's edit and run", ratio("sphere"), 1.8),
        ("edit a body in the lab's `Sphere.cs`, then `dotnet run` it", "an empty console project's edit and run", ratio("lab"), 1.6),
        ("edit `Sphere.cs`, then `dotnet test --project tests/RayCaster.Tests`", "an empty xunit project's edit and test", ratio("tests"), 2.5),
        ("all of `dotnet test -c Release`, built", "an empty xunit project's edit and test", all_tests / min(pairs["tests"][1]), 14),
        ("the first `dotnet run` of a fresh clone", "building the five projects and running what was built", min(first) / min(minimum), 1.3),
    ]
    print("| what | in multiples of | measured | at most |\n|---|---|--:|--:|")
    for what, of, measured, limit in rows:
        print(f"| {what} | {of} | {measured:.2f} | {limit} |")
    sys.exit(any(measured > limit for _, _, measured, limit in rows))


if __name__ == "__main__":
    main()

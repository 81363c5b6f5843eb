#!/usr/bin/env bash
# docs/draw-class.sh over eight submissions, six of them hostile or broken: the right one gets full marks, nothing of the others survives, and no
# file outside changes. Needs Linux, bubblewrap, GNU parallel and python3.
set -euo pipefail
cd "$(dirname "$0")/../.."
for program in bwrap parallel prlimit python3 setpriv; do
    command -v "$program" >/dev/null || { echo "$program is missing"; exit 77; }
done
export DOTNET_NOLOGO=1 DOTNET_CLI_TELEMETRY_OPTOUT=1
work=$(mktemp -d)
trap 'kill "$listener" 2>/dev/null; rm -rf "$work"' EXIT
failed=0
check() { # what must hold, a command
    if "${@:2}"; then echo "ok: $1"; else echo "FAILED: $1"; failed=1; fi
}
not() { ! "$@"; }

echo "== the class"
dotnet build src/RayCaster.Cli -v q
dotnet build src/RayCaster.Live -v q
raycaster() { dotnet src/RayCaster.Cli/bin/Release/net10.0/raycaster.dll "$@"; }
mkdir -p "$work"/{submissions,scenes,home/.ssh,marks}
cp docs/draw-class.sh "$work"
cp scenes/weeks/1-planes.json scenes/weeks/3-spheres.json "$work/scenes"
echo "a key of the teacher's" >"$work/home/.ssh/id_rsa"
echo "marks of the class" >"$work/marks/marks.csv"
raycaster handout -q "$work/handout"
raycaster handout -q "$work/submissions/right" --solution
for name in wrong broken loop forks memory thief network; do cp -r "$work/submissions/right" "$work/submissions/$name"; done
code() { cat >"$work/submissions/$1/src/Lab/Evil.cs"; }
starts() { # a submission whose program does this before it draws
    code "$1" <<<"static class Evil { [System.Runtime.CompilerServices.ModuleInitializer] internal static void Do() { $2 } }"
}
sed -i 's/Math.Sqrt(R \* R - D \* D)/Math.Sqrt(R - D * D)/; s/D \* D > R \* R/D * D > R/' "$work/submissions/wrong/src/Lab/Sphere.cs"
code broken <<<"this is not C#"
starts loop 'while (true) { }'
starts forks 'System.Diagnostics.Process.Start("bash", ["-c", ":() { : | : & }; :"]); Thread.Sleep(-1);'
starts memory 'var all = new List<byte[]>(); for (var i = 1; i <= 40; i++) { var more = new byte[100_000_000]; Array.Fill(more, (byte)i);
    all.Add(more); Console.Error.WriteLine($"{i} of 40 parts"); }'
starts thief "foreach (var file in new[] { \"$work/home/.ssh/id_rsa\", \"$work/marks/marks.csv\", \"$work/out/right/1-planes.png\" })
    { try { Console.Error.WriteLine(File.ReadAllText(file)); } catch { } try { File.WriteAllText(file, \"stolen\"); } catch { } }
    try { File.WriteAllText(\"/submission/src/Lab/Sphere.cs\", \"stolen\"); } catch { }"
python3 -u -m http.server 0 --bind 127.0.0.1 --directory "$work/scenes" >"$work/server.log" 2>&1 &
listener=$!
for _ in $(seq 50); do port=$(sed -n 's/.* port \([0-9]*\) .*/\1/p' "$work/server.log"); [ -z "$port" ] || break; sleep 0.2; done
starts network "try { Console.Error.WriteLine(new HttpClient().GetStringAsync(\"http://127.0.0.1:$port/\").Result); } catch { }"

user=() # an ordinary user: root becomes one that owns nothing
if [ "$(id -u)" = 0 ]; then
    user=(setpriv --reuid 65534 --regid 65534 --clear-groups)
    chown -R 65534:65534 "$work"
fi
as() { "${user[@]}" env HOME="$work/home" DOTNET_CLI_HOME="$work/home" "$@"; }
(cd "$work/handout" && as dotnet restore -v q) # the sandbox has no network, so the packages of the tests come from the teacher's home
files() { (cd "$work" && find submissions handout scenes marks home/.ssh -type f ! -path '*/obj/*' -exec sha256sum {} + | sort -k 2); }
files >"$work/before"

echo "== its pictures"
cd "$work"
build='cp -r /submission/. . && dotnet build src/Lab -c Release'
check "it asks for the hand-out" not as ./draw-class.sh submissions scenes none 2>"$work/said"
check "it says how" grep -q "^set HANDOUT to the folder of your hand-out" "$work/said"
check "the class is drawn" as env HANDOUT= BUILD="$build" TESTS= LIMIT=40 ./draw-class.sh submissions scenes out
check "the tests run" as env HANDOUT="$work/handout" ./draw-class.sh submissions scenes tested right
cd - >/dev/null
files >"$work/after"
check "no file has changed" diff "$work/before" "$work/after"
check "no process is left" not pgrep ${user:+-u 65534} -f "Lab.dll|: \| : &"
check "nothing was fetched from this machine" not grep GET "$work/server.log"
check "nothing was read" not grep -rqE "a key of the teacher|marks of the class" "$work/out"
check "memory has a limit" not grep -q "40 of 40 parts" "$work/out/memory/log.txt"
check "the tests' results are there" grep -q 'failures="0"' "$work/tested/right/results.xml"
check "a build that fails is told" grep -q "broken: the build failed" "$work/out/broken/log.txt"

echo "== their marks"
cat >"$work/rubric.json" <<'RUBRIC'
{
  "title": "Two scenes", "scenes": ["scenes/1-planes.json", "scenes/3-spheres.json"], "pictures": "{name}.png",
  "items": [
    { "name": "Planes", "points": 2, "mistakes": ["plane-sign"], "undone": ["plane"] },
    { "name": "Spheres", "points": 2, "mistakes": ["r-nosq"], "undone": ["sphere"] }
  ]
}
RUBRIC
check "the class is marked" raycaster mark "$work/rubric.json" "$work/out" -o "$work/result" -q
cat "$work/result/marks.csv"
for name in right thief network; do check "$name has full marks" grep -qE "^\"?$name\"?,4," "$work/result/marks.csv"; done
check "wrong has half of them" grep -qE "^\"?wrong\"?,2," "$work/result/marks.csv"
for name in broken loop forks; do check "$name has none" grep -qE "^\"?$name\"?,0," "$work/result/marks.csv"; done
exit $failed

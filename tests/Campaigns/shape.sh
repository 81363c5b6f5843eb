#!/usr/bin/env bash
# Adds a shape to a copy of the project by docs/adding-a-primitive.md alone, and checks that the page keeps its promises: the scalar shape and the
# formula draw the same picture, and a mistake planted in the formula is found.
#
#     tests/Campaigns/shape.sh
set -euo pipefail
cd "$(dirname "$0")/../.."
export DOTNET_NOLOGO=1
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
git ls-files -z | tar --null -T - -cf - | tar -xf - -C "$copy"
cd "$copy"

raycaster() { dotnet src/RayCaster.Cli/bin/Release/net10.0/raycaster.dll "$@"; }
build() { dotnet build src/RayCaster.Cli -v quiet >build.txt 2>&1 || { cat build.txt; exit 1; }; }
block() { # the code block of the page in which a text stands
    python3 - "$1" <<'END'
import re, sys
blocks = re.findall(r"```\w+\n(.*?)```", open("docs/adding-a-primitive.md").read(), re.S)
print([block for block in blocks if sys.argv[1] in block][0], end="")
END
}
insert() { # FILE LINE: what is read, before the first line that contains a text
    python3 -c '
import sys
file, line = sys.argv[1:]
lines = open(file).read().split("\n")
at = next(i for i, text in enumerate(lines) if line in text)
open(file, "w").write("\n".join(lines[:at] + sys.stdin.read().rstrip().split("\n") + lines[at:]))' "$1" "$2"
}
list=src/RayCaster.Files/Scenes/PrimitiveList.cs
steps=src/RayCaster.Teaching/Formulas/StepKind.cs
cat >tube.json <<'END'
{ "camera": { "position": [-8, 1, 2], "target": [0, 0, 0], "width": 200, "height": 150 },
  "models": [ { "type": "plane", "point": [0, 0, -1], "normal": [0, 0, 1], "color": [0.3, 0.6, 0.3] },
              { "type": "cylinder", "center": [0, 0, 0.2], "radius": 1.5, "height": 2.2, "color": [0.9, 0.4, 0.2] } ] }
END

block 'class Cylinder' >src/RayCaster/Shapes/Cylinder.cs
block 'new Cylinder(' | insert $list 'new("triangle"'
build
raycaster tube.json -o scalar.png

block 'struct Tube' >src/RayCaster/Shapes/Tube.cs
block 'new Cylinder(' | sed 's/"cylinder"/"tube"/; s/new Cylinder(/Model.Of(new Tube(/; s/Limits.Positive)))/Limits.Positive))))/' |
    insert $list 'new("triangle"'
echo '    Tube,' | insert $steps '    Triangle,'
block 'StepKind.Tube' | insert $steps 'new("mesh"'
{ echo; block '[tube]'; } >>src/RayCaster.Teaching/Formulas/Shapes.txt
sed -i 's/"cylinder"/"tube"/' tube.json
build
raycaster tube.json -o formula.png
raycaster compare formula.png scalar.png
raycaster diagnose tube.json formula.png | tee said.txt
grep -q 'formula.png matches' said.txt

sed -i 's/- Radius \* Radius/- Radius/' src/RayCaster/Shapes/Tube.cs
build
raycaster tube.json -o wrong.png
sed -i 's/- Radius)/- Radius * Radius)/' src/RayCaster/Shapes/Tube.cs
build
raycaster diagnose tube.json wrong.png --hint answer | tee said.txt || true
grep -q 'R was written instead of R² in c' said.txt
echo "docs/adding-a-primitive.md: a shape, its pictures and its hints."

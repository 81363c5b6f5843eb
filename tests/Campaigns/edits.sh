#!/usr/bin/env bash
# What is read is what draws: edits lines that README shows, one at a time, in a copy of the project, builds, and draws scenes/room.json small, by
# the definition, and large, by the engine. Of each the picture must change, or a message must say why not. An edit of the engine must be noticed,
# and not change the picture. The JSON of diagnose warns of an edit of the course, too.
#
#     tests/Campaigns/edits.sh [k/n]     only the edits k, k + n, k + 2 n, …; all with WHOLE=yes
set -euo pipefail
cd "$(dirname "$0")/../.."
export DOTNET_NOLOGO=1
unset Strict # an edit may leave a variable unused
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
git ls-files -z | tar --null -T - -cf - | tar -xf - -C "$copy"
cd "$copy"
passed=0 failed=0 number=0
IFS=/ read -r part parts <<<"${1:-1/1}"
[ -z "${WHOLE:-}" ] || parts=1

raycaster() { dotnet src/RayCaster.Cli/bin/Release/net10.0/raycaster.dll "$@"; }

draw() { # draws small.png and large.png; the messages, if there are any, are in small.txt and large.txt
    rm -f small.* large.*
    dotnet build src/RayCaster.Cli -v quiet --no-restore >build.txt 2>&1 || { cat build.txt; echo "does not build"; return 1; }
    raycaster scenes/room.json -o small.png 2>&1 | grep -v 'rays per second' >small.txt || true
    raycaster scenes/room.json -o large.png --size 1200x1200 2>&1 | grep -v 'rays per second' >large.txt || true
}

changed() { # small or large: whether there is a message or another picture
    [ -s "$1.txt" ] || ! cmp -s "$1.png" "right-$1.png"
}

verdict() { # name, 0 if it holds, what is wrong otherwise
    if [ "$2" = 0 ]; then passed=$((passed + 1)); echo "ok     $1"; else failed=$((failed + 1)); echo "FAILED $1: $3"; fi
}

edit() { # name, file, sed expression
    number=$((number + 1))
    [ $(((number - part) % parts)) = 0 ] || return 0
    cp "$2" kept.cs
    sed -i "$3" "$2"
    if cmp -s "$2" kept.cs; then verdict "$1" 1 "the edit changes nothing in $2"
    elif ! draw >said.txt; then verdict "$1" 1 "$(cat said.txt)"
    elif ! changed small; then verdict "$1" 1 "neither the small picture nor a message changes"
    elif ! changed large; then verdict "$1" 1 "neither the large picture nor a message changes"
    else verdict "$1$(cat small.txt large.txt | sed 's/^/ (/; s/$/)/; q')" 0
    fi
    cp kept.cs "$2"
}

dotnet restore src/RayCaster.Cli -v quiet
draw
cat small.txt large.txt
if [ -s small.txt ] || [ -s large.txt ]; then echo "unchanged, and yet there are messages"; exit 1; fi
mv small.png right-small.png
mv large.png right-large.png

course=src/RayCaster
edit "upside down"               $course/Scene/ScalarRenderer.cs 's/scene.Camera.Height - 1 - line/line/'
edit "the last hit wins"         $course/Scene/ScalarRenderer.cs   's/ && Ray.IsNearer<Scalar>(t, nearest.T).Holds//'
edit "the farthest hit wins"     $course/Rays/Ray.cs               's/=> t < nearest;/=> t > nearest;/'
edit "half the light"            $course/Scene/Scene.cs \
    's/: Attenuation<Scalar>(nearest.T)/: 0.5 * Attenuation<Scalar>(nearest.T)/'
edit "attenuation"               $course/Scene/Scene.cs          's|1 - t / Camera.FadeDistance|1 - t / (2 * Camera.FadeDistance)|'
edit "red and blue swapped"      $course/Vectors/Color.cs             's/(ToByte(R), ToByte(G), ToByte(B))/(ToByte(B), ToByte(G), ToByte(R))/'
edit "colour times number"       $course/Vectors/Color.cs             's/attenuation \* color.G/color.G/'
edit "truncated, not rounded"    $course/Vectors/Color.cs             's/ \* 255 + 0.5/ * 255/'
edit "the picture's indexer"     $course/Scene/Picture.cs \
    's/(Rgb\[i\], Rgb\[i + 1\], Rgb\[i + 2\]) = value/(Rgb[i + 2], Rgb[i + 1], Rgb[i]) = value/'
edit "h without the 2"           $course/Scene/Camera.cs            's/planeHeight = 2 \* Math.Tan/planeHeight = Math.Tan/'
edit "the ray of a pixel"        $course/Scene/Camera.cs            's/Direction<Scalar>(column, row);/Direction<Scalar>(column, row + 1);/'
edit "the clip range"            $course/Rays/ClipRange.cs         's/z >= zNear;/z <= zNear;/'
edit "dot product"               $course/Vectors/Vector3OfN.cs   's/a.X \* b.X + a.Y \* b.Y/a.X * b.X - a.Y * b.Y/'
edit "cross product"             $course/Vectors/Vector3.cs      's/a.Z \* b.X - a.X \* b.Z/a.X * b.Z - a.Z * b.X/'
edit "plane"                     $course/Shapes/Plane.cs             's/(Point - ray.Origin) \* Normal/(ray.Origin - Point) * Normal/'
edit "sphere"                    $course/Shapes/Sphere.cs            's/Radius \* Radius - D \* D/Radius - D * D/'
edit "box"                       $course/Shapes/Aabb.cs              's/var hit = t_min <= t_max/var hit = t_min >= t_max/'
edit "circle"                    $course/Shapes/Circle.cs            's/Radius \* Radius/Radius/'
edit "triangle"                  $course/Shapes/Triangle.cs          's/((u >= 0) & (v >= 0) & (w >= 0))/((u >= 0) \& (v >= 0))/'
edit "the models' first hit"     $course/Rays/Model.cs \
    's/return crossings.Near;/return 0.5 * crossings.Near;/'
edit "the scene's reader"        src/RayCaster.Files/Scenes/SceneReader.cs 's/"width"/"wide"/'
edit "the picture's writer"      src/RayCaster.Files/Pictures/PictureWriter.cs 's/        Encode(rgb);/        Encode(new byte[rgb.Length]);/'

cp -r src/RayCaster.Engine/Numbers kept
sed -i 's/a.Lanes + b.Lanes/a.Lanes - b.Lanes/' src/RayCaster.Engine/Numbers/*Packet.cs
draw
cmp -s small.png right-small.png && [ ! -s small.txt ] && result=0 || result=1
verdict "an edit of the engine does not change a small picture" "$result" "$(cat small.txt)"
grep -q "the engine's picture is not the definition's at column .* The definition draws the picture" large.txt && result=0 || result=1
verdict "a large picture says that the engine is wrong" "$result" "$(cat large.txt)"
cmp -s large.png right-large.png && result=0 || result=1
verdict "and is right" "$result" "it differs"
cp kept/* src/RayCaster.Engine/Numbers

sed -i 's/Radius \* Radius - D \* D/Radius - D * D/' $course/Shapes/Sphere.cs
draw
raycaster diagnose scenes/room.json right-small.png --json >said.json 2>/dev/null || true
grep -q '"warning": "src/RayCaster has been changed' said.json && result=0 || result=1
verdict "diagnose --json says that src/RayCaster was changed" "$result" "$(head -3 said.json)"

sed -i 's/return new(t_ca - t_hc/if (Radius < 9) throw new Exception("boom"); &/' $course/Shapes/Sphere.cs
draw
# "in Model" where the runtime has inlined the formula
grep -qE 'Exception in (Sphere|Model): boom' small.txt && grep -qE 'Exception in (Sphere|Model): boom' large.txt && result=0 || result=1
verdict "a formula's exception is shown" "$result" "$(cat small.txt large.txt)"
sed -i 's/if (Radius < 9) throw[^;]*;/return new(N.Sqrt(-1));/' $course/Shapes/Sphere.cs
draw
raycaster models scenes/room.json >said.txt
grep -q "ball does not show: it is missed by every ray" said.txt && result=0 || result=1
verdict "models says that every ray misses" "$result" "$(cat said.txt)"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]

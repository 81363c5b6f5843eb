#!/usr/bin/env bash
# What is read is what draws: edits lines that README shows, one at a time, in a copy of the project, builds, draws scenes/room.json, and
# wants the picture or a message to change. The JSON of diagnose, compare and check warns of an edit, too.
set -euo pipefail
cd "$(dirname "$0")/../.."
export DOTNET_NOLOGO=1
unset Strict # an edit may leave a variable unused
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
git ls-files -z src scenes tests/References Directory.Build.props global.json .editorconfig | tar --null -T - -cf - | tar -xf - -C "$copy"
cd "$copy"
passed=0 failed=0

draw() { # options; prints the message, if there is one; the picture is new.png
    dotnet build src/RayCaster.Cli -v quiet --no-restore >build.txt 2>&1 || { cat build.txt; echo "does not build"; return 1; }
    rm -f new.png
    dotnet src/RayCaster.Cli/bin/Release/net10.0/raycaster.dll scenes/room.json -o new.png "$@" 2>&1 | grep -v 'rays per second' || true
}

edit() { # name, file, sed expression
    cp "$2" kept.cs
    sed -i "$3" "$2"
    if cmp -s "$2" kept.cs; then echo "FAILED $1: the edit changes nothing in $2"; failed=$((failed + 1)); return; fi
    local message
    if ! message=$(draw); then
        echo "FAILED $1: $message"; failed=$((failed + 1)); cp kept.cs "$2"; return
    fi
    if [ -n "$message" ] || ! cmp -s new.png right.png; then
        passed=$((passed + 1)); echo "ok     $1 ${message:+($message)}"
    else
        failed=$((failed + 1)); echo "FAILED $1: $2 was changed, the picture and the messages were not"
    fi
    cp kept.cs "$2"
}

dotnet restore src/RayCaster.Cli -v quiet
message=$(draw)
[ -z "$message" ] || { echo "unchanged, and yet: $message"; exit 1; }
mv new.png right.png

course=src/RayCaster
edit "upside down"               $course/Rendering/ScalarRenderer.cs 's/scene.Camera.Height - 1 - (top + y)/top + y/'
edit "the last hit wins"         $course/Camera/Ray.cs               's/ || IsNearer<Scalar>(t, HitParameter).Value == 0//'
edit "the farthest hit wins"     $course/Camera/Ray.cs               's/=> t < nearest;/=> t > nearest;/'
edit "half the light"            $course/Rendering/Scene.cs \
    's/: Attenuation<Scalar>(t) \* model.Color/: 0.5 * Attenuation<Scalar>(t) * model.Color/'
edit "attenuation"               $course/Rendering/Scene.cs          's|1 - t / Camera.FadeDistance|1 - t / (2 * Camera.FadeDistance)|'
edit "red and blue swapped"      $course/Models/Color.cs             's/(ToByte(R), ToByte(G), ToByte(B))/(ToByte(B), ToByte(G), ToByte(R))/'
edit "colour times number"       $course/Models/Color.cs             's/attenuation \* color.G/color.G/'
edit "truncated, not rounded"    $course/Models/Color.cs             's/ \* 255 + 0.5/ * 255/'
edit "the picture's indexer"     $course/Rendering/Picture.cs \
    's/(Rgb\[i\], Rgb\[i + 1\], Rgb\[i + 2\]) = value/(Rgb[i + 2], Rgb[i + 1], Rgb[i]) = value/'
edit "h without the 2"           $course/Camera/Camera.cs            's/PlaneHeight = 2 \* Math.Tan/PlaneHeight = Math.Tan/'
edit "the ray of a pixel"        $course/Camera/Camera.cs            's/Direction<Scalar>(column, row);/Direction<Scalar>(column, row + 1);/'
edit "the clip range"            $course/Camera/ClipRange.cs         's/z >= zNear;/z <= zNear;/'
edit "dot product"               $course/Mathematics/Vector3OfN.cs   's/a.X \* b.X + a.Y \* b.Y/a.X * b.X - a.Y * b.Y/'
edit "cross product"             $course/Mathematics/Vector3.cs      's/a.Z \* b.X - a.X \* b.Z/a.X * b.Z - a.Z * b.X/'
edit "plane"                     $course/Models/Plane.cs             's/(Point - ray.Origin) \* Normal/(ray.Origin - Point) * Normal/'
edit "sphere"                    $course/Models/Sphere.cs            's/Radius \* Radius - D \* D/Radius - D * D/'
edit "box"                       $course/Models/Aabb.cs              's/var hit = tMin <= tMax/var hit = tMin >= tMax/'
edit "circle"                    $course/Models/Circle.cs            's/Radius \* Radius/Radius/'
edit "triangle"                  $course/Models/Triangle.cs          's/((u >= 0) & (v >= 0) & (w >= 0))/((u >= 0) \& (v >= 0))/'
edit "the models' first hit"     $course/Models/Model.cs \
    's/ray.ClipRange.First<Scalar>(crossings, ray.DepthPerT)/0.5 * ray.ClipRange.First<Scalar>(crossings, ray.DepthPerT)/'
edit "the scene's reader"        src/RayCaster.Files/SceneFiles/SceneReader.cs 's/"width"/"wide"/'
edit "the picture's writer"      src/RayCaster.Files/PictureFiles/PictureWriter.cs 's/        Encode(rgb);/        Encode(new byte[rgb.Length]);/'

sed -i 's/Radius \* Radius - D \* D/Radius - D * D/' $course/Models/Sphere.cs
draw >/dev/null
for command in "diagnose scenes/room.json right.png" "compare new.png right.png --scene scenes/room.json" "check scenes/room.json"; do
    # shellcheck disable=SC2086 # the words of a command
    dotnet src/RayCaster.Cli/bin/Release/net10.0/raycaster.dll $command --json >said.json 2>/dev/null || true
    if grep -q '"warning": "src/RayCaster has been changed' said.json; then
        passed=$((passed + 1)); echo "ok     ${command%% *} --json says that src/RayCaster was changed"
    else
        failed=$((failed + 1)); echo "FAILED ${command%% *} --json does not say that src/RayCaster was changed"
    fi
done

sed -i 's/return new(tca - thc/if (Radius < 9) throw new Exception("boom"); &/' $course/Models/Sphere.cs
message=$(draw)
if [[ $message == *"Exception"*": boom"*"src/RayCaster was changed"* ]]; then
    passed=$((passed + 1)); echo "ok     a formula that throws is told as the change's fault"
else
    failed=$((failed + 1)); echo "FAILED a formula that throws: $message"
fi
sed -i 's/if (Radius < 9) throw[^;]*;/return new(N.Sqrt(-1));/' $course/Models/Sphere.cs
message=$(draw --ledger)
if [[ $message == *"ball does not show"*"a formula that was changed finds no crossing"* ]]; then
    passed=$((passed + 1)); echo "ok     the ledger says that a changed formula may find no crossing"
else
    failed=$((failed + 1)); echo "FAILED the ledger of a formula that finds no crossing: $message"
fi
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]

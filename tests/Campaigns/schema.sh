#!/usr/bin/env bash
# Whether scenes/scene.schema.json accepts the scenes that the reader accepts, and refuses those of a wrong shape, as a maintained validator sees
# it (Debian's python3-jsonschema).
set -euo pipefail
cd "$(dirname "$0")/../.."
python3 -c 'import jsonschema' 2>/dev/null || { echo "there is no python3-jsonschema"; exit 77; }
python3 - <<'END'
import glob, json, re, sys
import jsonschema

def read(path):  # JSON with comments and commas after last elements
    text = open(path, encoding="utf-8-sig").read()
    text = re.sub(r'("(?:\\.|[^"\\])*")|//[^\r\n]*|/\*.*?\*/', lambda m: m.group(1) or " ", text, flags=re.S)
    return json.loads(re.sub(r'("(?:\\.|[^"\\])*")|,(?=\s*[\]}])', lambda m: m.group(1) or "", text))

schema = json.load(open("scenes/scene.schema.json", encoding="utf-8"))
validator = jsonschema.validators.validator_for(schema)(schema)
tests, wrong, count = "tests/RayCaster.Files.Tests/", [], 0
for folder, accepts in (("scenes/**", True), (tests + "Good", True), (tests + "Broken/Shape", False), (tests + "Broken/Sense", True)):
    for path in glob.glob(folder + "/*.json", recursive=True):
        if path.endswith("scene.schema.json") or "/my/" in path: continue
        count += 1
        if validator.is_valid(read(path)) != accepts: wrong.append(path)
print(*(f"the schema {'refuses' if 'Shape' not in path else 'accepts'} {path}" for path in wrong), f"{count} scenes", sep="\n")
sys.exit(bool(wrong) or count < 100)
END

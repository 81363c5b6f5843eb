#!/usr/bin/env bash
# Reads all scripts with bash and shellcheck, and looks whether each campaign and each project of tests is run by some job.
command -v shellcheck >/dev/null || { echo "shellcheck is missing"; exit 77; }
failed=0
while read -r script; do
    bash -n "$script" && shellcheck -x -P SCRIPTDIR -e SC2016,SC2317 "$script" || failed=1 # text with $ that is not meant for this shell; traps
done < <(git ls-files '*.sh' .ci/run .ci/check)
while read -r file; do
    grep -qF "${file##*/}" RayCaster.sln || grep -qF -e " $file" -e " ${file%/*}" .ci/jobs || { echo "no job runs $file"; failed=1; }
done < <(git ls-files 'tests/RayCaster.*.Tests.csproj' 'tests/Campaigns/*.sh' ':!*/common.sh' ':!*/draw.sh')
exit $failed

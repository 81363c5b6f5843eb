#!/usr/bin/env bash
# Builds the page without a server. It runs on another runtime, which is a package of the SDK's makers: without it, this is skipped.
if ! said=$(dotnet restore src/RayCaster.Web 2>&1); then
    echo "$said"
    [[ $said =~ error\ NU1(10.|301) ]] || exit 1
    echo "the runtime pack for browser-wasm cannot be restored"
    exit 77
fi
dotnet build src/RayCaster.Web -v q

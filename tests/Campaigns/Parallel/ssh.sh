#!/usr/bin/env bash
# The same over ssh: two names for this machine, each with a server of its own. No folder is shared: the scene is sent, the parts come back.
. "$(dirname "$0")/common.sh"
need python3 parallel ssh sshd ssh-keygen rsync pkill
scene=$root/scenes/room.json # one file is all that must be sent
make_program
mkdir parts

ssh-keygen -q -t ed25519 -N '' -f host_key
ssh-keygen -q -t ed25519 -N '' -f user_key
cp user_key.pub authorized_keys
[ "$(id -u)" -ne 0 ] || mkdir -p /run/sshd
for node in 1 2; do
    port=$(free_port)
    cat >"sshd_config$node" <<END
Port $port
ListenAddress 127.0.0.1
HostKey $work/host_key
PidFile $work/sshd$node.pid
AuthorizedKeysFile $work/authorized_keys
StrictModes no
UsePAM no
PasswordAuthentication no
SetEnv PATH=$PATH
END
    cat >>ssh_config <<END
Host node$node
    HostName 127.0.0.1
    Port $port
    User $(id -un)
    IdentityFile $work/user_key
    IdentitiesOnly yes
    StrictHostKeyChecking no
    UserKnownHostsFile /dev/null
    LogLevel ERROR
END
    "$(PATH=$PATH:/usr/sbin command -v sshd)" -f "$work/sshd_config$node" -E "$work/sshd$node.log"
    cleanups+=("kill \$(cat $work/sshd$node.pid)")
done
check "both servers let us in" ssh -F ssh_config node1 ssh -F "$work/ssh_config" node2 true

file=$(basename "$work").json # a name that no other run has, to find its processes by
cp "$scene" "$file"
log=first.log
draw() { # the parts that have not come back yet
    local k todo=()
    for k in $(seq "$parts"); do [ -e "parts/$k.png" ] || todo+=("$k"); done
    parallel --will-cite --jobs 1 --ssh "ssh -F $work/ssh_config" --sshlogin node1,node2 --workdir ... --cleanup \
        --transferfile "$file" --return parts/{}.png \
        "mkdir -p parts && raycaster part $file {}/$parts -t 1 -s $size -o parts/{}.png" ::: "${todo[@]}" 2>"$log"
}

kill_remote() { # the working folders are the nodes' own: look for the process
    wait_until 60 pkill -9 -f "^[^ ]*raycaster part $file 2/$parts " || failed "part 2 was not begun in a minute"
}
kill_remote &
killer=$!
code=0
draw || code=$?
wait $killer
check "parallel tells that one part failed" [ "$code" -eq 1 ]
check "all other parts have come back" [ "$(there)" -eq $((parts - 1)) ]
check "both machines have worked" [ "$(grep -ch 'Accepted publickey' sshd1.log)" -gt 1 -a "$(grep -ch 'Accepted publickey' sshd2.log)" -gt 1 ]

log=second.log
draw
check "run again, that part only is drawn" [ "$(grep -c 'lines ' second.log)" -eq 1 ]
compare
finish

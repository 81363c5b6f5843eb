#!/usr/bin/env bash
# The same by Slurm, on a cluster of one node that this script starts and stops: an array job of parts, and a stitch that waits for it.
# One part is cancelled and one killed while they are drawn; the same two jobs, submitted again, finish only what is missing.
. "$(dirname "$0")/common.sh"
need python3 munged slurmctld slurmd sbatch scancel pkill
make_program
mkdir parts munge state spool

dd if=/dev/urandom of=munge/key bs=1 count=128 status=none
chmod 600 munge/key
cat >slurm.conf <<END
ClusterName=raycaster
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmctldPort=$(free_port)
SlurmdPort=$(free_port)
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/munge
AuthInfo=socket=$work/munge/socket
CredType=cred/munge
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerType=sched/backfill
ReturnToService=2
KillWait=5
MinJobAge=300
NodeName=$(hostname -s) NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
cat >cgroup.conf <<END
CgroupAutomount=no
END
export SLURM_CONF=$work/slurm.conf PATH=$PATH:/usr/sbin

munged --force --key-file="$work/munge/key" --socket="$work/munge/socket" --pid-file="$work/munge/pid" \
    --log-file="$work/munge/log" --seed-file="$work/munge/seed"
cleanups+=('munged --stop --socket="$work/munge/socket" 2>/dev/null')
slurmctld -f "$SLURM_CONF"
cleanups=('kill $(cat slurmctld.pid)' "${cleanups[@]}")
slurmd -f "$SLURM_CONF"
cleanups=('scancel --user "$(id -un)" 2>/dev/null; sleep 1; kill $(cat slurmd.pid)' "${cleanups[@]}")
node_is_idle() { sinfo -h -o %t 2>/dev/null | grep -qx idle; }
wait_until 60 node_is_idle || { tail -5 slurmctld.log slurmd.log; failed "the node did not come up"; }
passed "a cluster of one node is up: Slurm $(sinfo --version | sed 's/.* //'), $(nproc) processors"

cat >draw.sbatch <<END
#!/bin/bash
#SBATCH --array=1-$parts
#SBATCH --cpus-per-task=1
#SBATCH --output=draw-%A_%a.log
raycaster part $scene \$SLURM_ARRAY_TASK_ID/$parts -t \$SLURM_CPUS_PER_TASK -s $size -o $work/parts/\$SLURM_ARRAY_TASK_ID.png --resume
END
submit() {
    drawing=$(sbatch --parsable draw.sbatch)
    joining=$(sbatch --parsable --dependency="afterok:$drawing" --kill-on-invalid-dep=yes --output=stitch.log \
        --wrap "raycaster stitch parts -o stitched.ppm")
}
is_over() { [ -z "$(squeue -h -j "$1" 2>/dev/null)" ]; }

submit
kill_part 1 STOP # or it may be done before it is cancelled
scancel "${drawing}_1"
kill_part 3 KILL
wait_until 300 is_over "$drawing" || failed "the array job does not end"
wait_until 60 is_over "$joining" || failed "the stitch waits for ever"
check "all parts are there but the cancelled and the killed one" [ "$(there)" -eq $((parts - 2)) ]
check "nothing was joined" [ ! -e stitched.ppm ]
echo "  missing: $(raycaster stitch parts --missing | tr '\n' ' ')"

submit
wait_until 300 is_over "$drawing" || failed "the array job does not end"
wait_until 120 is_over "$joining" || failed "the stitch does not end"
check "submitted again, only these two are drawn" \
    [ "$(cat draw-"$drawing"_*.log | grep -c 'exists already')" -eq $((parts - 2)) -a "$(cat draw-"$drawing"_*.log | grep -c 'lines ')" -eq 2 ]
check "the stitch ran when they were done" [ -e stitched.ppm ]
check "the picture is that drawn in one go, to the byte" cmp stitched.ppm whole.ppm
finish

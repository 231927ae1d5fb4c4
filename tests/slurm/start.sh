#!/usr/bin/env bash
# A Slurm of one controller and two nodes on this machine, over the loopback alone, for the tests of campaigns.
#
#   tests/slurm/start.sh COMMAND [ARGUMENT…]   starts it, runs the command with it, stops it: its exit status is that
#                                              of the command
#
# As root, with Debian's slurm-wlm and munge. All files are in one temporary directory, which goes at the end; nothing
# of the machine's own Slurm or munge is read or changed. The command finds in its environment SLURM_CONF,
# ANALOGON_SLURM (that directory, with the process of each daemon in controller.pid, node1.pid and node2.pid) and
# ANALOGON_SLURM_START (this script: "start.sh node N" starts a node anew, "start.sh controller" the controller, and
# "start.sh resume" takes nodes into service that Slurm drained).
# CPUS of each node and MAX_ARRAY may be set.
set -euo pipefail

start_controller() { "$SLURMCTLD" -f "$SLURM_CONF" "$@" 2>>"$ANALOGON_SLURM/slurmctld.err"; }
start_node() { "$SLURMD" -N "node$1" -f "$SLURM_CONF" 2>>"$ANALOGON_SLURM/slurmd$1.err"; }

for program in slurmctld slurmd munged sinfo; do
    command -v $program >/dev/null || PATH=$PATH:/usr/sbin
    command -v $program >/dev/null || { echo "skipped: $program is not installed (slurm-wlm, munge)"; exit 77; }
done
SLURMCTLD=$(command -v slurmctld) SLURMD=$(command -v slurmd)
[ "$(id -u)" = 0 ] || { echo "skipped: this needs root"; exit 77; }
case "${1:-}" in
node) start_node "$2"; exit ;;
controller) start_controller; exit ;;
resume) scontrol update nodename=node1,node2 state=resume 2>/dev/null || true; exit ;;
"") sed -n '2,13s/^# \?//p' "$0"; exit 2 ;;
esac

export ANALOGON_SLURM ANALOGON_SLURM_START SLURM_CONF
ANALOGON_SLURM=$(mktemp -d "${TMPDIR:-/tmp}/analogon-slurm-XXXXXX")
ANALOGON_SLURM_START=$(realpath "$0")
SLURM_CONF=$ANALOGON_SLURM/slurm.conf
chmod 755 "$ANALOGON_SLURM"

# those daemons alone that were started here, and what they run
stop() {
    local name pid
    scancel --user=root >/dev/null 2>&1 || true
    for name in node1 node2 controller munged; do
        pid=$(cat "$ANALOGON_SLURM/$name.pid" 2>/dev/null) || continue
        kill "$pid" 2>/dev/null || continue
        for _ in $(seq 50); do kill -0 "$pid" 2>/dev/null || break; sleep 0.1; done
        kill -9 "$pid" 2>/dev/null || true
    done
    rm -rf "$ANALOGON_SLURM"
}
trap stop EXIT
trap 'exit 130' INT TERM

free_port() { python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])'; }

mkdir "$ANALOGON_SLURM"/{munge,state,spoolnode1,spoolnode2}
chmod 700 "$ANALOGON_SLURM/munge"
dd if=/dev/urandom bs=1024 count=1 of="$ANALOGON_SLURM/munge/key" 2>/dev/null
chmod 400 "$ANALOGON_SLURM/munge/key"
munged --force --socket="$ANALOGON_SLURM/munge/socket" --key-file="$ANALOGON_SLURM/munge/key" \
    --log-file="$ANALOGON_SLURM/munge/log" --pid-file="$ANALOGON_SLURM/munged.pid" \
    --seed-file="$ANALOGON_SLURM/munge/seed"
chmod 711 "$ANALOGON_SLURM/munge"

cat >"$SLURM_CONF" <<CONF
ClusterName=analogon
SlurmctldHost=localhost(127.0.0.1)
SlurmctldPort=$(free_port)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$ANALOGON_SLURM/munge/socket
CryptoType=crypto/munge
StateSaveLocation=$ANALOGON_SLURM/state
SlurmdSpoolDir=$ANALOGON_SLURM/spool%n
SlurmctldPidFile=$ANALOGON_SLURM/controller.pid
SlurmdPidFile=$ANALOGON_SLURM/%n.pid
SlurmctldLogFile=$ANALOGON_SLURM/slurmctld.log
SlurmdLogFile=$ANALOGON_SLURM/%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SwitchType=switch/none
MpiDefault=none
ReturnToService=2
SlurmctldTimeout=10
SlurmdTimeout=10
InactiveLimit=0
KillWait=5
MinJobAge=60
SchedulerType=sched/backfill
SchedulerParameters=batch_sched_delay=0,sched_min_interval=100000,bf_interval=2
MaxArraySize=${MAX_ARRAY:-1001}
NodeName=node1 NodeHostname=localhost NodeAddr=127.0.0.1 Port=$(free_port) CPUs=${CPUS:-1} State=UNKNOWN
NodeName=node2 NodeHostname=localhost NodeAddr=127.0.0.1 Port=$(free_port) CPUs=${CPUS:-1} State=UNKNOWN
PartitionName=all Nodes=node1,node2 Default=YES MaxTime=INFINITE State=UP
CONF

start_controller -c
start_node 1
start_node 2
for _ in $(seq 100); do
    [ "$(sinfo --noheader --format=%T --Node 2>/dev/null | grep -c idle)" = 2 ] && break
    sleep 0.2
done
if [ "$(sinfo --noheader --format=%T --Node 2>/dev/null | grep -c idle)" != 2 ]; then
    echo "Slurm did not start:" >&2
    sinfo >&2 || true
    tail -n 15 "$ANALOGON_SLURM"/*.log "$ANALOGON_SLURM"/*.err >&2 || true
    exit 1
fi
"$@"

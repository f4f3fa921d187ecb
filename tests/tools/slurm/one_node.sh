#!/usr/bin/env bash
# A private Slurm of one node below a folder, without systemd and control groups, as root or as an ordinary user; it leaves the
# configuration and the ports of the system's Slurm alone.
#
#   one_node.sh start FOLDER    then: export SLURM_CONF=FOLDER/slurm.conf
#   one_node.sh stop FOLDER     ends its jobs and itself
#
# Debian: apt-get install --no-install-recommends munge slurmctld slurmd slurm-client. PORT (default 26817) and the next one are
# used. CPUS (4) may be more than there are. Jobs of the partition `high` preempt those of `low`, which then have GRACE (10)
# seconds. An array has at most 1000 elements, numbers below MAX_ARRAY (1001).
set -euo pipefail
(($# == 2)) || { sed -n '2,10s/^# \{0,1\}//p' "$0"; exit 2; }
verb=$1
mkdir -p "$2"
folder=$(cd "$2" && pwd)
port=${PORT:-26817} cpus=${CPUS:-4}
export SLURM_CONF=$folder/slurm.conf PATH=$PATH:/usr/sbin:/sbin

# wait_for SECONDS COMMAND...
wait_for() {
  local left=$(($1 * 10))
  shift
  until "$@" > "$folder/wait.log" 2>&1; do
    ((left-- > 0)) || { echo "one_node.sh: waited in vain for: $*" >&2; tail -n 5 "$folder"/*.log >&2; exit 1; }
    sleep 0.1
  done
}

# A process that has ended is a zombie where nothing waits for it, as in many containers.
runs() { [[ -s $folder/$1.pid ]] && grep -qs '^State:[[:space:]]*[^ZX[:space:]]' "/proc/$(<"$folder/$1.pid")/status"; }
ended() { ! runs "$1"; }
idle() { sinfo --noheader --partition=low --format=%t | grep -q idle; }
empty() { [[ -z $(squeue --noheader --states=running,completing) ]]; }

configure() {
  local node
  node=$(hostname -s)
  cat > "$SLURM_CONF" <<TEXT
ClusterName=test
SlurmctldHost=$node(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket
CredType=cred/munge
# Processes are found as descendants; nothing is bound to processors.
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
SwitchType=switch/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=sched_interval=1,bf_interval=1,sched_min_interval=0,defer_batch
SlurmdParameters=config_overrides
PreemptType=preempt/partition_prio
PreemptMode=REQUEUE
MaxArraySize=${MAX_ARRAY:-1001}
MinJobAge=300
KillWait=5
ReturnToService=2
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
NodeName=$node NodeAddr=127.0.0.1 CPUs=$cpus Sockets=1 CoresPerSocket=$cpus ThreadsPerCore=1 State=UNKNOWN
PartitionName=low Nodes=$node Default=YES PriorityTier=1 GraceTime=${GRACE:-10} State=UP
PartitionName=high Nodes=$node PriorityTier=10 PreemptMode=off State=UP
TEXT
}

start() {
  mkdir -p "$folder/state" "$folder/spool"
  chmod 711 "$folder"  # all must reach the socket of munge, and nobody else may replace its key
  [[ -e $folder/munge.key ]] || mungekey --create --keyfile="$folder/munge.key"
  munged --key-file="$folder/munge.key" --socket="$folder/munge.socket" --pid-file="$folder/munged.pid" \
    --log-file="$folder/munged.log" --seed-file="$folder/munge.seed"
  configure
  slurmctld -c -f "$SLURM_CONF"  # -c: without the jobs of an earlier one
  wait_for 10 scontrol ping
  slurmd -f "$SLURM_CONF" -N "$(hostname -s)"
  wait_for 20 idle
  for daemon in munged slurmctld slurmd; do
    runs $daemon || { echo "one_node.sh: $daemon has ended, see $folder/$daemon.log; is port $port taken?" >&2; exit 1; }
  done
}

stop() {
  if runs slurmctld; then
    scancel --user="$(id -un)" || true
    (wait_for 10 empty) || true
    scontrol shutdown || true
  fi
  for daemon in slurmctld slurmd munged; do
    [[ $daemon == munged ]] || (wait_for 5 ended $daemon) || true
    ! runs $daemon || kill "$(<"$folder/$daemon.pid")" || true
  done
}

case $verb in
  start) start ;;
  stop) stop ;;
  *) echo "one_node.sh: there is no '$verb'; give start or stop" >&2; exit 2 ;;
esac

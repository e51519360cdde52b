#!/bin/sh
# A Slurm of its own on the loopback interface: controller and nodes run on this machine.
#
#   private_slurm.sh start DIR NODES      every node has two cores; export SLURM_CONF=DIR/slurm.conf to use it
#   private_slurm.sh start-controller DIR
#   private_slurm.sh kill-controller DIR  by SIGKILL, as a power failure would
#   private_slurm.sh kill-node DIR NODE   slurmd and its jobs, as the loss of the machine would
#   private_slurm.sh stop DIR
#
# Of Debian's packages slurmctld, slurmd, slurm-client and munge. No systemd, no control groups, no accounting.
set -eu
command=$1
directory=$2
PATH=$PATH:/usr/sbin
SLURM_CONF=$directory/slurm.conf
export PATH SLURM_CONF

# Ports are not reserved.
write_configuration() {
  host=$(hostname -s)
  user=$(id -un)
  port=$((10000 + $$ * 5 % 20000))  # those of two tests that start together do not overlap
  cat <<END
ClusterName=private
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
AuthType=auth/munge
AuthInfo=socket=$directory/munge.socket
SlurmUser=$user
SlurmdUser=$user
StateSaveLocation=$directory/state
SlurmdSpoolDir=$directory/spool.%n
SlurmctldPidFile=$directory/slurmctld.pid
SlurmdPidFile=$directory/slurmd.%n.pid
SlurmctldLogFile=$directory/slurmctld.log
SlurmdLogFile=$directory/slurmd.%n.log
SlurmdParameters=config_overrides
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
SchedulerParameters=batch_sched_delay=0,sched_interval=1,sched_min_interval=1000,bf_interval=1
ReturnToService=2
MpiDefault=none
KillWait=2
MessageTimeout=3
SlurmdTimeout=5
END
  for node in $(seq "$1"); do
    echo "NodeName=n$node NodeHostname=$host NodeAddr=127.0.0.1 Port=$((port + node)) CPUs=2 CoresPerSocket=2 RealMemory=4000"
  done
  echo "PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP"
}

start_munge() {
  (umask 077 && head -c 1024 /dev/urandom >"$directory/munge.key")
  munged --force --num-threads=2 --key-file="$directory/munge.key" --socket="$directory/munge.socket" \
    --pid-file="$directory/munged.pid" --log-file="$directory/munged.log" --seed-file="$directory/munge.seed"
}

# ended PID: waits for its end, ten seconds at most
ended() {
  for _ in $(seq 100); do
    kill -0 "$1" 2>/dev/null || return 0
    sleep 0.1
  done
  return 1
}

# end FILE: ends the process whose id is in the file
end() {
  [ -s "$1" ] || return 0
  pid=$(cat "$1")
  kill "$pid" 2>/dev/null || return 0
  ended "$pid" || kill -KILL "$pid"
}

# slurmd, and the processes that supervise its jobs: those that have its log open. Capstan's jobs end with them.
kill_node() {
  kill -KILL "$(cat "$directory/slurmd.$1.pid")"
  for process in $(pgrep slurmstepd); do
    if ls -l "/proc/$process/fd" | grep -q "$directory/slurmd.$1.log"; then kill -KILL "$process"; fi
  done
}

case $command in
  start)
    mkdir -p "$directory/state"
    write_configuration "$3" >"$SLURM_CONF"
    start_munge
    slurmctld
    for node in $(seq "$3"); do
      mkdir -p "$directory/spool.n$node"
      slurmd -N "n$node"
    done
    for _ in $(seq 300); do
      [ "$(sinfo --noheader --Node --states=idle 2>/dev/null | wc -l)" = "$3" ] && exit 0
      sleep 0.1
    done
    echo "the nodes did not become idle" >&2
    exit 1
    ;;
  start-controller) slurmctld ;;
  kill-controller)
    pid=$(cat "$directory/slurmctld.pid")
    kill -KILL "$pid"
    ended "$pid"
    ;;
  kill-node) kill_node "$3" ;;
  stop)
    timeout 10 scancel --me 2>/dev/null || true
    for file in "$directory"/slurmd.*.pid "$directory/slurmctld.pid" "$directory/munged.pid"; do end "$file"; done
    ;;
  *)
    echo "unknown command $command" >&2
    exit 2
    ;;
esac

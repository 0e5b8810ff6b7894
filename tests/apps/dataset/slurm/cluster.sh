#!/bin/bash
# A Slurm cluster of two nodes with two CPUs each, on this machine, without systemd: munge, slurmctld, two slurmd.
#   cluster.sh start FOLDER    # everything lies in FOLDER; then SLURM_CONF=FOLDER/slurm.conf sbatch …
#   cluster.sh lose FOLDER NODE  # kills the node's daemon and all of its first job; its other jobs live on unseen
#   cluster.sh stop FOLDER
set -eu
folder=$(realpath "$2")

write_configuration() {
  cat >"$folder/slurm.conf" <<CONF
ClusterName=test
SlurmctldHost=localhost
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket,cred_expire=5
CryptoType=crypto/munge
MpiDefault=none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerType=sched/backfill
SchedulerParameters=batch_sched_delay=0,sched_interval=2
SwitchType=switch/none
ReturnToService=2
KillWait=3
SlurmdTimeout=10
MaxArraySize=3
SlurmctldPort=16817
SlurmctldPidFile=$folder/slurmctld.pid
SlurmctldLogFile=$folder/slurmctld.log
StateSaveLocation=$folder/state
SlurmdPidFile=$folder/%n.pid
SlurmdLogFile=$folder/%n.log
SlurmdSpoolDir=$folder/spool_%n
NodeName=node1 NodeHostname=localhost NodeAddr=127.0.0.1 Port=16818 CPUs=2 RealMemory=2000
NodeName=node2 NodeHostname=localhost NodeAddr=127.0.0.1 Port=16819 CPUs=2 RealMemory=2000
PartitionName=render Nodes=node1,node2 Default=YES State=UP
CONF
}

start() {
  mkdir -p "$folder"/{state,spool_node1,spool_node2}
  write_configuration
  export SLURM_CONF=$folder/slurm.conf
  head -c 1024 /dev/urandom >"$folder/munge.key"
  chmod 700 "$folder"
  chmod 600 "$folder/munge.key"
  munged --key-file="$folder/munge.key" --socket="$folder/munge.socket" --pid-file="$folder/munged.pid" \
    --log-file="$folder/munged.log" --seed-file="$folder/munged.seed" --force 2>"$folder/munged.out"
  slurmctld -c
  for node in node1 node2; do slurmd -N $node; done
  for ((i = 0; i < 60; ++i)); do
    [ "$(sinfo -h -t idle -o %D 2>/dev/null)" = 2 ] && return
    sleep 1
  done
  echo "the nodes do not come up; see $folder/*.log" >&2
  exit 1
}

lose() {
  local node=$1 job environment
  kill -9 "$(cat "$folder/$node.pid")"
  job=$(SLURM_CONF=$folder/slurm.conf squeue -h -t R -w "$node" -o %A | sort -n | head -n 1)
  pkill -9 -f "slurmstepd: \\[$job\\.batch\\]"  # first, lest it reports the others' end
  for environment in /proc/[0-9]*/environ; do
    if tr '\0' '\n' 2>/dev/null <"$environment" | grep -qx "SLURM_JOB_ID=$job"; then
      kill -9 "$(basename "$(dirname "$environment")")"
    fi
  done
}

# Waits for their end: they still write into the folder.
stop() {
  local daemon pid i
  for daemon in node1 node2 slurmctld munged; do
    pid=$(cat "$folder/$daemon.pid" 2>/dev/null) && kill "$pid" 2>/dev/null || continue
    for ((i = 0; i < 200; ++i)); do
      kill -0 "$pid" 2>/dev/null || break
      sleep 0.1
    done
  done
}

"$1" "${@:3}"

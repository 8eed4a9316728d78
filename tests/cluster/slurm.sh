#!/usr/bin/env bash
# Tests of braitenctl-mpi as a job of Slurm, run by ./dev cluster: slurm.sh FOLDER_OF_THE_PROGRAMS
# Starts munged, slurmctld and slurmd of its own for this computer, in a temporary folder, and ends them.
set -euo pipefail
programs=$(cd "$1" && pwd)
repository=$(cd "$(dirname "$0")/../.." && pwd)
((EUID == 0)) || { printf 'Skipped: only root can start the daemons of Slurm\n' >&2 && exit 0; }
scratch=$(mktemp -d)
daemons=()
end_daemons() {
    for daemon in "${daemons[@]}"; do kill "$daemon" 2>/dev/null || true; done
    wait 2>/dev/null || true
    rm -rf "$scratch"
}
trap end_daemons EXIT
fail() { printf 'FAILED: %s\n' "$*" >&2 && tail -n 20 "$scratch"/*.log >&2 && exit 1; }
chmod 755 "$scratch" && cd "$scratch" && mkdir state spool
export BRAITENLAB_DATA=$repository PATH=$programs:$PATH SLURM_CONF=$scratch/slurm.conf
name=$(hostname -s)
cat >slurm.conf <<END
ClusterName=test
SlurmctldHost=$name(127.0.0.1)
SlurmctldPort=16817
SlurmdPort=16818
AuthType=auth/munge
AuthInfo=socket=$scratch/munge.socket
CryptoType=crypto/munge
SlurmUser=root
SlurmdUser=root
StateSaveLocation=$scratch/state
SlurmdSpoolDir=$scratch/spool
SlurmctldPidFile=$scratch/slurmctld.pid
SlurmdPidFile=$scratch/slurmd.pid
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=batch_sched_delay=0,sched_interval=1
ReturnToService=2
MpiDefault=none
NodeName=$name NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=$name Default=YES MaxTime=10 State=UP OverSubscribe=FORCE:8
END
head -c 1024 /dev/urandom >munge.key && chmod 400 munge.key
munged --foreground --force --key-file="$scratch/munge.key" --socket="$scratch/munge.socket" --pid-file="$scratch/munged.pid" \
    --seed-file="$scratch/munged.seed" --log-file="$scratch/munged-own.log" >munged.log 2>&1 &
daemons+=($!)
for ((i = 0; i < 100; ++i)); do [[ -S munge.socket ]] && break || sleep 0.1; done
slurmctld -D >slurmctld.log 2>&1 &
daemons+=($!)
slurmd -D -N "$name" >slurmd.log 2>&1 &
daemons+=($!)
for ((i = 0; i < 200; ++i)); do [[ $(sinfo -h -o %T 2>/dev/null) == idle ]] && break || sleep 0.1; done
[[ $(sinfo -h -o %T) == idle ]] || fail "the node of Slurm is not idle"
srun --version

sed -e "s|scenes/|$repository/exercises/breeding/scenes/|" -e '/^opponents/a generations = 3\npopulation = 34\ntrials = 2\nseconds = 8\npanel = 0' \
    "$repository/exercises/breeding/chase.toml" >small.toml
braitenctl breed small.toml --out reference >/dev/null
timeout 120 srun --mpi=pmix --ntasks=2 braitenctl-mpi breed small.toml --out with-srun >srun.log 2>&1 || fail "srun"
cmp reference/state.json with-srun/state.json || fail "srun writes another folder"
printf '  srun --mpi=pmix with 2 ranks writes the same folder\n'

status=0 && timeout 60 srun --mpi=none --ntasks=2 braitenctl-mpi breed small.toml --out none >refused.log 2>&1 || status=$?
((status == 2)) && (($(grep -c 'srun --mpi=pmix' refused.log) == 1)) || fail "srun without PMIx is not refused: $status"
printf '  without --mpi=pmix it is refused, once\n'

cat >job.sh <<'END'
#!/bin/bash
#SBATCH --ntasks=2 --array=1-2 --output=job-%a.log
sed "1a seed = $SLURM_ARRAY_TASK_ID" small.toml >"small-$SLURM_ARRAY_TASK_ID.toml"
exec srun --mpi=pmix braitenctl-mpi breed "small-$SLURM_ARRAY_TASK_ID.toml" --out "seed-$SLURM_ARRAY_TASK_ID" --continue
END
timeout 180 sbatch --wait job.sh >sbatch.log 2>&1 || fail "sbatch"
for seed in 1 2; do
    braitenctl breed "small-$seed.toml" --out "alone-$seed" >/dev/null
    cmp "alone-$seed/state.json" "seed-$seed/state.json" || fail "the job of seed $seed writes another folder"
done
printf '  sbatch --array breeds two seeds\n'

sed -i 's/^generations = .*/generations = 60/' small.toml
braitenctl breed small.toml --out long-reference >/dev/null
cat >long.sh <<'END'
#!/bin/bash
#SBATCH --ntasks=2 --output=long.log --open-mode=append
exec srun --mpi=pmix braitenctl-mpi breed small.toml --out long --continue
END
job=$(sbatch --parsable long.sh)
for ((i = 0; i < 300; ++i)); do [[ $(grep -o '"champion"' long/state.json 2>/dev/null | wc -l) -ge 16 ]] && break || sleep 0.1; done
scancel "$job"
for ((i = 0; i < 300; ++i)); do [[ -z $(pgrep -f '^[^ ]*braitenctl-mpi breed small.toml --out long') ]] && break || sleep 0.1; done
[[ $(grep -o '"champion"' long/state.json | wc -l) -lt 122 ]] || fail "the job was complete before scancel"
timeout 180 sbatch --wait long.sh >>sbatch.log 2>&1 || fail "sbatch again"
cmp long-reference/state.json long/state.json || fail "the continued job writes another folder"
printf '  the same script again completes a job that scancel has ended\n'

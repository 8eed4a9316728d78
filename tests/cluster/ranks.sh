#!/usr/bin/env bash
# Tests of braitenctl-mpi under mpirun, run by ./dev cluster: ranks.sh FOLDER_OF_THE_PROGRAMS
set -euo pipefail
programs=$(cd "$1" && pwd)
repository=$(cd "$(dirname "$0")/../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 BRAITENLAB_DATA=$repository
ctl=$programs/braitenctl mpi=$programs/braitenctl-mpi
checks=0
pass() { checks=$((checks + 1)) && printf '  %s\n' "$*"; }
fail() { printf 'FAILED: %s\n' "$*" >&2 && exit 1; }
ranks() { mpirun --oversubscribe -n "$1" "$mpi" "${@:2}"; }

# breeding GENERATIONS: a small one of the shipped ones. More than 30 individuals, so that a sort that is not stable shows.
breeding() {
    sed -e "s|scenes/|$repository/exercises/breeding/scenes/|" -e "/^opponents/a generations = $1\npopulation = 34\ntrials = 2\nseconds = 8\npanel = 2\npanel_generations = 2" \
        "$repository/exercises/breeding/chase.toml"
}
same() { diff -r -x '*.lock' "$1" "$2" >/dev/null || fail "$2 differs from $1"; }

mpirun --version | head -n 1
breeding 3 >small.toml
"$ctl" breed small.toml --threads 1 --out reference >/dev/null
for count in 1 2 3 5; do
    for threads in 1 2 3 4; do
        ranks "$count" breed small.toml --threads "$threads" --out "folder-$count-$threads" >/dev/null
        same reference "folder-$count-$threads"
    done
done
pass "1, 2, 3, 5 ranks with 1 to 4 threads write the same folder"
ranks 3 breed small.toml --out unasked >/dev/null
same reference unasked
pass "so do ranks that choose their threads"

"$ctl" breed reference --matrix master --csv alone.csv >/dev/null
ranks 3 breed reference --matrix master --csv matrix.csv >/dev/null
cmp alone.csv matrix.csv || fail "the matrix differs"
map=(map 2b-aggressor --size 12 --seconds 10 --seeds 2)
"$ctl" "${map[@]}" --csv alone.csv && ranks 3 "${map[@]}" --csv map.csv
cmp alone.csv map.csv || fail "the map differs"
printf 'format = 1\ntitle = "T"\nscene = "2b-aggressor"\nseconds = 10\nseeds = 9\nmeasures = ["touch", "contacts"]\n[[value]]\nname = "w"\npaths = ["kind.aggressor.brain.LR"]\nlevels = [0, 0.5, 1]\n' >study.toml
"$ctl" study study.toml --csv alone.csv >/dev/null && ranks 3 study study.toml --csv study.csv >/dev/null
cmp alone.csv study.csv || fail "the study differs"
pass "matrix, map and study are the same"

ranks 3 breed small.toml --json --out one-voice >printed
[[ $(wc -l <printed) == 1 ]] || fail "more than one rank prints"
status=0 && ranks 3 breed smal.toml --out none 2>errors || status=$?
[[ $status == 2 && $(grep -c "no shipped breeding" errors) == 1 ]] || fail "bad input: status $status"
pass "only the first rank prints; bad input has exit code 2"
status=0 && SLURM_STEP_NUM_TASKS=3 "$mpi" breed small.toml --out none 2>errors || status=$?
[[ $status == 2 ]] && grep -q "mpi=pmix" errors || fail "processes without an MPI are not refused"
status=0 && OMPI_COMM_WORLD_SIZE=3 OMPI_COMM_WORLD_RANK=0 "$mpi" breed small.toml --out none 2>errors || status=$?
[[ $status == 2 ]] && grep -q "but MPI connects 1;" errors || fail "the ranks of another MPI are not refused"
pass "processes that do not know each other are refused"
"$mpi" breed small.toml --threads 2 --out alone >/dev/null
same reference alone
pass "without a launcher it is braitenctl"

# A long one that is ended from outside, and then continued.
breeding 60 >long.toml
"$ctl" breed long.toml --out long-reference >/dev/null
generations() { grep -o '"champion"' "$1/state.json" 2>/dev/null | wc -l || true; }
processes() { pgrep -f "^$mpi breed long.toml" || true; }
begin() { # begin FOLDER: 3 ranks in the background, some generations
    mpirun --oversubscribe -n 3 "$mpi" breed long.toml --threads 1 --out "$1" >"$1.out" 2>&1 &
    launcher=$!
    for ((i = 0; i < 300 && $(generations "$1") < 16; ++i)); do sleep 0.05; done
    [[ $(processes | wc -l) == 3 ]] || fail "$1: there are not 3 ranks: $(cat "$1.out")"
}
gone() { # gone FOLDER SECONDS
    for ((i = 0; i < $2 * 20; ++i)); do
        [[ -n $(processes) ]] || return 0
        sleep 0.05
    done
    fail "$1: ranks still run $2 s later"
}
finish() { # finish FOLDER: continues on another number of ranks
    local before=$(generations "$1")
    ((before < 2 * 61)) || fail "$1 was complete before it was ended"
    ranks 2 breed "$1" --continue >/dev/null
    same long-reference "$1"
}
begin killed-rank
kill -KILL "$(processes | tail -n 1)"
status=0 && wait $launcher || status=$?
gone killed-rank 5
((status != 0)) && [[ -s killed-rank.out ]] || fail "a killed rank: status $status, no message"
finish killed-rank
pass "a killed rank ends the job with a message; --continue completes it"
begin killed-first
kill -KILL "$(processes | head -n 1)"
status=0 && wait $launcher || status=$?
gone killed-first 5
((status != 0)) || fail "a killed first rank: status 0"
finish killed-first
pass "so does the first rank"
begin killed-launcher
kill -KILL $launcher
began=$(date +%s%N)
gone killed-launcher 5
ended=$((($(date +%s%N) - began) / 1000000))
wait $launcher 2>/dev/null || true
((ended < 1000)) || fail "ranks end $ended ms after a SIGKILL of mpirun, as Open MPI itself ends some of them"
finish killed-launcher
pass "ranks end $ended ms after a SIGKILL of mpirun; --continue completes it"
begin told-launcher
kill -TERM $launcher
status=0 && wait $launcher || status=$?
gone told-launcher 5
((status != 0)) || fail "SIGTERM of mpirun: status 0"
finish told-launcher
pass "so do they after a SIGTERM"

ranks 2 breed long.toml --threads 1 --out memory >/dev/null &
launcher=$! most=0
while kill -0 $launcher 2>/dev/null; do
    for process in $(processes); do
        kilobytes=$(sed -n 's/^VmHWM:[^0-9]*\([0-9]*\).*/\1/p' "/proc/$process/status" 2>/dev/null || true)
        ((${kilobytes:-0} > most)) && most=$kilobytes
    done
    sleep 0.1
done
wait $launcher
((most > 0 && most <= 64 * 1024)) || fail "a rank needs $most kB"
pass "a rank needs at most $((most / 1024)) MB"
printf '%d checks passed\n' "$checks"

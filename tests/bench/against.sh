#!/usr/bin/env bash
# against.sh OLD NEW [arguments of a benchmark program]: runs each benchmark of two programs in turns, and prints its
# processor time in both (median), their ratio, and the range of the ratios of the single turns. ROUNDS: number of turns.
set -euo pipefail
old=$1 new=$2 rounds=${ROUNDS:-5}
shift 2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$old" --benchmark_list_tests "$@" >"$folder/old"
"$new" --benchmark_list_tests "$@" >"$folder/new"

# one PROGRAM NAME: processor time in ns of a single benchmark
one() {
    local program=$1 name=$2
    shift 2
    "$program" --benchmark_min_time=0.2 "$@" "--benchmark_filter=^$name\$" --benchmark_format=json 2>/dev/null |
        awk -F'[ ":,]+' '$2 == "cpu_time" { time = $3 }
            $2 == "time_unit" { print time * ($3 == "us" ? 1e3 : $3 == "ms" ? 1e6 : $3 == "s" ? 1e9 : 1); exit }'
}

printf '%-36s %12s %12s %7s   %s\n' benchmark 'old µs' 'new µs' ratio range
sort -u "$folder/old" "$folder/new" | while read -r name; do
    grep -qxF -- "$name" "$folder/old" || { printf '%-36s only in the new program\n' "$name"; continue; }
    grep -qxF -- "$name" "$folder/new" || { printf '%-36s only in the old program\n' "$name"; continue; }
    for ((round = 0; round < rounds; ++round)); do
        printf '%s %s\n' "$(one "$old" "$name" "$@")" "$(one "$new" "$name" "$@")"
    done | awk -v name="$name" '
        function median(of, n,   i, j, t) {
            for (i = 2; i <= n; ++i) for (j = i; j > 1 && of[j] < of[j - 1]; --j) { t = of[j]; of[j] = of[j - 1]; of[j - 1] = t }
            return n % 2 ? of[(n + 1) / 2] : (of[n / 2] + of[n / 2 + 1]) / 2
        }
        NF == 2 { ++n; before[n] = $1; after[n] = $2; ratio[n] = $2 / $1 }
        END {
            if (!n) { printf "%-36s failed\n", name; exit }
            old = median(before, n); now = median(after, n); median(ratio, n)
            printf "%-36s %12.3f %12.3f %7.2f   %.2f to %.2f\n", name, old / 1e3, now / 1e3, now / old, ratio[1], ratio[n]
        }'
done

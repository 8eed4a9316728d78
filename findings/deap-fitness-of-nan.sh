#!/bin/bash
# DEAP: a fitness of NaN takes the place of the best one.
#
# Guess before the first run: an individual whose simulation diverges, so that its fitness is NaN, stands in no hall of fame
# before one with a finite fitness.
# Seen: NaN counts as greater than each number, and each number as greater than NaN, so the later one of two wins. A hall of
# fame of one place has 2 after the fitnesses 1, 5, NaN and 2; one of three places and selBest put others before the best.
# Tournaments of two and of five pick as many NaN as there are in the population. With -inf instead of NaN the best comes first,
# and tournaments of five pick none.
set -euo pipefail
dir=$(mktemp -d) && trap 'rm -rf "$dir"' EXIT && cd "$dir"

# expect WHAT SEEN WANTED: a difference means that the behaviour has changed.
expect() {
    printf '%-58s %s\n' "$1" "$2"
    [ "$2" = "$3" ] || { echo "changed: it was $3"; exit 1; }
}

apt-get download -qq python3-deap=1.3.1-4 python3-numpy=1:1.24.2-1+deb12u1 libblas3=3.11.0-2 liblapack3=3.11.0-2 \
    libgfortran5=12.2.0-14+deb12u1 libquadmath0=12.2.0-14+deb12u1 2>/dev/null
for package in *.deb; do dpkg -x "$package" root; done
echo "DEAP 1.3.1-4"
cat > hall.py <<'CODE'
import random
import sys
from deap import base, creator, tools

# hall WHAT FITNESSES: a hall of fame of that many places, the order of selBest, or the share of the worst fitness, in per cent,
# among the picks of tournaments of that size.
what, size = sys.argv[1], int(sys.argv[2])
creator.create("Fitness", base.Fitness, weights=(1.0,))
creator.create("Individual", list, fitness=creator.Fitness)
population = []
for number, value in enumerate(sys.argv[3].split()):
    individual = creator.Individual([number])
    individual.fitness.values = (float(value),)
    population.append(individual)
value = lambda individual: f"{individual.fitness.values[0]:g}"
if what == "hall":
    hall = tools.HallOfFame(size)
    hall.update(population)
    print(*map(value, hall))
elif what == "best":
    print(*map(value, tools.selBest(population, size)))
else:
    random.seed(1)
    picks = tools.selTournament(population, 100000, size)
    print(round(sum(value(pick) in ("nan", "-inf") for pick in picks) / 1000))
CODE
lib=root/usr/lib/x86_64-linux-gnu
hall() { PYTHONPATH=root/usr/lib/python3/dist-packages LD_LIBRARY_PATH=$lib:$lib/blas:$lib/lapack python3 hall.py "$@"; }
expect "hall of fame of one place: 1, 5, NaN, 2" "$(hall hall 1 '1 5 nan 2')" 2
expect "the same with -inf" "$(hall hall 1 '1 5 -inf 2')" 5
expect "hall of fame of three places: 1, NaN, 5, 2, NaN, 3" "$(hall hall 3 '1 nan 5 2 nan 3')" "3 nan 5"
expect "the same with -inf" "$(hall hall 3 '1 -inf 5 2 -inf 3')" "5 3 2"
expect "selBest: 1, NaN, 5, 2" "$(hall best 4 '1 nan 5 2')" "1 nan 5 2"
expect "the same with -inf" "$(hall best 4 '1 -inf 5 2')" "5 2 1 -inf"
expect "% of NaN picked by tournaments of 2, 20 % are there" "$(hall share 2 '1 2 3 4 nan 5 6 7 8 nan')" 20
expect "the same with -inf" "$(hall share 2 '1 2 3 4 -inf 5 6 7 8 -inf')" 4
expect "% of NaN picked by tournaments of 5, 20 % are there" "$(hall share 5 '1 2 3 4 nan 5 6 7 8 nan')" 20
expect "the same with -inf" "$(hall share 5 '1 2 3 4 -inf 5 6 7 8 -inf')" 0

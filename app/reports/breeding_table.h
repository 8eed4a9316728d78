// All numbers of a breeding, for other programs: as a table with one number a row, and as JSON.
#pragma once

#include <string>

#include "core/evolve/tournament.h"

namespace braitenlab {

// One line a pair of champions; of each side, with the columns side, generation, opponent_generation, score.
enum class MatrixKind { ciao, master };  // against ancestors and those of the same generation, or against all
std::string matrix_table(const evolve::Tournament&, MatrixKind);
// The number of opponents that a champion has in the matrix, from the first one on.
std::size_t opponents_of(const evolve::Tournament&, MatrixKind, std::size_t own);

// The columns measure, side, generation, of, value. Of each complete generation and each side that evolves: best,
// median, diversity, panel (if it is known) and champion (its index); parent of each individual (`of`), an index in the
// generation before. With a tournament the score of each champion against that of generation `of` of the other side.
std::string breeding_table(const evolve::BreedingBase&, const evolve::BreedingState&, const evolve::Tournament*);

// The same, with the genomes of the champions, the trends of panel and master scores, and the verdict of the matrix.
std::string breeding_json(const evolve::BreedingBase&, const evolve::BreedingState&, const evolve::Tournament&);

}  // namespace braitenlab

// Files of breedings: the breeding with its scene, and the folder of its results, which can be interrupted and
// continued.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "core/evolve/breeding.h"
#include "core/result.h"

namespace braitenlab {

// The breedings that ship with the program; a broken file is left out.
std::vector<evolve::Breeding> shipped_breeding_list();

// The breeding and its scene: a path relative to the breeding's file, or the name of a shipped scene.
Result<std::shared_ptr<const evolve::BreedingBase>> load_breeding(const std::filesystem::path&);

// Every independent error of the breeding and of its scene, for a breeding that cannot be loaded.
std::vector<Error> errors_of_breeding(const std::filesystem::path&);

// The file of the breeding in a folder of results, which also holds scene.toml and state.json.
std::filesystem::path breeding_in(const std::filesystem::path& folder);

// The file of its state there.
std::filesystem::path state_in(const std::filesystem::path& folder);

// True if the folder holds the state of a breeding.
bool holds_breeding(const std::filesystem::path& folder);

// The error if the folder has another breeding.toml or scene.toml than write_breeding_files() writes.
std::optional<Error> other_breeding_fault(const evolve::BreedingBase&, const std::filesystem::path& folder);

// Writes breeding and scene into the folder, which is made if it does not exist.
std::optional<Error> write_breeding_files(const evolve::BreedingBase&, const std::filesystem::path& folder);

// The state is replaced as a whole: a program that ends while it writes leaves the state before.
std::optional<Error> write_breeding_state(const evolve::BreedingBase&, const evolve::BreedingState&,
                                          const std::filesystem::path& folder);
Result<evolve::BreedingState> read_breeding_state(const evolve::BreedingBase&, const std::filesystem::path& folder);

// The folder in which the window keeps what it has bred, below the one of all of them.
std::filesystem::path kept_breeding(const std::filesystem::path& all, const evolve::BreedingBase&);

// Removes the folders of breedings whose states were written first, beyond so many or so many bytes of states. The one
// that was written last stays.
void drop_oldest_breedings(const std::filesystem::path& all, std::size_t most, std::uintmax_t bytes);

}  // namespace braitenlab

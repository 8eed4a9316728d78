// Breeding: files, trials, generations, states, tournaments.
#include "core/evolve/breeding.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/evolve/breeding_json.h"
#include "core/evolve/duel.h"
#include "core/evolve/generalist.h"
#include "core/evolve/scene_breeding.h"
#include "core/evolve/tournament.h"
#include "core/maths/fnv.h"
#include "core/maths/random.h"
#include "core/scene/scene_file.h"

namespace braitenlab::tests::breeding_test {
namespace {

using namespace evolve;
using evolve::Trial;  // not the one of core/lesson

const std::string scene_text =
    "format = 1\ntitle = \"T\"\n[arena]\nwidth = 6\nheight = 6\n[ecology]\nbite = 1\n"
    "[kind.hunter]\nrole = \"predator\"\n[kind.hunter.sensor.SL]\nchannel = \"prey\"\ny = 0.2\nrange = 6\n"
    "[kind.hunter.sensor.SR]\nchannel = \"prey\"\ny = -0.2\nrange = 6\n[kind.hunter.brain]\nLM = 0.3\nRM = 0.3\n"
    "[kind.hare]\nrole = \"prey\"\n[kind.hare.sensor.SL]\nchannel = \"predator\"\ny = 0.2\nrange = 6\n"
    "[kind.hare.sensor.SR]\nchannel = \"predator\"\ny = -0.2\nrange = 6\n[kind.hare.brain]\nLM = 0.3\nRM = 0.3\n"
    "[vehicle.hunter]\nkind = \"hunter\"\nx = -1.5\nheading_spread = 180\n"
    "[vehicle.hare]\nkind = \"hare\"\nx = 1.5\nheading_spread = 180\n";

std::string gene(const std::string& name, const std::string& paths, double low = -1, double high = 1) {
    return "[[breed.gene]]\nname = \"" + name + "\"\npaths = [" + paths + "]\nlow = " + std::to_string(low) +
           "\nhigh = " + std::to_string(high) + "\nmutation = 0.2\n";
}
const std::string genes = gene("straight", "\"brain.LL\", \"brain.RR\"") +
                          gene("crossed", "\"brain.LR\", \"brain.RL\"") +
                          gene("eyes", "\"sensor.SL.angle\", \"-sensor.SR.angle\"", 0, 90);
const std::string top =
    "format = 1\ntitle = \"T\"\nscene = \"s\"\nseconds = 4\ngenerations = 3\npopulation = 6\nparents = 2\ntrials = 3\n";
const std::string alone = "panel = 0\n", panel = "panel = 2\npanel_generations = 2\n";
const std::string both = "[[breed]]\nkind = \"hunter\"\n" + genes + "[[breed]]\nkind = \"hare\"\n" + genes;

std::shared_ptr<const BreedingBase> base_of(const std::string& text) {
    auto breeding = parse_breeding(text, "b.toml");
    EXPECT_TRUE(breeding) << breeding.error().text();
    auto base = BreedingBase::create(std::move(*breeding), scene_text, "s.toml");
    EXPECT_TRUE(base) << base.error().text();
    return *base;
}
std::string fault_of(const std::string& text, const std::string& scene = scene_text) {
    auto breeding = parse_breeding(text, "b.toml");
    if (!breeding) return breeding.error().text();
    const auto base = BreedingBase::create(std::move(*breeding), scene, "s.toml");
    return base ? "" : base.error().text();
}

std::vector<float> results_of(const BreedingBase& base, const std::vector<Trial>& trials) {
    std::vector<float> seconds(trials.size());
    for (std::size_t i = trials.size(); i-- > 0;) seconds[i] = run_of(base, trials[i]);  // any order
    return seconds;
}
BreedingState bred(const BreedingBase& base, int generations, BreedingState state) {
    for (auto trials = next_trials(base, state, generations); !trials.empty();
         trials = next_trials(base, state, generations))
        advance(base, state, results_of(base, trials));
    return state;
}
BreedingState bred(const BreedingBase& base, int generations) { return bred(base, generations, begin_breeding(base)); }

TEST(Breeding, AFileReadsBackAsItIsWritten) {
    const auto breeding = parse_breeding(top + panel + "opponents = \"archive\"\n" + both, "b.toml");
    ASSERT_TRUE(breeding) << breeding.error().text();
    const std::string text = write_breeding(*breeding);
    const auto again = parse_breeding(text, "b.toml");
    ASSERT_TRUE(again) << again.error().text();
    EXPECT_EQ(write_breeding(*again), text);
    EXPECT_EQ(again->opponents, Opponents::archive);
    ASSERT_EQ(again->breeds.size(), 2u);
    EXPECT_EQ(again->breeds[1].genes[2].paths, (std::vector<std::string>{"sensor.SL.angle", "-sensor.SR.angle"}));
}

TEST(Breeding, AnErrorHasItsLine) {
    EXPECT_TRUE(fault_of(top + "elite = 3\n" + both).starts_with("b.toml:9: elite is 3, more than parents"));
    EXPECT_TRUE(fault_of("format = 1\ntitle = \"T\"\nscene = \"s\"\n").find("'breed' is missing") != std::string::npos);
    const std::string path = "[[breed]]\nkind = \"hare\"\n" + gene("g", "\"brain.LX\"");
    EXPECT_TRUE(fault_of(top + path).starts_with("b.toml:13: ")) << fault_of(top + path);
    EXPECT_NE(fault_of(top + "[[breed]]\nkind = \"hare\"\n" + gene("g", "\"brain.LL\"", 1, 1)).find("has no range"),
              std::string::npos);
    const std::string no_side = fault_of(top + "[[breed]]\nkind = \"hair\"\n" + genes);
    EXPECT_TRUE(no_side.starts_with("b.toml:10: ") && no_side.ends_with("'hair'; the nearest is 'hare'")) << no_side;
    const std::string twice =
        fault_of(top + "[[breed]]\nkind = \"hare\"\n" + genes + "[[breed]]\nkind = \"hare\"\n" + genes);
    EXPECT_TRUE(twice.starts_with("b.toml:30: two [[breed]] tables")) << twice;
    const std::string one_vehicle = scene_text.substr(0, scene_text.find("[vehicle.hare]"));
    EXPECT_TRUE(fault_of(top + both, one_vehicle).starts_with("s.toml: a breeding needs"))
        << fault_of(top + both, one_vehicle);
}

TEST(Breeding, AnInterruptedOneContinuesToTheSameState) {
    const auto base = base_of(top + panel + both);
    const BreedingState whole = bred(*base, 3);
    EXPECT_EQ(complete_generations(*base, whole), 4);
    BreedingState state = begin_breeding(*base);
    for (auto trials = next_trials(*base, state, 3); !trials.empty(); trials = next_trials(*base, state, 3)) {
        auto kept = read_state(*base, write_state(*base, state), "state.json");
        ASSERT_TRUE(kept) << kept.error().text();
        EXPECT_EQ(*kept, state);
        state = std::move(*kept);
        advance(*base, state, results_of(*base, trials));
    }
    EXPECT_EQ(state, whole);
    EXPECT_EQ(bred(*base, 3, bred(*base, 1)), whole) << "more generations later";
}

TEST(Breeding, AStateOfAnotherBreedingIsRefused) {
    const auto base = base_of(top + alone + both), other = base_of(top + alone + "seed = 2\n" + both);
    const std::string text = write_state(*base, begin_breeding(*base));
    EXPECT_TRUE(read_state(*base, text, "f"));
    EXPECT_NE(read_state(*other, text, "f").error().text().find("another breeding"), std::string::npos);
    EXPECT_NE(read_state(*base, text.substr(0, text.size() / 2), "f").error().text().find("damaged"),
              std::string::npos);
    BreedingState state = begin_breeding(*base);
    at(state.main.population, Side::prey)[0].genome[2] = 91;
    EXPECT_FALSE(read_state(*base, write_state(*base, state), "f")) << "outside the range of its gene";
}

TEST(Breeding, FurtherWiresAndHiddenNeuronsAreGenes) {
    const std::string hidden =
        "[[kind.hare.brain.node]]\nname = \"H\"\nkind = \"neuron\"\n"
        "[[kind.hare.brain.wire]]\nfrom = \"SL\"\nto = \"H\"\n[[kind.hare.brain.wire]]\nfrom = \"H\"\nto = \"MR\"\n";
    std::string scene = scene_text;
    scene.insert(scene.find("[vehicle.hunter]"), hidden);
    const std::string file = top + alone + "[[breed]]\nkind = \"hare\"\n" + gene("in", "\"brain.wire.SL-H.weight\"") +
                             gene("out", "\"brain.wire.H-MR.weight\"") + gene("bias", "\"brain.node.H.bias\"");
    const auto base = BreedingBase::create(*parse_breeding(file, "b.toml"), scene, "s.toml");
    ASSERT_TRUE(base) << base.error().text();
    const Kind kind = (*base)->kind_of(Side::prey, {0.25F, -0.5F, 0.75F});
    const auto weight = [&](const std::string& from, const std::string& to) {
        for (const Wire& wire : kind.brain.wires)
            if (find_node(kind.brain, wire.from)->name == from && find_node(kind.brain, wire.to)->name == to)
                return wire.weight;
        return 0.0F;
    };
    EXPECT_EQ(weight("SL", "H"), 0.25F);
    EXPECT_EQ(weight("H", "MR"), -0.5F);
    EXPECT_EQ(find_node(kind.brain, "H")->bias, 0.75F);
    const auto again = BreedingBase::create(*parse_breeding(file, "b.toml"), write_scene((*base)->scene()), "s.toml");
    ASSERT_TRUE(again) << again.error().text();
    EXPECT_EQ((*again)->fingerprint(), (*base)->fingerprint()) << "as it is in a folder of results";
    const auto has_fault = [&](const std::string& in, const std::string& path, std::string_view id) {
        const auto breeding =
            parse_breeding(top + alone + "[[breed]]\nkind = \"hare\"\n" + gene("g", "\"" + path + "\""), "b.toml");
        const auto wrong = BreedingBase::create(*breeding, in, "s.toml");
        return !wrong && std::any_of(wrong.error().phrases.begin(), wrong.error().phrases.end(),
                                     [id](const Phrase& phrase) { return phrase.id == id; });
    };
    EXPECT_TRUE(has_fault(scene, "brain.wire.SL-MM.weight", "no_such_value"));
    EXPECT_TRUE(has_fault(scene, "brain.wire.SL-H.wieght", "unknown_key"));
    EXPECT_TRUE(has_fault(scene, "brain.node.G.bias", "no_such_value"));
    EXPECT_TRUE(has_fault(scene_text, "brain.wire.SL-H.weight", "no_such_value")) << "of a kind without further wires";
}

TEST(Breeding, NamesWithAHyphenAreInPathsUnlessTwoWiresAreMeant) {
    const auto neuron = [](const std::string& name) {
        return "[[kind.hare.brain.node]]\nname = \"" + name + "\"\nkind = \"neuron\"\n";
    };
    const auto wire = [](const std::string& from, const std::string& to) {
        return "[[kind.hare.brain.wire]]\nfrom = \"" + from + "\"\nto = \"" + to + "\"\n";
    };
    const auto base_with = [](const std::string& hidden, const std::string& path) {
        std::string scene = scene_text;
        scene.insert(scene.find("[vehicle.hunter]"), hidden);
        const std::string file = top + alone + "[[breed]]\nkind = \"hare\"\n" + gene("g", "\"" + path + "\"");
        return BreedingBase::create(*parse_breeding(file, "b.toml"), scene, "s.toml");
    };
    const std::string hidden = neuron("A-B") + neuron("A") + neuron("B-C") + neuron("C") + wire("SL", "A") +
                               wire("SL", "A-B") + wire("B-C", "MR") + wire("C", "MR") + wire("A-B", "C");
    for (const char* path : {"brain.wire.SL-A-B.weight", "brain.wire.A-B-C.weight", "brain.node.B-C.bias"}) {
        const auto base = base_with(hidden, path);
        ASSERT_TRUE(base) << path << base.error().text();
        EXPECT_NE((*base)->kind_of(Side::prey, {0.25F}), (*base)->kind_of(Side::prey, {0.5F})) << path;
    }
    EXPECT_FALSE(base_with(hidden + wire("A", "B-C"), "brain.wire.A-B-C.weight")) << "two wires have this path";
}

// kind_of() reads the kind alone.
TEST(Breeding, AKindOfAGenomeIsThatOfTheWholeScene) {
    Scene scene = *parse_scene(scene_text, "s.toml");
    for (const bool is_hidden : {false, true}) {
        for (Kind& kind : scene.kinds) kind.hidden = is_hidden;
        const std::string text = write_scene(scene);
        const std::string eyes = gene("eyes", "\"sensor.SL.angle\", \"-sensor.SR.angle\"", 0, 90);
        const std::string own = is_hidden ? eyes : genes;
        const std::string breeds = "[[breed]]\nkind = \"hunter\"\n" + own + "[[breed]]\nkind = \"hare\"\n" + own;
        const auto base = BreedingBase::create(*parse_breeding(top + alone + breeds, "b.toml"), text, "s.toml");
        ASSERT_TRUE(base) << base.error().text();
        for (const Side side : both_sides) {
            const std::string kind = "kind." + (*base)->kind(side).name;
            std::vector<Setting> settings{{kind + ".sensor.SL.angle", "37.7"}, {kind + ".sensor.SR.angle", "-37.7"}};
            Genome genome{37.7F};
            if (!is_hidden) {
                genome = {-0.3F, 0.1F, 37.7F};
                for (const auto& [dial, value] :
                     {std::pair{"LL", "-0.3"}, {"RR", "-0.3"}, {"LR", "0.1"}, {"RL", "0.1"}})
                    settings.push_back({kind + ".brain." + dial, value});
            }
            const Scene whole = *parse_scene(text, "s.toml", settings);
            const auto index = static_cast<std::size_t>(find_kind(whole, (*base)->kind(side).name));
            EXPECT_EQ((*base)->kind_of(side, genome), whole.kinds[index]) << kind << " hidden: " << is_hidden;
            EXPECT_EQ(whole.kinds[index].hidden, is_hidden);
        }
    }
}

TEST(Breeding, TheFirstGenerationIsMadeOfStartsIfTheFileSaysSo) {
    std::string starts = both;
    for (std::size_t at = 0; (at = starts.find("mutation = ", at)) != std::string::npos; at += 30)
        starts.insert(at, "start = 0.5\n");
    const auto base = base_of("from_scene = true\n" + top + alone + starts);
    const BreedingState state = begin_breeding(*base);
    for (const Side side : both_sides) {
        const std::vector<Individual>& population = at(state.main.population, side);
        EXPECT_EQ(population[0].genome, (Genome{0.5F, 0.5F, 0.5F}));
        std::set<Genome> all;
        for (const Individual& each : population) {
            all.insert(each.genome);
            for (std::size_t i = 0; i < 2; ++i) EXPECT_LT(std::fabs(each.genome[i] - 0.5F), 0.2F * 5);
        }
        EXPECT_EQ(all.size(), population.size()) << "children differ";
    }
}

TEST(Breeding, OfASceneHasAGeneForEachValueThatMayChange) {
    const auto names = [](const SceneBreeding& of, std::size_t breed) {
        std::set<std::string> found;
        for (const Gene& gene : of.breeding.breeds.at(breed).genes) found.insert(gene.paths.front());
        return found;
    };
    Scene scene = *parse_scene(scene_text, "s.toml");
    const SceneBreeding all = breeding_of_scene(scene, {}, "Mine");
    EXPECT_EQ(names(all, 0), (std::set<std::string>{"brain.LL", "brain.LR", "brain.RL", "brain.RR", "brain.LM",
                                                    "brain.RM", "sensor.SL.angle", "sensor.SR.angle"}));
    EXPECT_EQ(names(breeding_of_scene(scene, {false, false, true, false}, "Mine"), 1),
              (std::set<std::string>{"brain.threshold_LL", "brain.threshold_LR", "brain.threshold_RL",
                                     "brain.threshold_RR"}));
    for (const Gene& gene : all.breeding.breeds[0].genes)
        if (gene.paths.front() == "brain.LM") {
            EXPECT_EQ(gene.start, 0.3F);
        }
    scene.starts[0].brain = scene.kinds[0].brain;
    turn(*scene.starts[0].brain, Dial::LM, 0.9F);
    const SceneBreeding own = breeding_of_scene(scene, {}, "Mine");
    EXPECT_FALSE(own.scene.starts[0].brain) << "the kind has the brain of its vehicle";
    for (const Gene& gene : own.breeding.breeds[0].genes)
        if (gene.paths.front() == "brain.LM") {
            EXPECT_EQ(gene.start, 0.9F);
        }
}

TEST(Breeding, EveryGenomeStaysInTheRangesOfItsGenes) {
    const auto base = base_of(top + alone + both);
    const BreedingState state = bred(*base, 3);
    for (const Side side : {Side::predator, Side::prey}) {
        std::set<Genome> different;
        for (const Individual& each : at(state.main.population, side)) {
            different.insert(each.genome);
            for (std::size_t i = 0; i < each.genome.size(); ++i) {
                EXPECT_GE(each.genome[i], base->breed(side)->genes[i].low);
                EXPECT_LE(each.genome[i], base->breed(side)->genes[i].high);
            }
        }
        EXPECT_GE(different.size(), 5u);
    }
}

TEST(Breeding, TheElitePassesUnchangedAndChildrenComeFromTheParents) {
    const auto base = base_of(top + alone + "elite = 2\n" + both);
    const BreedingState before = bred(*base, 1), after = bred(*base, 2);
    const auto& earlier = at(before.main.population, Side::predator);
    const auto& population = at(after.main.population, Side::predator);
    const Generation& record = at(after.main.generations, Side::predator)[2];
    EXPECT_EQ(population[0].genome, record.champion);
    EXPECT_EQ(population[0].genome, earlier[static_cast<std::size_t>(record.index)].genome);
    EXPECT_EQ(population[1].genome, earlier[static_cast<std::size_t>(population[1].parent)].genome);
    std::set<int> parents;
    for (const Individual& each : population) parents.insert(each.parent);
    EXPECT_EQ(parents.size(), 2u);
    for (std::size_t i = 2; i < population.size(); ++i)
        EXPECT_NE(population[i].genome, earlier[static_cast<std::size_t>(population[i].parent)].genome);
}

TEST(Breeding, ThePanelDecidesNothing) {
    const auto with = base_of(top + panel + both), without = base_of(top + alone + both);
    BreedingState watched = bred(*with, 2);
    const BreedingState unwatched = bred(*without, 2);
    EXPECT_EQ(watched.main.population, unwatched.main.population);
    EXPECT_GE(at(watched.main.generations, Side::prey)[0].panel, 0);
    EXPECT_EQ(at(unwatched.main.generations, Side::prey)[0].panel, -1);
    EXPECT_NE(at(watched.panel.generations, Side::prey)[0].champion,
              at(watched.main.generations, Side::prey)[0].champion);
}

TEST(Breeding, ThePanelMeetsTheLastChampionsBesideTheNextGeneration) {
    const auto with = base_of(top + panel + both), without = base_of(top + alone + both);
    const BreedingState watched = bred(*with, 1), unwatched = bred(*without, 1);
    BreedingState waits = watched;
    for (const Side side : {Side::predator, Side::prey}) at(waits.main.generations, side).back().panel = -1;
    EXPECT_EQ(complete_generations(*with, waits), 1);
    const auto of_panel = next_trials(*with, waits, 1), of_both = next_trials(*with, waits, 2),
               of_generation = next_trials(*without, unwatched, 2);
    EXPECT_FALSE(of_panel.empty());
    EXPECT_EQ(of_both.size(), of_panel.size() + of_generation.size());
    BreedingState next = waits;
    advance(*with, next, results_of(*with, of_both));
    EXPECT_EQ(at(next.main.generations, Side::prey)[1], at(watched.main.generations, Side::prey)[1]);
    EXPECT_EQ(bred(*with, 2, next), bred(*with, 2));
    advance(*with, waits, results_of(*with, of_panel));
    EXPECT_EQ(waits, watched);
}

TEST(Breeding, CopiesShareAKind) {
    const auto base = base_of(top + alone + both);
    const auto trials = next_trials(*base, begin_breeding(*base), 3);
    const Trial copy = trials[1];
    EXPECT_EQ(&*copy.kinds[0], &*trials[0].kinds[0]) << "the opponent differs, not the individual";
    EXPECT_EQ(copy.kinds, trials[1].kinds);
    EXPECT_FALSE(copy.kinds == trials.back().kinds);
    EXPECT_EQ(*copy.kinds[0], base->kind_of(Side::predator, copy.kinds[0].genome()));
}

TEST(Breeding, EachSchemeChoosesItsOpponents) {
    for (const OpponentsTraits& row : opponents_table) {
        const auto base =
            base_of(top + alone + "remembered = 2\nopponents = \"" + std::string(row.word) + "\"\n" + both);
        const BreedingState state = bred(*base, 2);
        const auto& champions = at(state.main.generations, Side::prey);
        const auto& present = at(state.main.population, Side::prey);
        const auto trials = next_trials(*base, state, 3);
        std::set<const Kind*> met;
        for (std::size_t i = 0; i < 18; ++i) met.insert(&*at(trials[i].kinds, Side::prey));
        const auto is_champion = [&](const Kind& kind, std::size_t generation) {
            return kind == base->kind_of(Side::prey, champions[generation].champion);
        };
        const auto is_present = [&](const Kind& kind) {
            return std::any_of(present.begin(), present.end(),
                               [&](const Individual& each) { return kind == base->kind_of(Side::prey, each.genome); });
        };
        for (const Kind* kind : met) {
            const bool is_right =
                row.value == Opponents::random ? is_present(*kind)
                : row.value == Opponents::last ? is_champion(*kind, 2)
                : row.value == Opponents::generalist
                    ? is_present(*kind) || is_champion(*kind, 2) || is_champion(*kind, 1) || is_champion(*kind, 0)
                : row.value == Opponents::best_of_last
                    ? is_champion(*kind, 2) || is_champion(*kind, 1)
                    : is_champion(*kind, 2) || is_champion(*kind, 1) || is_champion(*kind, 0);
            EXPECT_TRUE(is_right) << row.word;
        }
    }
}

TEST(Breeding, WithGeneralistsTheParentsStayAndMeetTheSameStartsAsTheirChildren) {
    const auto base = base_of(top + alone + "elite = 0\nopponents = \"generalist\"\n" + both);
    const BreedingState before = bred(*base, 1), after = bred(*base, 2);
    const auto& earlier = at(before.main.population, Side::prey);
    const auto& population = at(after.main.population, Side::prey);
    for (std::size_t i = 0; i < 2; ++i)
        EXPECT_EQ(population[i].genome, earlier[static_cast<std::size_t>(population[i].parent)].genome);
    EXPECT_EQ(population[0].genome, at(after.main.generations, Side::prey)[2].champion);
    const auto trials = next_trials(*base, after, 3);
    for (std::size_t i = 0; i < 18; ++i) {
        EXPECT_EQ(trials[i].seed, trials[i % 3].seed);
        EXPECT_EQ(trials[i].kinds[1], trials[i % 3].kinds[1]);
    }
    EXPECT_NE(trials[0].seed, trials[1].seed);
}

TEST(Breeding, AMeasureOfStudiesIsAFitness) {
    const std::string closest = "fitness = \"closest\"\n";
    const auto base = base_of(top + alone + closest + both),
               more = base_of(top + alone + closest + "predator_better = \"more\"\n" + both),
               seconds = base_of(top + alone + "fitness = \"survival\"\n" + both),
               captures = base_of(top + alone + "fitness = \"captures\"\npredator_better = \"more\"\n" + both);
    std::set<float> different;
    for (const Trial& trial : next_trials(*base, begin_breeding(*base), 3)) {
        const float distance = run_of(*base, trial);
        EXPECT_GE(distance, 0);
        EXPECT_LT(distance, 6);
        different.insert(distance);
        const bool is_eaten = run_of(*captures, trial) > 0;
        EXPECT_EQ(run_of(*seconds, trial) < 4, is_eaten) << "the prey is the vehicle that is measured";
    }
    EXPECT_GT(different.size(), 10u);
    EXPECT_GT(score_of(base->breeding(), Side::predator, 1), score_of(base->breeding(), Side::predator, 2));
    EXPECT_LT(score_of(more->breeding(), Side::predator, 1), score_of(more->breeding(), Side::predator, 2));
    EXPECT_EQ(score_of(more->breeding(), Side::predator, INFINITY), 1);
    EXPECT_EQ(score_of(more->breeding(), Side::prey, NAN), 0.5F);
    EXPECT_EQ(score_of(seconds->breeding(), Side::prey, 1), 0.25F);
    EXPECT_EQ(complete_generations(*captures, bred(*captures, 1)), 2);
    EXPECT_TRUE(fault_of(top + "fitness = \"closet\"\n" + both)
                    .starts_with("b.toml:9: there is no measure 'closet'; the nearest is 'closest'"))
        << fault_of(top + "fitness = \"closet\"\n" + both);
    EXPECT_NE(fault_of(top + "predator_better = \"les\"\n" + both).find("'less'"), std::string::npos);
}

TEST(Breeding, OneSideAloneEvolvesAgainstTheSceneAsItIs) {
    const auto base = base_of(top + panel + "[[breed]]\nkind = \"hare\"\n" + genes);
    const BreedingState state = bred(*base, 2);
    EXPECT_EQ(base->breed(Side::predator), nullptr);
    EXPECT_EQ(at(state.main.population, Side::predator).size(), 1u);
    EXPECT_EQ(*at(next_trials(*base, state, 3).front().kinds, Side::predator), base->scene().kinds[0]);
    EXPECT_GE(at(state.main.generations, Side::prey)[2].panel, 0);
    const auto again = read_state(*base, write_state(*base, state), "f");
    ASSERT_TRUE(again);
    EXPECT_EQ(*again, state);
}

TEST(Breeding, AChampionDrivesInASavedSceneAsItWasBred) {
    const auto base = base_of(top + alone + both);
    const BreedingState state = bred(*base, 1);
    for (const Trial& trial : next_trials(*base, state, 3)) {
        const auto scene = parse_scene(write_scene(scene_of(*base, trial)), "s.toml");
        ASSERT_TRUE(scene) << scene.error().text();
        auto bred_world = World::create(scene_of(*base, trial), trial.seed), opened = World::create(*scene, trial.seed);
        for (int i = 0; i < 60; ++i) bred_world->step(), opened->step();
        ASSERT_EQ(bred_world->hash(), opened->hash());
    }
}

TEST(Breeding, TheScoresOfBothSidesAddUpToOne) {
    const auto base = base_of(top + alone + both);
    for (const float seconds : {0.0F, 1.0F, 4.0F})
        EXPECT_EQ(score_of(base->breeding(), Side::predator, seconds) + score_of(base->breeding(), Side::prey, seconds),
                  1);
    EXPECT_EQ(score_of(base->breeding(), Side::prey, 4), 1) << "not eaten";
    const auto trials = next_trials(*base, begin_breeding(*base), 3);
    std::set<float> different;
    for (const Trial& trial : trials) different.insert(run_of(*base, trial));
    EXPECT_GT(different.size(), 3u);
    EXPECT_TRUE(different.contains(4.0F));
    EXPECT_LT(*different.begin(), 4.0F);
}

// The documented tables are those of the code. BRAITENLAB_WRITE_DOCS=1 writes them.
TEST(Breeding, TheFormatIsDocumented) {
    const std::filesystem::path path = std::filesystem::path(BRAITENLAB_SOURCE) / "docs" / "breeding.md";
    std::ifstream in(path);
    std::string text{std::istreambuf_iterator<char>(in), {}};
    if (std::getenv("BRAITENLAB_WRITE_DOCS")) {
        text = text.substr(0, text.find("\n## The top of the file")) + describe_breeding_format();
        std::ofstream(path) << text;
    }
    EXPECT_NE(text.find(describe_breeding_format()), std::string::npos);
}

// Every shipped breeding can be bred, and five generations of the first are the same on every platform.
TEST(Breeding, TheShippedOnesAreBredToTheSameBits) {
    const std::filesystem::path folder = std::filesystem::path(BRAITENLAB_SOURCE) / "exercises" / "breeding";
    const auto content = [](const std::filesystem::path& path) {
        std::ifstream in(path);
        return std::string{std::istreambuf_iterator<char>(in), {}};
    };
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".toml") continue;
        auto breeding = parse_breeding(content(entry.path()), entry.path().string());
        ASSERT_TRUE(breeding) << breeding.error().text();
        ++count;
        breeding->seconds = 5, breeding->trials = 2, breeding->panel = 0;
        const std::filesystem::path scene = folder / breeding->scene;
        const auto base = BreedingBase::create(std::move(*breeding), content(scene), scene.string());
        ASSERT_TRUE(base) << base.error().text();
        if (entry.path().stem() != "chase") continue;
        EXPECT_EQ(fmt::format("{:016x}", maths::fnv(write_state(**base, bred(**base, 4)))), "b4a61e2293d102f9");
    }
    EXPECT_EQ(count, 5);
}

TEST(Generalist, AChildReplacesTheWorstOnlyIfItIsWorseAgainstNone) {
    const auto kept = [](const std::vector<std::vector<float>>& scores) {
        std::vector<float> means;
        for (const auto& own : scores) means.push_back((own[0] + own[1]) / 2);
        return generalists(scores, means, 2);
    };
    using Indices = std::vector<std::size_t>;
    EXPECT_EQ(kept({{0.2F, 0.2F}, {0.5F, 0.5F}, {1, 0.1F}}), (Indices{1, 0}))
        << "better in the mean, worse against one";
    EXPECT_EQ(kept({{0.2F, 0.2F}, {0.5F, 0.5F}, {1, 0.2F}}), (Indices{2, 1}));
    EXPECT_EQ(kept({{0.2F, 0.2F}, {0.5F, 0.5F}, {0.2F, 0.2F}}), (Indices{1, 0})) << "equal";
    EXPECT_EQ(kept({{0.2F, 0.2F}, {0.5F, 0.5F}, {0.6F, 0.6F}, {0.7F, 0.7F}}), (Indices{3, 2})) << "one after the other";
}

TEST(Generalist, TheOpponentsAreThoseThatDifferMost) {
    Breed breed{.kind = "k", .genes = {{.name = "a", .paths = {"p"}, .low = 0, .high = 10}}};
    breed.genes.push_back(breed.genes[0]), breed.genes[1].high = 1;
    const std::vector<Genome> known{{1, 0}, {2, 0}, {9, 0}, {1, 1}, {5, 0}};
    EXPECT_EQ(most_different(known, breed, 3), (std::vector<Genome>{known[0], known[3], known[2]}));
    EXPECT_EQ(most_different({known[0], known[1]}, breed, 3), (std::vector<Genome>{known[0], known[1], known[0]}));
}

TEST(Tournament, EveryChampionMeetsEveryOne) {
    const auto base = base_of(top + alone + both);
    const BreedingState state = bred(*base, 3);
    const auto trials = trials_of_tournament(*base, state, 3);
    EXPECT_EQ(trials.size(), 3u * 3u * tournament_trials);
    const Tournament t = tournament_of(*base, state, 3, results_of(*base, trials));
    EXPECT_EQ(t.generations, (std::vector<int>{0, 1, 3}));
    float sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_EQ(t.score(Side::predator, i, k) + t.score(Side::prey, k, i), 1);
            sum += t.score(Side::predator, i, k);
        }
    EXPECT_GT(sum, 0);
    EXPECT_NEAR(
        t.master_score(Side::predator, 0) + t.master_score(Side::predator, 1) + t.master_score(Side::predator, 2),
        sum / 3, 1e-5F);
}

TEST(Tournament, AMatchIsACellOfIt) {
    const auto base = base_of(top + alone + both);
    const BreedingState state = bred(*base, 2);
    const Tournament t = tournament_of(*base, state, 3, results_of(*base, trials_of_tournament(*base, state, 3)));
    for (std::size_t predator = 0; predator < 3; ++predator)
        for (std::size_t prey = 0; prey < 3; ++prey) {
            const auto trials = trials_of_match(*base, state, static_cast<int>(predator), static_cast<int>(prey));
            EXPECT_EQ(score_of_match(*base, results_of(*base, trials)), t.score(Side::predator, predator, prey));
        }
}

TEST(Duel, IsTheRunOfItsTrial) {
    const auto base = base_of(top + alone + both);
    int eaten = 0;
    const auto trials = next_trials(*base, begin_breeding(*base), 3);
    for (const Trial& trial : trials) {
        DuelRun run(*base, trial);
        while (!run.advance(7)) {
        }
        const Duel& duel = run.duel();
        EXPECT_EQ(duel.seconds(), run_of(*base, trial));
        EXPECT_EQ(duel.is_eaten, duel.seconds() < 4);
        ASSERT_EQ(duel.paths[0].size(), duel.paths[1].size());
        auto world = World::create(scene_of(*base, trial), trial.seed);
        for (std::size_t tick = 0; tick < duel.paths[0].size(); ++tick, world->step()) {
            const Snapshot now = snapshot_of(*world);
            if (duel.is_eaten && tick + 1 == duel.paths[0].size()) break;  // the prey is gone, another vehicle came
            for (const VehicleView& vehicle : now.vehicles) {
                const Side side = vehicle.role == Role::predator ? Side::predator : Side::prey;
                EXPECT_EQ(at(duel.paths, side)[tick], (Pose{vehicle.x, vehicle.y, vehicle.heading}));
            }
        }
        if (!duel.is_eaten) continue;
        ++eaten;
        const auto& prey = at(duel.paths, Side::prey);
        EXPECT_LT(std::hypot(prey.back().x - prey[prey.size() - 2].x, prey.back().y - prey[prey.size() - 2].y), 0.5F)
            << "where it was eaten";
    }
    EXPECT_GT(eaten, 0);
    EXPECT_LT(eaten, static_cast<int>(trials.size()));
}

TEST(Tournament, ATrendIsThatOfItsQuartersAndItsCorrelation) {
    const Trend up = trend_of({0, 1, 2, 3, 4, 5, 6, 7});
    EXPECT_FLOAT_EQ(up.first, 0.5F);
    EXPECT_FLOAT_EQ(up.last, 6.5F);
    EXPECT_FLOAT_EQ(up.correlation, 1);
    EXPECT_FLOAT_EQ(trend_of({3, 2, 1}).correlation, -1);
    EXPECT_EQ(trend_of({2, 2, 2}).correlation, 0);
    EXPECT_EQ(trend_of({2}).last, 2);
}

TEST(Tournament, TheIntervalOfACorrelationHoldsItAndIsWideWhereLittleIsKnown) {
    std::vector<float> rising, noise;
    maths::Random random(7, 1);
    for (int i = 0; i < 40; ++i) {
        noise.push_back(random.normal());
        rising.push_back(0.1F * static_cast<float>(i) + 0.3F * noise.back());
    }
    const auto of_rising = correlation_interval(rising), of_noise = correlation_interval(noise);
    ASSERT_TRUE(of_rising && of_noise);
    EXPECT_GT(of_rising->low, 0.8F);
    EXPECT_LT(of_noise->low, 0.0F);
    EXPECT_GT(of_noise->high, 0.0F);
    for (const auto& [scores, interval] : {std::pair(rising, of_rising), std::pair(noise, of_noise)}) {
        const float correlation = trend_of(scores).correlation;
        EXPECT_LT(interval->low, correlation);
        EXPECT_GT(interval->high, correlation);
        EXPECT_EQ(correlation_interval(scores)->low, interval->low) << "the same each time";
    }
    const auto of_few = correlation_interval({noise.begin(), noise.begin() + 10});
    ASSERT_TRUE(of_few);
    EXPECT_GT(of_few->high - of_few->low, of_noise->high - of_noise->low);
    EXPECT_FALSE(correlation_interval({1, 2, 3, 4, 5, 6, 7})) << "too few";
    EXPECT_FALSE(correlation_interval(std::vector<float>(20, 0.5F))) << "constant";
    EXPECT_FALSE(correlation_interval({}));
}

// Of 200 series of noise that have no trend, the interval holds 0 in most.
TEST(Tournament, TheIntervalOfNoiseRarelyLeavesOutZero) {
    maths::Random random(3, 1);
    int left_out = 0;
    for (int series = 0; series < 200; ++series) {
        std::vector<float> noise;
        for (int i = 0; i < 40; ++i) noise.push_back(random.normal());
        const auto interval = correlation_interval(noise);
        ASSERT_TRUE(interval);
        left_out += interval->low > 0 || interval->high < 0;
    }
    EXPECT_LT(left_out, 40) << "of 200";
}

}  // namespace
}  // namespace braitenlab::tests::breeding_test

// One sitting with a scene: the world, the edits made to it, and the way back from them.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/world/world.h"

namespace braitenlab {

class Session {
public:
    // Fails as World::create does.
    static Result<Session> open(const Scene&, std::uint64_t seed);

    // Does what a person asked for. Edits of brains and poses can be undone; those with the same gesture (any number
    // but 0, one per drag) are one step of undo.
    std::optional<Error> apply(const Command&, std::uint64_t gesture = 0);

    // One tick.
    void step();

    // Back to the very start of the run with the brains as they are now: edits stay, time and places start over.
    void reset();

    // Values, never time: an undone weight is the old weight now. False when there is nothing to undo or redo.
    bool undo();
    bool redo();
    int undo_depth() const { return static_cast<int>(done_.size()); }
    int redo_depth() const { return static_cast<int>(undone_.size()); }

    // The moment as it is now; stays valid and changes with the session.
    const Snapshot& snapshot() const { return snapshot_; }
    const Scene& scene() const { return scene_; }
    std::uint64_t seed() const { return seed_; }
    std::uint64_t hash() const { return world_.hash(); }

private:
    struct Edit {
        std::vector<Command> back, again;
        std::uint64_t gesture = 0;
    };

    Session(Scene, std::uint64_t seed, World);
    std::vector<Command> undoing(const Command&) const;
    void carry_out(const std::vector<Command>&);

    Scene scene_;
    std::uint64_t seed_;
    World world_;
    Snapshot snapshot_;
    std::vector<Edit> done_, undone_;
};

}  // namespace braitenlab

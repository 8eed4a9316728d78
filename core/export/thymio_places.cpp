#include "core/export/thymio_places.h"

#include <string>
#include <utility>
#include <vector>

#include "core/messages.h"
#include "core/scene/enums.h"
#include "core/scene/nearest.h"

namespace braitenlab::robots::thymio {

std::optional<Place> place_of(const Input& input) {
    const char letter = input.name.empty() ? ' ' : input.name.back();
    const Side side = letter == 'L' ? Side::left : letter == 'R' ? Side::right : Side::middle;
    switch (input.channel.value_or(Channel::light)) {
        case Channel::light:
        case Channel::obstacle:
            return Place{false, side};
        case Channel::floor:
            return Place{true, side};
        default:
            return std::nullopt;
    }
}

std::optional<Error> sensor_refusal(const Plan& plan) {
    std::vector<std::pair<Place, std::string>> used;
    for (const Input& input : plan.inputs) {
        const auto place = place_of(input);
        if (!place) return error_of(message_of("no_part", in_quotes(input.name), word(*input.channel)));
        for (const auto& [other, name] : used)
            if (other == *place)
                return error_of(message_of("thymio_same_sensor", in_quotes(name), in_quotes(input.name)));
        used.emplace_back(*place, input.name);
    }
    return std::nullopt;
}

}  // namespace braitenlab::robots::thymio

#include "app/pictures/colour_table.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace braitenlab {

namespace {

constexpr int steps = 64;                          // of a channel in ColourCount
constexpr float dither_levels = 3;                 // of 255, from the darkest to the brightest shift
constexpr std::array<int, 3> importance{3, 4, 2};  // of a difference in red, green and blue to the eye

struct Weighted {
    std::array<float, 3> colour;
    float weight;
};

using Colours = std::vector<Weighted>;

struct Box {
    Colours::iterator begin, end;
    std::size_t longest = 0;  // channel of the largest spread
    float spread = 0, mean = 0;
};

Box measured(Colours::iterator begin, Colours::iterator end) {
    Box box{begin, end};
    for (std::size_t channel = 0; channel < 3; ++channel) {
        double weight = 0, sum = 0, squares = 0;
        for (auto c = begin; c != end; ++c) {
            const double value = static_cast<double>(c->colour[channel]), w = static_cast<double>(c->weight);
            weight += w, sum += w * value, squares += w * value * value;
        }
        const double mean = sum / weight, spread = (squares - sum * mean) * importance[channel];
        if (channel > 0 && static_cast<float>(spread) <= box.spread) continue;
        box.longest = channel, box.spread = static_cast<float>(spread), box.mean = static_cast<float>(mean);
    }
    return box;
}

Rgb mean_of(const Box& box) {
    std::array<double, 3> sum{};
    double weight = 0;
    for (auto c = box.begin; c != box.end; ++c) {
        weight += static_cast<double>(c->weight);
        for (std::size_t i = 0; i < 3; ++i) sum[i] += static_cast<double>(c->weight * c->colour[i]);
    }
    Rgb mean{};
    for (std::size_t i = 0; i < 3; ++i) mean[i] = static_cast<std::uint8_t>(std::lround(sum[i] / weight));
    return mean;
}

}  // namespace

ColourCount::ColourCount() : bins_(static_cast<std::size_t>(steps * steps * steps)) {}

void ColourCount::add(std::span<const unsigned char> rgb) {
    for (std::size_t i = 0; i + 2 < rgb.size(); i += 3) {
        Bin& bin = bins_[static_cast<std::size_t>((rgb[i] >> 2) << 12 | (rgb[i + 1] >> 2) << 6 | rgb[i + 2] >> 2)];
        ++bin.count;
        for (std::size_t c = 0; c < 3; ++c) bin.sum[c] += rgb[i + c];
    }
}

std::vector<Rgb> ColourCount::choose(std::size_t most) const {
    Colours all;
    for (const Bin& bin : bins_) {
        if (bin.count == 0) continue;
        const auto count = static_cast<float>(bin.count);
        Weighted colour{{}, std::sqrt(count)};
        for (std::size_t c = 0; c < 3; ++c) colour.colour[c] = static_cast<float>(bin.sum[c]) / count;
        all.push_back(colour);
    }
    if (all.empty()) return {Rgb{}};
    std::vector<Box> boxes{measured(all.begin(), all.end())};
    while (boxes.size() < most) {
        const auto widest = std::max_element(boxes.begin(), boxes.end(),
                                             [](const Box& a, const Box& b) { return a.spread < b.spread; });
        if (widest->spread <= 1) break;
        const Box box = *widest;
        const auto middle =
            std::partition(box.begin, box.end, [&box](const Weighted& c) { return c.colour[box.longest] < box.mean; });
        if (middle == box.begin || middle == box.end) {
            widest->spread = 0;
            continue;
        }
        *widest = measured(box.begin, middle);
        boxes.push_back(measured(middle, box.end));
    }
    std::vector<Rgb> colours;
    for (const Box& box : boxes) colours.push_back(mean_of(box));
    return colours;
}

ColourTable::ColourTable(std::vector<Rgb> colours) : colours_(std::move(colours)), known_(std::size_t{1} << 21U, -1) {
    assert(!colours_.empty() && colours_.size() <= 255);
}

std::uint8_t ColourTable::search(Rgb wanted) const {
    int best = std::numeric_limits<int>::max();
    std::size_t found = 0;
    for (std::size_t i = 0; i < colours_.size(); ++i) {
        int distance = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const int step = int{wanted[c]} - int{colours_[i][c]};
            distance += importance[c] * step * step;
        }
        if (distance < best) best = distance, found = i;
    }
    return static_cast<std::uint8_t>(found);
}

std::uint8_t ColourTable::nearest(Rgb colour, int x, int y) {
    constexpr std::array<int, 16> order{0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};  // of 4 by 4 pixels
    const int place = order[static_cast<std::size_t>((y & 3) * 4 + (x & 3))];
    const float shift = dither_levels * ((static_cast<float>(place) + 0.5f) / 16 - 0.5f);
    std::size_t key = 0;
    for (std::uint8_t& channel : colour) {
        const float shifted = std::floor(static_cast<float>(channel) + shift + 0.5f);
        channel = static_cast<std::uint8_t>(std::clamp(shifted, 0.0f, 255.0f)) & 0xfeU;
        key = key << 7U | static_cast<std::size_t>(channel >> 1U);
    }
    if (known_[key] < 0)
        known_[key] = search({static_cast<std::uint8_t>(colour[0] | 1U), static_cast<std::uint8_t>(colour[1] | 1U),
                              static_cast<std::uint8_t>(colour[2] | 1U)});
    return static_cast<std::uint8_t>(known_[key]);
}

}  // namespace braitenlab

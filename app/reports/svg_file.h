// The frame of an SVG file that opens in a browser and in Inkscape.
#pragma once

#include <string>
#include <string_view>

namespace braitenlab {

// `content`: elements below a heading, which takes 40 px. White ground; texts are text, in a sans-serif font.
std::string svg_file(std::string_view heading, float width, float height, std::string_view content);

}  // namespace braitenlab

// A schematic as it is read from its drawing: wires, symbols, texts, and which wires are connected. For tests.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace braitenlab::tests::schematic {

struct Point {
    double x = 0, y = 0;
};
inline bool is_same(Point a, Point b) { return std::fabs(a.x - b.x) < 0.5 && std::fabs(a.y - b.y) < 0.5; }

struct Segment {  // of a wire: level or upright
    Point a, b;
    bool touches(Point p) const {
        return p.x > std::min(a.x, b.x) - 0.5 && p.x < std::max(a.x, b.x) + 0.5 && p.y > std::min(a.y, b.y) - 0.5 &&
               p.y < std::max(a.y, b.y) + 0.5;
    }
    bool ends_at(Point p) const { return is_same(a, p) || is_same(b, p); }
};

struct Box {
    double left = 0, upper = 0, right = 0, lower = 0;
    bool meets(const Box& o) const { return left < o.right && o.left < right && upper < o.lower && o.upper < lower; }
    bool holds(const Box& o) const {
        return left <= o.left && o.right <= right && upper <= o.upper && o.lower <= lower;
    }
};

struct Words {
    Point at;
    std::string anchor, text;
    Box box;
};

struct Picture {
    std::vector<Segment> wires, bars;  // bars: of symbols, connected to nothing else
    std::vector<Point> dots, terminals, grounds, supplies, triangles, capacitors, diodes;
    std::vector<Box> boxes;
    std::vector<Words> words;
};

// Level and upright lines of path data; the other ones belong to symbols.
inline std::vector<Segment> lines_of(const std::string& path) {
    std::istringstream in(path);
    std::vector<Segment> lines;
    Point pen;
    for (char command = 0; in >> command;) {
        double x = 0, y = 0;
        const Point from = pen;
        if (command == 'M' && in >> x >> y) pen = {x, y};
        if ((command == 'm' || command == 'l') && in >> x >> y) pen = {pen.x + x, pen.y + y};
        if (command == 'h' && in >> x) pen.x += x;
        if (command == 'H' && in >> x) pen.x = x;
        if (command == 'v' && in >> y) pen.y += y;
        if (command == 'V' && in >> y) pen.y = y;
        if (std::string_view("hHvV").find(command) != std::string_view::npos) lines.push_back({from, pen});
    }
    return lines;
}

inline void read_path(Picture& picture, const std::string& path) {
    const auto lines = lines_of(path);
    const auto holds = [&](const char* part) { return path.find(part) != std::string::npos; };
    if (holds("z")) return picture.triangles.push_back(lines[0].a);
    std::istringstream begin(path.substr(1));
    Point start;
    begin >> start.x >> start.y;
    if (holds("m-8 0h16m-16 6h16")) picture.capacitors.push_back(start);
    if (holds("l12 -6v12l-12 -6")) picture.diodes.push_back(start);
    if (holds("l")) return;
    const bool ground = holds("v4m-7"), supply = holds("v-6m-7");
    if (ground) picture.grounds.push_back(lines[0].a);
    if (supply) picture.supplies.push_back(lines[0].a);
    // Signs of the inputs of an amplifier (h6) and the end of a wire from the supply (m0 −5) are symbols, too.
    const bool symbol = ground || supply || holds("m");
    auto& to = symbol || path.ends_with("h6") ? picture.bars : picture.wires;
    to.insert(to.end(), lines.begin(), lines.end());
}

inline std::string unescaped(std::string text) {
    for (const auto& [entity, c] :
         {std::pair{"&lt;", "<"}, std::pair{"&gt;", ">"}, std::pair{"&quot;", "\""}, std::pair{"&amp;", "&"}})
        for (std::size_t at = 0; (at = text.find(entity, at)) != std::string::npos; ++at)
            text.replace(at, std::string_view(entity).size(), c);
    return text;
}

inline Picture read_picture(const std::string& svg) {
    Picture picture;
    const std::regex path(R"re(<path d="([^"]*)")re"), circle(R"re(<circle cx="(\d+)" cy="(\d+)" r="([\d.]+)")re"),
        rect(R"re(<rect x="(\d+)" y="(\d+)" width="(\d+)" height="(\d+)")re"),
        text(R"re(<text x="(\d+)" y="(\d+)" text-anchor="(\w+)"([^>]*)>([^<]*)<)re"), size(R"re(font-size:([\d.]+))re"),
        length(R"re(textLength="(\d+)")re");
    std::istringstream lines(svg);
    std::smatch found;
    for (std::string line; std::getline(lines, line);) {
        if (std::regex_search(line, found, path)) read_path(picture, found[1]);
        if (std::regex_search(line, found, circle))
            (found[3] == "3" ? picture.terminals : picture.dots).push_back({std::stod(found[1]), std::stod(found[2])});
        if (std::regex_search(line, found, rect)) {
            const double x = std::stod(found[1]), y = std::stod(found[2]);
            picture.boxes.push_back({x, y, x + std::stod(found[3]), y + std::stod(found[4])});
        }
        if (!std::regex_search(line, found, text)) continue;
        const std::string style = found[4], words = unescaped(found[5]);
        const double x = std::stod(found[1]), y = std::stod(found[2]);
        const bool bold = style.find("name") != std::string::npos;
        std::smatch number;
        double font = bold ? 12 : 10, width = 0;
        if (std::regex_search(style, number, size)) font = std::stod(number[1]);
        for (const char c : words)
            if ((static_cast<unsigned char>(c) & 0xc0) != 0x80) width += (bold ? 0.66 : 0.6) * font;
        if (std::regex_search(style, number, length)) width = std::stod(number[1]);
        const double left = x - (found[3] == "end" ? width : found[3] == "middle" ? width / 2 : 0);
        picture.words.push_back({{x, y}, found[3], words, {left, y - 0.75 * font, left + width, y + 0.15 * font}});
    }
    return picture;
}

// ---- Nets ----

// The wires of a picture in groups of those that are connected.
class Nets {
public:
    explicit Nets(const Picture& picture) : picture_(picture), group_(picture.wires.size()) {
        std::iota(group_.begin(), group_.end(), 0u);
        for (std::size_t i = 0; i < group_.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const Segment &a = picture.wires[i], &b = picture.wires[j];
                if (a.touches(b.a) || a.touches(b.b) || b.touches(a.a) || b.touches(a.b)) join(i, j);
            }
        for (const Point& t : picture.terminals) {
            std::size_t first = group_.size();
            for (std::size_t i = 0; i < group_.size(); ++i)
                for (const double side : {-3.0, 3.0})
                    if (picture.wires[i].ends_at({t.x + side, t.y}))
                        first < group_.size() ? join(i, first) : void(first = i);
        }
        name_groups();
    }

    // Of the wire at this point: a node of the netlist, or an empty text.
    std::string at(Point p) const {
        for (std::size_t i = 0; i < group_.size(); ++i)
            if (picture_.wires[i].touches(p)) return name_of(group_[i]);
        return "";
    }

private:
    void join(std::size_t i, std::size_t j) {
        const std::size_t from = group_[i], to = group_[j];
        for (std::size_t& group : group_)
            if (group == from) group = to;
    }
    std::string name_of(std::size_t group) const {
        const auto found = names_.find(group);
        return found == names_.end() || found->second.size() != 1 ? "" : *found->second.begin();
    }
    void name(Point p, const std::string& node) {
        for (std::size_t i = 0; i < group_.size(); ++i)
            if (picture_.wires[i].touches(p)) names_[group_[i]].insert(node);
    }
    void name_groups() {
        for (const Point& p : picture_.grounds) name(p, "0");
        std::string first_half;
        for (const Words& w : picture_.words) {
            const auto begins = [&](const char* with) { return w.text.starts_with(with); };
            for (const Point& p : picture_.supplies)
                if (is_same(w.at, {p.x, p.y - 9})) name(p, w.text == "9 V" ? "v9" : "v5");
            if (w.anchor == "end" && (w.text == "5 V" || begins("buffered_")))
                name({w.at.x + 4, w.at.y - 4}, w.text == "5 V" ? "v5" : w.text);
            if (w.anchor != "start") continue;
            const bool is_output = w.text == "left" || w.text == "right", is_driver = w.text.ends_with("t_driver");
            // Right of an output's wire, and of the terminal of the motor driver's input.
            if (is_output) name({w.at.x - 9, w.at.y - 4}, w.text);
            if (is_driver) name({w.at.x - 9, w.at.y - 2}, w.text);
            if (is_output || is_driver) continue;
            // Above a wire; a long name is in two lines.
            if (begins("sensor_") || begins("buffered_") || begins("left_") || begins("right_")) first_half = w.text;
            if (first_half.empty()) continue;
            if (w.text != first_half) first_half += w.text;
            bool is_above = false;
            for (const Segment& s : picture_.wires) is_above |= s.touches({w.at.x, w.at.y + 5});
            if (is_above) name({w.at.x, w.at.y + 5}, first_half), first_half.clear();
        }
    }

    const Picture& picture_;
    std::vector<std::size_t> group_;
    std::map<std::size_t, std::set<std::string>> names_;
};

}  // namespace braitenlab::tests::schematic

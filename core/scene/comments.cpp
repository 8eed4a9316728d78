#include "core/scene/comments.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "core/text_parts.h"

namespace braitenlab {

namespace {

using Lines = std::vector<std::string>;

Lines lines_of(std::string_view text) {
    Lines lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.emplace_back(text.substr(0, end));
        if (!lines.back().empty() && lines.back().back() == '\r') lines.back().pop_back();
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

// The position of the '#' that begins a comment, outside quotes; npos: none.
std::size_t comment_at(std::string_view line) {
    char quote = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (quote != 0) {
            if (c == '\\' && quote == '"') ++i;
            if (c == quote) quote = 0;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else if (c == '#') {
            return i;
        }
    }
    return std::string_view::npos;
}

// A key or a path of keys without quotes and blanks: "kind.prey.body".
std::string plain_path(std::string_view keys) {
    std::string path;
    for (const char c : keys)
        if (c != ' ' && c != '\t' && c != '"' && c != '\'') path += c;
    return path;
}

// The path of what each line states, with the numbers of list entries: "kind.prey.body.wheel.2.load".
class LinePaths {
public:
    // True if the next line begins in a text of several lines.
    bool in_text() const { return in_text_; }

    // Of a heading or a key with its value; nullopt for other lines and for those of a text of several lines.
    std::optional<std::string> next(std::string_view line) {
        const bool begins_in_text = in_text_;
        for (const std::string_view marks : {"\"\"\"", "'''"})
            for (std::size_t at = line.find(marks); at != std::string_view::npos; at = line.find(marks, at + 3))
                in_text_ = !in_text_;
        line = trimmed(line.substr(0, comment_at(line)));
        if (begins_in_text || line.empty()) return std::nullopt;
        if (line.front() == '[' && line.back() == ']') return heading(line);
        const std::size_t equals = line.find('=');
        if (equals == std::string_view::npos || line.front() == ']') return std::nullopt;
        const std::string key = plain_path(line.substr(0, equals));
        return table_.empty() ? key : table_ + "." + key;
    }

private:
    std::string heading(std::string_view line) {
        const bool is_entry = line.starts_with("[[");
        const std::size_t brackets = is_entry ? 2 : 1;
        const std::string path = plain_path(line.substr(brackets, line.size() - 2 * brackets));
        table_.clear();
        std::string plain;  // without numbers
        for (std::size_t from = 0; from < path.size();) {
            const std::size_t dot = std::min(path.find('.', from), path.size());
            plain += (plain.empty() ? "" : ".") + path.substr(from, dot - from);
            table_ += (table_.empty() ? "" : ".") + path.substr(from, dot - from);
            if (dot == path.size() && is_entry) ++entries_[table_];
            if (const auto entry = entries_.find(table_); entry != entries_.end())
                table_ += "." + std::to_string(entry->second);
            from = dot + 1;
        }
        return table_;
    }

    std::map<std::string, int> entries_;  // of each list, so far
    std::string table_;
    bool in_text_ = false;
};

// The comments at one table or key.
struct Remarks {
    Lines above;         // comments, and empty lines between them
    std::string behind;  // "# cm", empty: none
    Lines below;         // indented lines that go on with `behind`
};

struct OldRemarks {
    std::map<std::string, Remarks> at;  // by path
    Lines end;                          // at the end of the file
};

OldRemarks remarks_of(std::string_view text) {
    OldRemarks found;
    LinePaths paths;
    Lines waiting;
    Remarks* last = nullptr;  // whose comment an indented line goes on with
    for (const std::string& line : lines_of(text)) {
        const bool in_text = paths.in_text();
        const auto path = paths.next(line);
        const std::size_t comment = comment_at(line);
        if (in_text) continue;
        if (path) {
            Remarks& here = found.at[*path];
            here.above.insert(here.above.end(), waiting.begin(), waiting.end());
            waiting.clear();
            if (comment != line.npos) here.behind = line.substr(comment);
            last = comment != line.npos ? &here : nullptr;
            continue;
        }
        const bool is_comment = trimmed(line).starts_with("#");
        if (is_comment && last && !line.starts_with("#")) {
            last->below.push_back(line);
            continue;
        }
        last = nullptr;
        if (is_comment) {
            waiting.emplace_back(trimmed(line));
        } else if (trimmed(line).empty() && !waiting.empty()) {
            waiting.emplace_back();
        }
    }
    while (!waiting.empty() && waiting.back().empty()) waiting.pop_back();
    found.end = std::move(waiting);
    return found;
}

bool has_comment(const Remarks& remarks) { return !remarks.above.empty() || !remarks.behind.empty(); }

// Moves the comments of paths that are not written to the nearest table around them that is; "" is the whole file.
std::map<std::string, Lines> moved_remarks(OldRemarks& old, const std::set<std::string>& written) {
    std::map<std::string, Lines> moved;
    for (auto& [path, remarks] : old.at) {
        if (!has_comment(remarks) || written.contains(path)) continue;
        std::string around = path;
        while (!around.empty() && !written.contains(around))
            around = around.find('.') == around.npos ? "" : around.substr(0, around.rfind('.'));
        Lines& lines = moved[around];
        for (const std::string& line : remarks.above)
            if (!line.empty()) lines.push_back(line);
        const std::string name = around.empty() ? path : path.substr(around.size() + 1);
        if (!remarks.behind.empty())
            lines.push_back("# " + name + ": " + std::string(trimmed(std::string_view(remarks.behind).substr(1))));
        for (const std::string& line : remarks.below) lines.emplace_back(trimmed(line));
    }
    return moved;
}

}  // namespace

std::string with_comments(std::string_view written, std::string_view old_text) {
    const Lines lines = lines_of(written);
    std::vector<std::optional<std::string>> path_of;
    std::set<std::string> known;
    LinePaths paths;
    for (const std::string& line : lines) {
        path_of.push_back(paths.next(line));
        if (path_of.back()) known.insert(*path_of.back());
    }
    OldRemarks old = remarks_of(old_text);
    const std::map<std::string, Lines> moved = moved_remarks(old, known);
    std::string text;
    const auto add = [&](const Lines& more) {
        for (const std::string& line : more) text += line + "\n";
    };
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::string path = path_of[i].value_or("");
        const auto found = path_of[i] ? old.at.find(path) : old.at.end();
        if (found != old.at.end()) add(found->second.above);
        text += lines[i];
        if (found != old.at.end() && !found->second.behind.empty()) text += "  " + found->second.behind;
        text += "\n";
        if (found != old.at.end()) add(found->second.below);
        if (i == 0)
            if (const auto whole = moved.find(""); whole != moved.end()) add(whole->second);
        if (const auto inner = moved.find(path); inner != moved.end() && !path.empty()) add(inner->second);
    }
    if (!old.end.empty()) text += "\n", add(old.end);
    return text;
}

}  // namespace braitenlab

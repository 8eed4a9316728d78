#include "core/scene/paths.h"

#include "core/scene/schema.h"

namespace braitenlab {

namespace {

// The visitor of core/scene/schema.h that collects paths.
template <class T>
class PathList {
public:
    PathList(const T& object, std::string prefix, std::vector<std::string>& paths)
        : object_(object), prefix_(std::move(prefix)), paths_(paths) {}

    template <class Number>
    void number(const char* key, Number T::*, const char*, Range, const char*) {
        paths_.push_back(prefix_ + key);
    }
    void angle(const char* key, float T::*, Range, const char*) { paths_.push_back(prefix_ + key); }
    void flag(const char* key, bool T::*, const char*) { paths_.push_back(prefix_ + key); }
    template <class Enum>
    void word(const char* key, Enum T::*, const char*) {
        paths_.push_back(prefix_ + key);
    }
    void text(const char* key, std::string T::*, std::size_t, const char*) { paths_.push_back(prefix_ + key); }
    template <class Inner>
    void table(const char* key, Inner T::*member, const char*) {
        walk(object_.*member, prefix_ + key + ".");
    }
    template <class Element>
    void named(const char* key, std::vector<Element> T::*member, std::size_t, const char*) {
        for (const Element& element : object_.*member) walk(element, prefix_ + key + "." + element.name + ".");
    }
    template <class Element>
    void list(const char*, std::vector<Element> T::*, std::size_t, const char*) {}
    void brain(const char* key, BrainGraph T::*, const char*) { walk(FourNeurons{}, prefix_ + key + "."); }

private:
    template <class Inner>
    void walk(const Inner& inner, const std::string& prefix) {
        PathList<Inner> list(inner, prefix, paths_);
        describe(list, Of<Inner>{});
    }

    const T& object_;
    std::string prefix_;
    std::vector<std::string>& paths_;
};

}  // namespace

std::vector<std::string> setting_paths(const Scene& scene) {
    std::vector<std::string> paths;
    PathList<Scene> list(scene, "", paths);
    describe(list, Of<Scene>{});
    return paths;
}

}  // namespace braitenlab

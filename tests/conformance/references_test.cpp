// The library against hashes of OSMesa's pictures, recorded in references.txt: for machines without OSMesa.
#include <algorithm>
#include <fstream>
#include <iomanip>
#include <sstream>

#include <gtest/gtest.h>

#include "catalogue.h"
#include "options.h"
#ifdef RASTER_HAVE_OSMESA
#include "osmesa.h"
#endif

namespace {

using namespace raster::conformance;

constexpr std::uint64_t recorded_seeds[] = {1, 2};

struct Reference {
    std::string kind;
    std::uint64_t seed;
    std::uint64_t hash;
};

struct References {
    std::string renderer;  ///< who made them: Mesa's version and the driver's name
    std::vector<Reference> all;
};

References read_references() {
    References references;
    std::ifstream file(RASTER_REFERENCES);
    std::string line;
    while (std::getline(file, line)) {
        std::istringstream words(line);
        Reference r;
        if (line.starts_with("renderer ")) {
            references.renderer = line.substr(9);
        } else if (!line.starts_with("#") && words >> r.kind >> r.seed >> std::hex >> r.hash) {
            references.all.push_back(r);
        }
    }
    return references;
}

Scene scene_of(const Reference& reference) {
    const auto& kinds = exact_kinds();
    const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& k) { return k.name == reference.kind; });
    EXPECT_NE(kind, kinds.end()) << reference.kind;
    return kind == kinds.end() ? Scene{} : kind->make(reference.seed);
}

#ifdef RASTER_HAVE_OSMESA

// The first test, because it writes the file when asked to.
TEST(References, TheFileIsWhatThisOSMesaDraws) {
    Oracle& oracle = Oracle::instance();
    const std::string renderer = oracle.version();
    if (!options.write_references.empty()) {
        std::ofstream file(options.write_references);
        file << "# Hashes of the pictures that OSMesa drew of scenes in catalogue.cpp: kind, seed, hash.\n"
             << "# To make them anew: raster_conformance --write-references=tests/conformance/references.txt\n"
             << "renderer " << renderer << "\n";
        for (const Kind& kind : exact_kinds())
            for (const std::uint64_t seed : recorded_seeds)
                file << kind.name << " " << std::dec << seed << " " << std::hex << std::setw(16) << std::setfill('0')
                     << hash_of(oracle.render(kind.make(seed))) << "\n";
        ASSERT_TRUE(file.flush());
    }
    const References references = read_references();
    if (references.renderer != renderer)
        GTEST_SKIP() << "recorded with " << references.renderer << ", here is " << renderer;
    for (const Reference& reference : references.all)
        EXPECT_EQ(hash_of(oracle.render(scene_of(reference))), reference.hash)
            << reference.kind << " " << reference.seed;
}

#endif

TEST(References, EveryKindOfSceneIsRecorded) {
    const References references = read_references();
    EXPECT_FALSE(references.renderer.empty());
    for (const Kind& kind : exact_kinds())
        for (const std::uint64_t seed : recorded_seeds)
            EXPECT_EQ(std::count_if(references.all.begin(), references.all.end(),
                                    [&](const Reference& r) { return r.kind == kind.name && r.seed == seed; }),
                      1)
                << kind.name << " " << seed;
}

TEST(References, TheLibraryDrawsWhatOSMesaDrew) {
    for (const Reference& reference : read_references().all) {
        const Scene scene = scene_of(reference);
        EXPECT_EQ(hash_of(render(scene, Path::fast)), reference.hash) << reference.kind << " " << reference.seed;
        EXPECT_EQ(hash_of(render(scene, Path::observed)), reference.hash) << reference.kind << " " << reference.seed;
    }
}

}  // namespace

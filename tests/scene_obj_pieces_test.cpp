// scene_obj_pieces_test.cpp: a text read in pieces, or many lines at once, gives the same as read line by line.
#include <raster/scene/obj_parse.h>

#include <cstring>

#include <raster/scene/obj_lines.h>

#include "random.h"
#include "scene_obj_testing.h"

#if !defined(RASTER_NO_THREADS)
#include <tbb/task_arena.h>
#endif

namespace raster::obj {
namespace {

using testing::Random;

struct Read {
    ObjData data;
    LoadReport report;
    std::string error;
};

Read read(const std::string& text, const ObjOptions& options, const Finder* finder, std::size_t piece_bytes) {
    Read result;
    Log log(result.report, options.strict);
    result.data = parse_statements(text, "m.obj", finder, options, log, piece_bytes);
    if (log.failed()) result.error = log.error().message;
    return result;
}

template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

std::vector<std::string> material_names(const ObjData& data) {
    std::vector<std::string> names;
    for (const MaterialEntry& entry : data.material_library.entries)
        names.push_back(entry.file + ":" + entry.material.name);
    return names;
}

/// What is different, in a word, or "".
std::string difference(const Read& a, const Read& b) {
    const LoadReport &r = a.report, &s = b.report;
    if (a.error != b.error) return "error: " + a.error + "; or: " + b.error;
    if (r.messages() != s.messages()) return "messages";
    if (r.positions != s.positions || r.texture_coordinates != s.texture_coordinates || r.normals != s.normals)
        return "counts of vertices";
    if (r.faces != s.faces || r.dropped_faces != s.dropped_faces || r.lines != s.lines || r.points != s.points)
        return "counts of faces, lines, points";
    if (r.has_vertex_colors != s.has_vertex_colors) return "has_vertex_colors";
    if (!a.error.empty()) return "";
    const ObjData &d = a.data, &e = b.data;
    if (!same_bytes(d.positions, e.positions)) return "positions";
    if (!same_bytes(d.colors, e.colors)) return "colors";
    if (!same_bytes(d.uvs, e.uvs) || !same_bytes(d.normals, e.normals)) return "uvs or normals";
    if (!same_bytes(d.corners, e.corners)) return "corners";
    if (d.face_ends != e.face_ends || d.face_lines != e.face_lines) return "faces";
    if (!same_bytes(d.runs, e.runs)) return "runs";
    if (d.names != e.names || d.material_names != e.material_names) return "names";
    if (d.material_lines != e.material_lines) return "material_lines";
    if (d.bad_positions != e.bad_positions || d.bad_position_line != e.bad_position_line ||
        d.bad_position_word != e.bad_position_word)
        return "bad positions";
    if (material_names(d) != material_names(e)) return "library";
    return "";
}

/// Texts of all statements, mostly without faults.
class Writer {
public:
    explicit Writer(Random& random) : random_(random), faults_(random.integer(0, 3)), ends_(random.integer(0, 3)) {}

    std::string write(int lines) {
        if (chance(5)) text_ = "\xef\xbb\xbf";
        for (int line = 0; line < lines; ++line) {
            if (chance(15)) text_ += chance(2) ? "  " : "\t";
            statement();
            if (chance(15)) text_ += chance(2) ? " \t" : " # comment";
            if (line + 1 < lines || chance(2)) end_line();
        }
        return text_;
    }

private:
    bool chance(int of) { return random_.integer(1, of) == 1; }
    bool fault() { return faults_ == 3 ? chance(20) : faults_ == 2 && chance(300); }
    void end_line() {
        const char* const mixed = chance(2) ? "\n" : chance(2) ? "\r\n" : "\r";
        text_ += ends_ == 3 ? mixed : ends_ == 2 ? "\r\n" : "\n";
    }
    /// A blank, or the end of a line that goes on.
    void gap() {
        text_ += ' ';
        if (!chance(25)) return;
        text_ += chance(2) ? "\\" : "\\  ";
        end_line();
    }
    void word(const std::string& word) { gap(), text_ += word; }

    void numbers(int count) {
        for (int i = 0; i < count; ++i) {
            const char* const bad[] = {"nan", "1e999", "x", "1,5", "-"};
            char text[32];
            const char* const formats[] = {"%.6f", "%g", "%.9e", "%.0f"};
            std::snprintf(text, sizeof text, formats[random_.integer(0, 3)], double(random_.uniform(-9, 9)));
            word(fault() ? bad[random_.integer(0, 4)] : text);
        }
    }

    std::string index(int count) {
        if (fault()) return std::to_string(random_.integer(-count - 2, count + 3));
        if (chance(3)) return std::to_string(-random_.integer(1, std::max(count, 1)));
        return std::to_string(random_.integer(1, count + (chance(50) ? 40 : 0) + 1));
    }

    void face() {
        text_ += 'f';
        const int form = random_.integer(0, 3), corners = chance(40) ? random_.integer(0, 2) : random_.integer(3, 5);
        for (int i = 0; i < corners; ++i) {
            std::string corner = index(positions_);
            if (form == 1) corner += "/" + index(uvs_);
            if (form == 2) corner += "//" + index(normals_);
            if (form == 3) corner += "/" + index(uvs_) + "/" + index(normals_);
            if (fault()) corner += chance(2) ? "/" : "x";
            word(corner);
        }
    }

    void statement() {
        const std::string name = std::string("name") + char('a' + random_.integer(0, 3));
        const int kind = random_.integer(0, 99);
        if (kind < 30) {
            text_ += 'v', ++positions_, numbers(chance(30) ? 6 : chance(30) ? 4 : 3);
        } else if (kind < 40) {
            text_ += "vt", ++uvs_, numbers(random_.integer(1, 3));
        } else if (kind < 50) {
            text_ += "vn", ++normals_, numbers(3);
        } else if (kind < 80) {
            positions_ > 0 ? face() : end_line();
        } else if (kind < 85) {
            text_ += "usemtl", word(name);
        } else if (kind < 89) {
            text_ += chance(2) ? "g" : "o";
            if (!chance(5)) word(name), word(name);
        } else if (kind < 92) {
            text_ += "s", word(chance(3) ? "off" : std::to_string(random_.integer(0, 3)));
        } else if (kind < 95) {
            text_ += chance(2) ? "# a comment \\" : "";
        } else if (kind < 96) {
            text_ += chance(2) ? "l 1 2" : "p 1";
        } else if (kind < 97) {
            const std::string zeros = std::string("v 1 2\0 3", 8) + std::string(chance(9) ? 90 : 0, '1');
            if (fault()) text_ += chance(2) ? "unknown 1" : zeros;
        } else if (kind < 98) {
            if (chance(3)) text_ += "mtllib", word(chance(2) ? "one.mtl" : chance(2) ? "two.mtl" : "none.mtl");
        } else if (fault()) {
            text_ += "\xef\xbb\xbf";
        }
    }

    Random& random_;
    const int faults_, ends_;
    int positions_ = 0, uvs_ = 0, normals_ = 0;
    std::string text_;
};

TEST(ObjPieces, WhereAStatementStarts) {
    EXPECT_EQ(next_start("v 1\nv 2\n", 0), 4u);
    EXPECT_EQ(next_start("v 1\nv 2\n", 3), 4u);
    EXPECT_EQ(next_start("v 1\nv 2\n", 4), 8u);
    EXPECT_EQ(next_start("v 1\nv 2", 4), 7u);
    EXPECT_EQ(next_start("v 1\nv 2", 99), 7u);
    EXPECT_EQ(next_start("v\r\nw", 0), 3u);
    EXPECT_EQ(next_start("v\r\nw", 2), 3u);
    EXPECT_EQ(next_start("v\rw", 0), 2u);
    EXPECT_EQ(next_start("v \\\n1\nv", 0), 6u);
    EXPECT_EQ(next_start("v \\ \t\r\n1\nv", 0), 9u);
    EXPECT_EQ(next_start("v \\\r\n1\nv", 4), 7u);  // between CR and LF
    EXPECT_EQ(next_start("v\n\xef\xbb\xbfv\nw", 0), 7u);
}

TEST(ObjPieces, AreReadAsTheWholeIs) {
    const testing::Folder folder;
    folder.write("one.mtl", "newmtl namea\nKd 1 0 0\nnewmtl nameb\nunknown 1\n");
    folder.write("two.mtl", "newmtl namea\nnewmtl namec\n");
    const Finder finder(folder.path("."), false);
    Random random(50);
    int errors = 0, warnings = 0, plain = 0;
    for (int round = 0; round < 3000; ++round) {
        const std::string text = Writer(random).write(random.integer(1, 120));
        ObjOptions options;
        options.strict = random.integer(0, 4) == 0;
        if (random.integer(0, 9) == 0) options.max_triangles = std::size_t(random.integer(1, 30));
        if (random.integer(0, 9) == 0) options.max_line_bytes = 80;
        const Finder* const used = random.integer(0, 1) == 0 ? &finder : nullptr;
        const Read whole = read(text, options, used, SIZE_MAX / 32);
        for (const int piece_bytes : {random.integer(1, 20), random.integer(20, 200), random.integer(200, 3000)})
            ASSERT_EQ(difference(whole, read(text, options, used, std::size_t(piece_bytes))), "")
                << "pieces of " << piece_bytes << " of:\n" << text;
        ++(!whole.error.empty() ? errors : whole.report.warnings.empty() ? plain : warnings);
    }
    EXPECT_GT(errors, 300);
    EXPECT_GT(warnings, 300);
    EXPECT_GT(plain, 300);
}

/// With a blank before each line, which means the same but is not the form that is read many lines at once.
std::string indented(const std::string& text) {
    std::string result;
    bool at_start = !text.starts_with("\xef\xbb\xbf");
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (at_start) result += ' ';
        result += text[i];
        at_start = text[i] == '\n' || (text[i] == '\r' && text.substr(i + 1, 1) != "\n");
    }
    return result;
}

TEST(ObjPieces, ManyPlainLinesAtOnceAreReadAsOneByOne) {
    Random random(52);
    int errors = 0;
    for (int round = 0; round < 3000; ++round) {
        const std::string text = Writer(random).write(random.integer(1, 300));
        ObjOptions options;
        options.strict = random.integer(0, 4) == 0;
        if (random.integer(0, 9) == 0) options.max_triangles = std::size_t(random.integer(1, 100));
        if (random.integer(0, 9) == 0) options.max_line_bytes = std::size_t(random.integer(25, 90));
        const Read read_whole = read(text, options, nullptr, SIZE_MAX / 32);
        ASSERT_EQ(difference(read_whole, read(indented(text), options, nullptr, SIZE_MAX / 32)), "") << text;
        errors += !read_whole.error.empty();
    }
    EXPECT_GT(errors, 300);
    EXPECT_LT(errors, 2700);
}

TEST(ObjPieces, MoreThanAHundredKindsOfWarningsAreCountedInOrder) {
    std::string text;
    for (int i = 0; i < 300; ++i) text += "unknown" + std::to_string(i % 150) + "\nv 1 2 3\n";
    const Read whole = read(text, {}, nullptr, SIZE_MAX / 32);
    EXPECT_GT(whole.report.warnings_left_out, 0u);
    for (const std::size_t piece_bytes : {20, 100, 1000, 3000})
        EXPECT_EQ(difference(whole, read(text, {}, nullptr, piece_bytes)), "") << piece_bytes;
}

// Larger than a usual piece: triangles that count back over the borders of pieces, a new part now and then.
std::string large_text() {
    Random random(51);
    std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (int i = 0; text.size() < 9 * usual_piece_bytes; ++i) {
        char line[120];
        std::snprintf(line, sizeof line, "v %.6f %.6f %.6f\nf -1 -%d %d\n", double(random.uniform(-1, 1)),
                      double(random.uniform(-1, 1)), double(i) / 8192, random.integer(2, i + 3),
                      random.integer(1, i + 3));
        text += line;
        if (i % 5000 == 0) text += "g part" + std::to_string(i) + "\n";
    }
    return text;
}

TEST(ObjPieces, OfALargeTextGiveOneModel) {
    const std::string text = large_text();
    const Read whole = read(text, {}, nullptr, SIZE_MAX / 32);
    EXPECT_EQ(whole.error, "");
    EXPECT_EQ(difference(whole, read(text, {}, nullptr, usual_piece_bytes)), "");
}

TEST(ObjPieces, ProgressNeverFalls) {
    const std::string text = large_text();
    ObjOptions options;
    double last = 0;
    int calls = 0;
    options.progress = [&](double done) {
        EXPECT_GE(done, last);
        last = done;
        ++calls;
    };
    for (const std::string& end : {std::string(), std::string("f 1 2 x\n")}) {
        last = 0, calls = 0;
        const testing::Loaded loaded = testing::parse(text + end, options);
        EXPECT_EQ(loaded.ok(), end.empty());
        EXPECT_GE(calls, 1);
    }
}

#if !defined(RASTER_NO_THREADS)
TEST(ObjPieces, TheModelIsTheSameForEveryNumberOfThreads) {
    const std::string text = large_text();
    const testing::Loaded all = testing::parse(text);
    ASSERT_TRUE(all.ok()) << all.error();
    for (const int threads : {1, 2, 5}) {
        tbb::task_arena arena(threads);
        arena.execute([&] {
            const testing::Loaded some = testing::parse(text);
            ASSERT_TRUE(some.ok());
            EXPECT_TRUE(same_bytes(some.model->vertices, all.model->vertices));
            EXPECT_EQ(some.model->indices, all.model->indices);
            EXPECT_EQ(some.model->parts.size(), all.model->parts.size());
        });
    }
}
#endif

}  // namespace
}  // namespace raster::obj

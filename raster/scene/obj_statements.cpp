// obj_statements.cpp: tinyobjloader reads the text, from a stream that checks each statement before handing it over.
//
// tinyobjloader tells statements apart and takes them to pieces. By itself it says nothing of bad numbers and
// indices, does not know the line, and opens whatever a file names; so it gets clean statements only, and while it
// calls back about one, the checked numbers or corners and the line of this statement are at hand.
#include <raster/scene/obj_statements.h>

#include <algorithm>
#include <istream>
#include <span>
#include <streambuf>

#include <tiny_obj_loader.h>

#include <raster/scene/obj_lines.h>
#include <raster/scene/obj_tokens.h>

namespace raster::obj {
namespace {

// Curves, surfaces and display settings: right in an OBJ file, but nothing that is drawn here.
constexpr std::string_view unused_statements[] = {
    "vp",         "cstype",    "deg",   "bmat",  "step", "curv",  "curv2",    "surf",     "parm", "trim",   "hole",
    "scrv",       "sp",        "end",   "con",   "mg",   "bevel", "c_interp", "d_interp", "lod",  "maplib", "usemap",
    "shadow_obj", "trace_obj", "ctech", "stech", "call", "csh",   "bzp",      "bsp",      "cdc",  "cdp",    "res"};

// Stand where numbers and corners stood, which are read already, see parse_number. Of a face without any tinyobjloader
// does not call back.
constexpr std::string_view no_numbers = " \n", a_corner = " 1\n";

std::string join(std::string_view a, std::string_view b) { return std::string(a) + std::string(b); }

class Parser final : public std::streambuf, public tinyobj::MaterialReader {
public:
    Parser(const Piece& piece, const ObjOptions& options, MaterialFiles* material_files, Collector& collect, Log& log)
        : lines_(piece.text, options.max_line_bytes, piece.lines_before),
          max_line_bytes_(options.max_line_bytes),
          progress_step_(piece.text.size() / 64),
          progress_(piece.progress),
          material_files_(material_files),
          log_(log),
          collect_(collect) {}

    PieceRead run() {
        tinyobj::callback_t callbacks;
        callbacks.vertex_cb = [](void* p, float, float, float, float) {
            if (const Numbers* n = self(p).next_numbers()) self(p).collect_.position(*n);
        };
        callbacks.texcoord_cb = [](void* p, float, float, float) {
            if (const Numbers* n = self(p).next_numbers()) self(p).collect_.uv(*n);
        };
        callbacks.normal_cb = [](void* p, float, float, float) {
            if (const Numbers* n = self(p).next_numbers()) self(p).collect_.normal(*n);
        };
        callbacks.index_cb = [](void* p, tinyobj::index_t*, int) { self(p).face(); };
        callbacks.usemtl_cb = [](void* p, const char* name, int) { self(p).collect_.material(name); };
        callbacks.group_cb = [](void* p, const char** names, int count) { self(p).group(names, count); };
        callbacks.object_cb = [](void* p, const char* name) { self(p).collect_.name(name); };

        std::istream stream(this);
        stream.exceptions(std::ios::badbit);  // or the end of memory would look like the end of the file
        std::string warnings, errors;         // all of them are reported here, with their lines
        tinyobj::LoadObjWithCallback(stream, callbacks, this, this, &warnings, &errors);
        read_.lines = lines_.lines_taken();
        read_.line_too_long = lines_.is_too_long() ? lines_.line() : 0;
        read_.first_line_with_zeros = lines_.first_line_with_zeros();
        return std::move(read_);
    }

private:
    static Parser& self(void* p) { return *static_cast<Parser*>(p); }
    const Place& here() const { return collect_.here(); }

    // ------------------------------------------------------------------------ the stream that is handed over

    int_type underflow() override {
        while (!log_.failed()) {
            tell_progress();
            called_back_ = 0;
            numbers_.clear(), corners_.clear(), corner_ends_.clear();
            first_line_ = lines_.lines_taken() + 1;
            std::string_view statements = take_plain_lines();
            if (statements.empty()) {
                if (!lines_.next()) break;
                first_line_ = lines_.line();
                collect_.set_line(first_line_);
                if (!prepare(lines_.text())) continue;
                statements = statement_ += '\n';
            }
            char* const start = const_cast<char*>(statements.data());  // only read
            setg(start, start, start + statements.size());
            return traits_type::to_int_type(*start);
        }
        return traits_type::eof();
    }

    /// What tinyobjloader shall see of the next lines, if they are numbers or corners in the plain form that most lines
    /// have; as many of one kind as follow each other. Empty if the next line is another.
    std::string_view take_plain_lines() {
        const std::string_view rest = lines_.rest();
        if (rest.empty() || (rest.front() != 'v' && rest.front() != 'f')) return {};
        const char kind = rest.front();
        const char *line = rest.data(), *const end = line + rest.size();
        statement_.clear();
        std::size_t lines = 0;
        for (constexpr std::size_t most = 128; lines < most; ++lines) {
            const std::ptrdiff_t key = kind == 'v' && end - line > 2 && (line[1] == 't' || line[1] == 'n') ? 2 : 1;
            if (end - line <= key || *line != kind || !is_blank(line[key])) break;
            const char* const stop = std::size_t(end - line) > max_line_bytes_ ? line + max_line_bytes_ + 1 : end;
            const char* at = std::min(line + key, stop);
            while (at != stop && is_blank(*at)) ++at;
            Numbers numbers;
            at = kind == 'f' ? read_plain_corners(at, stop, corners_) : read_plain_numbers(at, stop, numbers);
            if (!at) break;
            if (stop - at > 1 && *at == '\r') ++at;
            if (at == stop || *at != '\n') break;
            if (kind == 'v') {
                numbers_.push_back(numbers);
            } else {
                corner_ends_.push_back(corners_.size());
            }
            statement_.append(line, std::size_t(key)).append(kind == 'v' ? no_numbers : a_corner);
            line = at + 1;
        }
        corners_.resize(corner_ends_.empty() ? 0 : corner_ends_.back());  // without those of a line that is left
        lines_.skip(std::size_t(line - rest.data()), lines);
        return statement_;
    }

    /// Makes statement_ what tinyobjloader shall see. False if it need not see it.
    bool prepare(std::string_view text) {
        const std::string_view key = next_word(text);
        if (key == "v" || key == "vt" || key == "vn") {
            numbers_.push_back(parse_numbers(without_comment(text)));
            statement_ = join(key, " ");
        } else if (key == "f") {
            prepare_face(without_comment(text));
        } else if (key == "usemtl" || key == "o") {
            statement_ = join(key, " ").append(text);
        } else if (key == "g") {
            statement_ = join("g ", text.empty() ? "default" : text);
        } else if (key == "mtllib") {
            // The names are taken from the line itself: tinyobjloader splits them at blanks, eats backslashes, and
            // asks only until it has found one.
            mtllib_names_ = text;
            statement_ = "mtllib names";
        } else {
            handle(key, text);
            return false;
        }
        return !log_.failed();
    }

    /// Statements that tinyobjloader does not call back about.
    void handle(std::string_view key, std::string_view text) {
        if (key == "s") {
            collect_.smoothing(without_comment(text));
        } else if (key == "l") {
            ++log_.report().lines;
        } else if (key == "p") {
            ++log_.report().points;
        } else if (std::find(std::begin(unused_statements), std::end(unused_statements), key) !=
                   std::end(unused_statements)) {
            log_.note(here(), join(key, " is not drawn here"));
        } else {
            log_.warn(here(), "unknown statement " + in_quotes(key));
        }
    }

    /// A position that cannot be is the end; anything else counts as missing.
    void prepare_face(std::string_view text) {
        for (std::string_view word = next_word(text); !word.empty(); word = next_word(text)) {
            const CornerWord corner = parse_corner(word);
            const auto bad = CornerWord::Index::bad;
            if (!corner.well_formed)
                return log_.fail(here(), in_quotes(word) + " is not a corner such as 7, 7/2, 7//3 or 7/2/3");
            if (corner.state[0] == bad)
                return log_.fail(here(),
                                 in_quotes(corner.part[0]) + " is not the number of a vertex; they count from 1");
            if (corner.state[1] == bad) report_bad_uv_index(here(), log_);
            if (corner.state[2] == bad) report_bad_normal_index(here(), log_);
            corners_.push_back({corner.index[0], corner.index[1], corner.index[2]});
        }
        corner_ends_.push_back(corners_.size());
        statement_ = "f 1";
    }

    // ------------------------------------------------------------------------------ what tinyobjloader found

    /// Goes to the statement that is called back about. False after an error.
    bool go_on() {
        collect_.set_line(first_line_ + called_back_++);
        return !log_.failed();
    }

    const Numbers* next_numbers() { return go_on() ? &numbers_[called_back_ - 1] : nullptr; }

    void face() {
        if (!go_on()) return;
        const std::size_t first = called_back_ > 1 ? corner_ends_[called_back_ - 2] : 0;
        collect_.face(std::span(corners_).subspan(first, corner_ends_[called_back_ - 1] - first));
    }

    void group(const char* const* names, int count) {
        std::string all;
        for (int i = 0; i < count; ++i) all.append(i == 0 ? "" : " ").append(names[i]);
        collect_.name(all);
    }

    /// tinyobjloader asks for a material file. Its own materials and messages are not used.
    bool operator()(const std::string&, std::vector<tinyobj::material_t>*, std::map<std::string, int>*, std::string*,
                    std::string*) override {
        if (material_files_) {
            material_files_->read(mtllib_names_, here(), collect_.data().material_library, log_);
        } else {
            read_.mtllibs.push_back({std::string(mtllib_names_), here().line});
        }
        return false;
    }

    void tell_progress() {
        if (!progress_ || lines_.position() < next_progress_) return;
        progress_(lines_.position());
        next_progress_ = lines_.position() + progress_step_;
    }

    LineReader lines_;
    const std::size_t max_line_bytes_;
    const std::size_t progress_step_;
    const std::function<void(std::size_t)>& progress_;
    MaterialFiles* const material_files_;
    Log& log_;
    Collector& collect_;
    PieceRead read_;

    // What tinyobjloader reads at present: one statement, or some of one kind in lines that follow each other.
    std::string statement_;         ///< what stands for their text
    std::vector<Numbers> numbers_;  ///< theirs
    std::vector<Corner> corners_;   ///< theirs, one face after the other
    std::vector<std::size_t> corner_ends_;  ///< a face
    std::size_t first_line_ = 0;    ///< of the first
    std::size_t called_back_ = 0;   ///< about how many of them
    std::string_view mtllib_names_;
    std::size_t next_progress_ = 0;
};

}  // namespace

PieceRead read_statements(const Piece& piece, const ObjOptions& options, MaterialFiles* material_files,
                          Collector& collect, Log& log) {
    return Parser(piece, options, material_files, collect, log).run();
}

}  // namespace raster::obj

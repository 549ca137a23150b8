// obj_parse.cpp: a text in pieces, read on all threads and put together in order.
//
// A piece does not know what comes before it: how many vertices there are, which material is in force, how many
// warnings were given. Where all is well, which is nearly always, that can be added when the piece is put behind the
// others. Where it is not, an error or a limit passed, what was read ahead is thrown away, and the piece is read again
// behind what came before, as if there were no pieces at all.
#include <raster/scene/obj_parse.h>

#include <algorithm>
#include <exception>
#include <memory>

#include <raster/scene/obj_lines.h>
#include <raster/scene/obj_statements.h>
#include <raster/tiles/concurrency.h>

namespace raster::obj {
namespace {

std::vector<std::string_view> split(std::string_view bytes, std::size_t piece_bytes) {
    std::vector<std::string_view> pieces;
    for (std::size_t start = 0; start < bytes.size();) {
        const std::size_t end = next_start(bytes, std::min(bytes.size(), start + piece_bytes));
        pieces.push_back(bytes.substr(start, end - start));
        start = end;
    }
    return pieces;
}

/// A piece that is read without knowing what comes before.
struct Ahead {
    Ahead(std::string_view file, const ObjOptions& options)
        : log(report, options.strict), collect(file, options, log, Start::in_between) {}

    LoadReport report;
    Log log;
    Collector collect;
    PieceRead read;
};

/// Null if it has to be read in order.
std::unique_ptr<Ahead> read_ahead(std::string_view text, std::string_view file, const ObjOptions& options) {
    try {
        auto ahead = std::make_unique<Ahead>(file, options);
        ahead->read = read_statements({text}, options, nullptr, ahead->collect, ahead->log);
        const bool is_whole = !ahead->log.failed() && ahead->read.line_too_long == 0;
        // Warnings about material files come between those of the piece, and can be errors.
        const bool in_order =
            ahead->read.mtllibs.empty() || (ahead->report.warnings.empty() && !options.strict);
        return is_whole && in_order ? std::move(ahead) : nullptr;
    } catch (const std::exception&) {  // no memory; there may be enough for one piece at a time
        return nullptr;
    }
}

class Reader {
public:
    Reader(std::string_view bytes, std::string_view file, const Finder* finder, const ObjOptions& options, Log& log)
        : bytes_(bytes),
          file_(file),
          options_(options),
          log_(log),
          material_files_(finder, options.max_material_bytes),
          collect_(file, options, log) {}

    ObjData run(std::size_t piece_bytes) {
        const std::vector<std::string_view> pieces = split(bytes_, piece_bytes);
        constexpr std::size_t at_once = 32;  // what is read ahead takes memory
        const std::size_t longest = 16 * piece_bytes;
        for (std::size_t first = 0; first < pieces.size() && !log_.failed(); first += at_once) {
            std::vector<std::unique_ptr<Ahead>> ahead(std::min(at_once, pieces.size() - first));
            tell_progress(pieces[first].data());
            if (pieces.size() > 1 && tiles::has_several_threads())
                tiles::parallel_for(ahead.size(), [&](std::size_t i) {
                    const std::string_view text = pieces[first + i];
                    if (text.size() <= longest) ahead[i] = read_ahead(text, file_, options_);
                });
            for (std::size_t i = 0; i < ahead.size() && !log_.failed(); ++i) {
                if (ahead[i] && log_.can_take_over(ahead[i]->report) && collect_.can_take_over(ahead[i]->collect)) {
                    take_over(*ahead[i]);
                } else {
                    read_in_order(pieces[first + i]);
                }
                ahead[i].reset();
            }
        }
        if (first_line_with_zeros_ > 0) log_.warn({file_, first_line_with_zeros_}, "zero bytes, taken for blanks");
        log_.report().has_vertex_colors = !collect_.data().colors.empty();
        return std::move(collect_.data());
    }

private:
    void read_in_order(std::string_view text) {
        Piece piece{text, lines_};
        if (options_.progress) piece.progress = [&](std::size_t read) { tell_progress(text.data() + read); };
        const PieceRead read = read_statements(piece, options_, &material_files_, collect_, log_);
        if (read.line_too_long > 0)
            log_.fail({file_, read.line_too_long}, "a line of more than " + std::to_string(options_.max_line_bytes) +
                                                       " bytes; is this an OBJ file?");
        if (first_line_with_zeros_ == 0) first_line_with_zeros_ = read.first_line_with_zeros;
        lines_ = read.lines;
    }

    void take_over(Ahead& ahead) {
        log_.take_over(ahead.report, lines_);
        for (const Mtllib& mtllib : ahead.read.mtllibs)
            material_files_.read(mtllib.names, {file_, lines_ + mtllib.line}, collect_.data().material_library, log_);
        collect_.take_over(ahead.collect, lines_);
        if (first_line_with_zeros_ == 0 && ahead.read.first_line_with_zeros > 0)
            first_line_with_zeros_ = lines_ + ahead.read.first_line_with_zeros;
        lines_ += ahead.read.lines;
    }

    void tell_progress(const char* at) const {
        if (options_.progress) options_.progress(0.7 * double(at - bytes_.data()) / double(bytes_.size()));
    }

    const std::string_view bytes_, file_;
    const ObjOptions& options_;
    Log& log_;
    MaterialFiles material_files_;
    Collector collect_;
    std::size_t lines_ = 0, first_line_with_zeros_ = 0;
};

}  // namespace

ObjData parse_statements(std::string_view bytes, std::string_view file, const Finder* finder, const ObjOptions& options,
                         Log& log, std::size_t piece_bytes) {
    return Reader(bytes, file, finder, options, log).run(piece_bytes);
}

}  // namespace raster::obj

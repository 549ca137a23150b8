// flags.h: flags on top of CLI11: values are read at once and strictly, and --help says what is allowed.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "parse.h"

namespace raster::tool {

/// A value that `parse` below refuses, with its error: one of a file that a value names is not the command line's.
class FlagError : public CLI::ValidationError {
public:
    FlagError(const std::string& flag, raster::Error error)
        : CLI::ValidationError(flag, error.message), error_(std::move(error)) {}
    const raster::Error& error() const { return error_; }

private:
    raster::Error error_;
};

/// A flag with one value. `names` is CLI11's: "-o,--output". `type` stands for the value in --help. `parse` takes
/// the text and gives a Result; what it gives goes into `into`. Given twice, the last one counts.
template <class T, class Parse>
CLI::Option* add_value(CLI::App& app, const std::string& names, const std::string& type, T& into, const Parse& parse,
                       const std::string& description) {
    const std::string name = names.substr(names.rfind(',') + 1);
    const auto read = [&into, parse, name](const std::string& text) {
        auto value = parse(std::string_view(text));
        if (!value) throw FlagError(name, value.error());
        into = std::move(*value);
    };
    return app.add_option_function<std::string>(names, read, description)->option_text(type)->take_last();
}

/// A flag with one value that may be given again and again; values are added to `into`.
template <class T, class Parse>
CLI::Option* add_values(CLI::App& app, const std::string& name, const std::string& type, std::vector<T>& into,
                        const Parse& parse, const std::string& description) {
    const auto read = [&into, parse, name](const std::vector<std::string>& texts) {
        for (const std::string& text : texts) {
            auto value = parse(std::string_view(text));
            if (!value) throw FlagError(name, value.error());
            into.push_back(std::move(*value));
        }
    };
    return app.add_option_function<std::vector<std::string>>(name, read, description)
        ->option_text(type)
        ->allow_extra_args(false);
}

/// Words that a flag takes, and what they mean.
template <class T, std::size_t N>
using Choices = std::array<std::pair<std::string_view, T>, N>;

/// One of the words. `later` are words that will be understood in a later version.
template <class T, std::size_t N>
Result<T> parse_choice(std::string_view text, const Choices<T, N>& choices,
                       const std::vector<std::string>& later = {}) {
    std::string known;
    std::vector<std::string> words;
    for (const auto& [word, value] : choices) {
        if (word == text) return value;
        known += (known.empty() ? "" : ", ") + std::string(word);
        words.emplace_back(word);
    }
    for (const std::string& word : later)
        if (word == text)
            return Error{ErrorKind::usage, in_quotes(text) + " is not yet possible; what works: " + known};
    return Error{ErrorKind::usage, in_quotes(text) + " is none of " + known + did_you_mean(text, words)};
}

template <class T, class U, std::size_t N>
CLI::Option* add_choice(CLI::App& app, const std::string& name, T& into, const Choices<U, N>& choices,
                        const std::string& description, const std::vector<std::string>& later = {}) {
    std::string type;
    for (const auto& choice : choices) type += (type.empty() ? "" : "|") + std::string(choice.first);
    return add_value(
        app, name, type, into, [choices, later](std::string_view text) { return parse_choice(text, choices, later); },
        description);
}

/// A flag without a value.
inline CLI::Option* add_switch(CLI::App& app, const std::string& name, bool& into, const std::string& description) {
    return app.add_flag(name, into, description);
}

/// What the command line gives where no parsing is needed: file names.
inline Result<std::string> parse_path(std::string_view text) {
    if (text.empty()) return Error{ErrorKind::usage, "'' is no file name"};
    return std::string(text);
}

/// --help: groups of flags, descriptions wrapped at 80 columns.
class HelpFormatter : public CLI::Formatter {
public:
    std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;

private:
    std::string make_option(const CLI::Option* option, bool is_positional) const override;
};

/// An entry of two columns: what is `left` of column 27, or above, and the description, wrapped.
std::string two_columns(const std::string& left, const std::string& description);

/// Text broken at spaces into lines of at most `width` columns, each after `indent` spaces.
std::string wrapped(const std::string& text, std::size_t indent, std::size_t width = 80);

/// All long names of an app's flags, with their dashes.
std::vector<std::string> flag_names(const CLI::App& app);

}  // namespace raster::tool

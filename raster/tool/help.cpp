// help.cpp: how --help looks: summary, usage, flags by group, and what else there is to know.
#include <algorithm>

#include "flags.h"

namespace raster::tool {
namespace {

constexpr std::size_t description_column = 27;
constexpr const char* other_flags = "Other flags";

}  // namespace

std::string wrapped(const std::string& text, std::size_t indent, std::size_t width) {
    std::string out;
    for (const std::string_view paragraph : split(text, '\n')) {
        std::size_t column = 0;
        for (const std::string_view word : split(paragraph, ' ')) {
            if (word.empty()) continue;
            if (column > 0 && column + 1 + word.size() > width) {
                out += '\n';
                column = 0;
            }
            if (column == 0) {
                out.append(indent, ' ');
                column = indent;
            } else {
                out += ' ';
                ++column;
            }
            out += word;
            column += word.size();
        }
        out += '\n';
    }
    return out;
}

std::string two_columns(const std::string& left, const std::string& description) {
    const std::string right = wrapped(description, description_column);
    std::string out = "  " + left;
    if (out.size() + 2 > description_column) return out + "\n" + right;
    out.resize(description_column, ' ');
    return out + right.substr(description_column);
}

std::string HelpFormatter::make_option(const CLI::Option* option, bool is_positional) const {
    std::string left = make_option_name(option, is_positional);
    if (const std::size_t value = left.find("{false}"); value != std::string::npos) left.erase(value);
    for (std::size_t comma = left.find(','); comma != std::string::npos; comma = left.find(',', comma + 2))
        left.insert(comma + 1, 1, ' ');
    if (!is_positional && !option->get_option_text().empty()) left += " " + option->get_option_text();
    return two_columns(left, make_option_desc(option));
}

std::string HelpFormatter::make_help(const CLI::App* app, std::string, CLI::AppFormatMode) const {
    const bool is_top = app->get_parent() == nullptr;
    std::string out = wrapped(app->get_description(), 0) + "\nUsage: raster ";
    out += is_top ? "COMMAND" : app->get_name();
    const auto arguments = app->get_options([](const CLI::Option* o) { return o->get_positional(); });
    for (const CLI::Option* argument : arguments) out += " " + argument->get_name(true, false);
    out += " [FLAGS]\n";
    if (is_top) {
        out += "\nCommands:\n";
        for (const CLI::App* command : app->get_subcommands({}))
            out += two_columns(command->get_name(), command->get_description());
    }
    if (!arguments.empty()) out += make_group("Arguments", true, arguments);
    std::vector<std::string> groups = app->get_groups();
    // --help is added first, but is not what one looks for.
    std::stable_partition(groups.begin(), groups.end(), [](const std::string& group) { return group != other_flags; });
    for (const std::string& group : groups) {
        const auto options =
            app->get_options([&](const CLI::Option* o) { return o->get_group() == group && o->nonpositional(); });
        if (!group.empty() && !options.empty()) out += make_group(group, false, options);
    }
    if (!app->get_footer().empty()) out += "\n" + app->get_footer() + "\n";
    return out;
}

std::vector<std::string> flag_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options())
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    return names;
}

}  // namespace raster::tool

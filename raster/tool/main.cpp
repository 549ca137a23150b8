// main.cpp: the `raster` command: finds the command that is asked for, runs it, turns its result into an exit code.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <exception>
#include <new>
#include <string_view>

#include "commands.h"
#include "flags.h"
#include "process.h"
#include "report.h"

namespace raster::tool {
namespace {

/// The names of the commands.
std::vector<std::string> command_names() {
    std::vector<std::string> names;
    for (const Command& command : commands) names.emplace_back(command.name);
    return names;
}

/// What CLI11 found wrong, in our words: the flag that is not known comes before what it leaves missing.
Error describe(const CLI::App& app, const CLI::App* command, const CLI::ParseError& error) {
    const CLI::App& where = command ? *command : app;
    const std::string see = "\n  `raster " + (command ? command->get_name() + " " : "") + "--help` lists what there is";
    const std::vector<std::string> unknown = where.remaining();
    for (const std::string& word : unknown) {
        if (word.size() < 2 || word[0] != '-') continue;
        const std::string flag = word.substr(0, word.find('='));
        return {ErrorKind::usage, "unknown flag " + in_quotes(flag) + did_you_mean(flag, flag_names(where)) + see};
    }
    if (!command && !unknown.empty()) {
        const std::string& word = unknown.front();
        const bool is_file = word.ends_with(".obj") || word.ends_with(".OBJ");
        const std::string hint =
            is_file ? "; did you mean raster render " + word + "?" : did_you_mean(word, command_names());
        return {ErrorKind::usage, "unknown command " + in_quotes(word) + hint + see};
    }
    if (dynamic_cast<const CLI::ExtrasError*>(&error) && !unknown.empty())
        return {ErrorKind::usage, in_quotes(unknown.front()) + " is one argument too many" + see};
    if (const auto* refused = dynamic_cast<const FlagError*>(&error); refused)
        if (refused->error().kind != ErrorKind::usage) return refused->error();
    std::string message = error.what();
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error)) message += "; a value is missing";
    return {ErrorKind::usage, message};
}

int run(int argc, char** argv) {
    CLI::App app(
        "Pictures of 3D models without a GPU, a display or a driver: a software rasterizer to learn from,"
        " test with and trust.",
        "raster");
    app.formatter(std::make_shared<HelpFormatter>());
    app.set_help_flag("-h,--help", "Print this help.");
    app.set_version_flag("--version", "raster " RASTER_VERSION, "Print the version.");
    app.get_option("--help")->group("Flags");
    app.get_option("--version")->group("Flags");
    app.footer(
        "`raster COMMAND --help` lists a command's flags.\n"
        "Exit codes: 0 done, 1 bad input, 2 wrong usage, 3 a file cannot be read or\n"
        "written, or memory ran out.");
    app.require_subcommand(0, 1);

    std::array<Run, std::size(commands)> runs;
    for (std::size_t i = 0; i < std::size(commands); ++i) {
        CLI::App* command = app.add_subcommand(commands[i].name, commands[i].summary);
        command->get_option("--help")->group("Other flags");
        command->footer("");
        // A command that no argument names needs no flags; to describe them all takes longer than a small picture.
        if (std::find(argv, argv + argc, std::string_view(commands[i].name)) != argv + argc)
            runs[i] = commands[i].add(*command);
    }

    const auto chosen = [&]() -> const CLI::App* {
        const auto parsed = app.get_subcommands();
        return parsed.empty() ? nullptr : parsed.front();
    };
    // `raster help diff` is `raster diff --help`.
    std::vector<char*> arguments(argv, argv + argc);
    static char help_flag[] = "--help";
    if (argc > 1 && std::string_view(argv[1]) == "help") {
        arguments.erase(arguments.begin() + 1);
        arguments.push_back(help_flag);
    }
    try {
        app.parse(int(arguments.size()), arguments.data());
    } catch (const CLI::CallForVersion&) {
        const Status printed = print("raster " RASTER_VERSION "\n");
        return printed ? exit_done : fail(printed.error());
    } catch (const CLI::ParseError& error) {
        const CLI::App* command = chosen();
        const CLI::App& where = command ? *command : app;
        if (where.get_help_ptr()->count() == 0) return fail(describe(app, command, error));
        const Status printed = print(where.help());
        return printed ? exit_done : fail(printed.error());
    }
    const CLI::App* command = chosen();
    if (!command) {
        std::string help = app.help();
        help.pop_back();
        say(help);
        return exit_usage;
    }
    for (std::size_t i = 0; i < std::size(commands); ++i) {
        if (command->get_name() != commands[i].name) continue;
        const Result<int> result = runs[i]();
        return result ? *result : fail(result.error());
    }
    return exit_usage;
}

}  // namespace
}  // namespace raster::tool

int main(int argc, char** argv) {
    using namespace raster::tool;
    try {
        prepare_process();
        return run(argc, argv);
    } catch (const std::bad_alloc&) {
        constexpr std::string_view message = "error: not enough memory\n";
        (void)!::write(STDERR_FILENO, message.data(), message.size());
    } catch (const std::exception& error) {
        fail({raster::ErrorKind::input_output, error.what()});
    }
    return exit_input_output;
}

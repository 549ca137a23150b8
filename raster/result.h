// result.h: errors as values: a Result holds what was asked for, or the Error that says why not.
#pragma once

#include <string>
#include <utility>
#include <variant>

namespace raster {

/// Why an operation failed. The kind maps one to one to the exit code of the command line tool.
enum class ErrorKind {
    bad_input,     ///< a file was read but its content is wrong (exit code 1)
    usage,         ///< an argument is out of its documented range (exit code 2)
    input_output,  ///< the operating system refused to open, read or write (exit code 3)
};

/// A failure in words. `message` names the file and, where there is one, the line: "bunny.obj:12: index 0".
struct Error {
    ErrorKind kind = ErrorKind::bad_input;
    std::string message;
};

/// A value of type T or an Error. Test it like a pointer, read it like a pointer.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

    explicit operator bool() const { return state_.index() == 0; }
    T& operator*() { return *std::get_if<0>(&state_); }
    const T& operator*() const { return *std::get_if<0>(&state_); }
    T* operator->() { return std::get_if<0>(&state_); }
    const T* operator->() const { return std::get_if<0>(&state_); }
    /// The error; only to be called when the Result is false.
    const Error& error() const { return *std::get_if<1>(&state_); }

private:
    std::variant<T, Error> state_;
};

/// The Result of an operation that gives nothing back.
struct Done {};
using Status = Result<Done>;

}  // namespace raster

// What goes to the user's terminal: asked-for text, what a command tells at its end, errors.
#pragma once

#include <string>
#include <string_view>

namespace CLI {
class App;
}

namespace pedzone {

/// Adds --quiet. It holds for the process, like its terminal: progress and print_result() are
/// left out, wherever they are.
void add_quiet_flag(CLI::App& command);
bool is_quiet();

/// Ends the process without a word where nobody reads what it prints (`| head`), also under a
/// parent that has told its children to ignore that.
void end_when_nobody_reads();

/// Prints what was asked for (help, tables, JSON), after the work. Who reads may stop before its
/// end: that is no error then. Throws std::system_error, e.g. on a full disk.
void print_text(std::string_view text);
/// The same for what a command tells of what it did; nothing with --quiet.
void print_result(std::string_view text);

/// "Error: TEXT" on standard error; in colour on a terminal, unless NO_COLOR is set.
void print_error(std::string_view text);
/// "Warning: TEXT", the same way.
void print_warning(std::string_view text);
/// "Warning:" as it is to be shown there.
std::string warning_label();

}  // namespace pedzone

// What the terminal can show.
#pragma once

namespace cls::cli {

/// True when stderr is a terminal that understands cursor movement.
bool stderr_is_terminal();

/// True when stdout is a terminal and colour is welcome (NO_COLOR, TERM=dumb and `--no-color`
/// refuse it).
bool stdout_takes_colour(bool no_colour_option);

/// Columns of the terminal on stderr; 80 when unknown.
int terminal_width();

}  // namespace cls::cli

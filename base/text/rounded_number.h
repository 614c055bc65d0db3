// Numbers as the text of the soccer protocol carries them.
#pragma once

namespace cls::base {

/// The value of the text that append_g() makes of `value`, which must be finite. Does not make the
/// text of usual numbers. Defined in number_text.cpp, with the digits of that text.
double rounded_to_text(double value);

}  // namespace cls::base

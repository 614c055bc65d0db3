// Reports as HTML.
#pragma once

#include <string>

#include "tournament/report/report_model.h"

namespace cls::tournament {

/// A self-contained page without scripts, light or dark as the reader's browser prefers, that
/// prints well.
std::string report_html(const Report& report);

}  // namespace cls::tournament

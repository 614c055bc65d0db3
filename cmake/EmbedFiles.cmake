# Run by cls_embed(): writes OUTPUT with the text of FILES (separated by |) as raw strings.
string(REPLACE "|" ";" files "${FILES}")
set(entries "")
foreach(file IN LISTS files)
  get_filename_component(name "${file}" NAME)
  file(READ "${file}" text)
  string(APPEND entries "      {\"${name}\", R\"embedded(${text})embedded\"},\n")
endforeach()
file(WRITE "${OUTPUT}" "// Generated from examples/scenarios.
#include \"orchestration/scenario/scenario_library.h\"

namespace cls::orchestration::scenario {

const std::vector<ShippedFile>& shipped_files() {
  static const std::vector<ShippedFile> files = {
${entries}  };
  return files;
}

}  // namespace cls::orchestration::scenario
")

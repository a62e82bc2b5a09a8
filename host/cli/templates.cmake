# Puts the plugin templates of sdk/template into the program, so that `riffle new` needs no files beside it.
set(template_directory "${PROJECT_SOURCE_DIR}/sdk/template")
file(GLOB template_files CONFIGURE_DEPENDS "${template_directory}/*.*")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${template_files})
set(template_source "#include \"host/cli/new_plugin.hpp\"\n\nnamespace riffle {\n
const std::map<std::string, std::string>& plugin_templates() {\n  static const std::map<std::string, std::string> templates{\n")
foreach(file ${template_files})
  get_filename_component(name "${file}" NAME)
  file(READ "${file}" text)
  string(APPEND template_source "      {\"${name}\", R\"template(${text})template\"},\n")
endforeach()
string(APPEND template_source "  };\n  return templates;\n}\n\n}  // namespace riffle\n")
file(GENERATE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/templates.cpp" CONTENT "${template_source}")

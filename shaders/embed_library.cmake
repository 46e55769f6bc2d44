# cmake -D FOLDER=… -D OUTPUT=… -P embed_library.cmake
# Writes the files below FOLDER/relievo as a C++ source: the embedded shader library.
file(GLOB_RECURSE paths RELATIVE "${FOLDER}" "${FOLDER}/relievo/*")
list(SORT paths COMPARE STRING)
set(entries "")
foreach(path IN LISTS paths)
  file(READ "${FOLDER}/${path}" text)
  string(APPEND entries "    {\"${path}\", R\"glsl(${text})glsl\"},\n")
endforeach()
file(WRITE "${OUTPUT}" "// Generated from shaders/relievo by embed_library.cmake.
#include \"shaders/shader_library.h\"

namespace relievo::shaders {
namespace {

constexpr LibraryFile kFiles[] = {
${entries}};

}  // namespace

std::span<const LibraryFile> libraryFiles() { return kFiles; }

}  // namespace relievo::shaders
")

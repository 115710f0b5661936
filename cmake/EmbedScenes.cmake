# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0

# cmake -D SCENES=folder -D OUTPUT=file.cpp -P EmbedScenes.cmake: the texts of SCENES/*.toml and SCENES/robots/*.toml as
# the tables behind echoarc::io::builtin_scenes() and builtin_robots().

function(embed_texts function pattern)
  file(GLOB files ${pattern})
  list(SORT files)
  list(LENGTH files count)
  set(entries "")
  foreach(file IN LISTS files)
    get_filename_component(name "${file}" NAME_WE)
    file(READ "${file}" text)
    string(APPEND entries "    {\"${name}\", R\"__toml__(${text})__toml__\"},\n")
  endforeach()
  set(code "${code}std::span<const BuiltinText> ${function}() {\n  static constexpr std::array<BuiltinText, ${count}> texts{{\n${entries}  }};\n  return texts;\n}\n\n" PARENT_SCOPE)
endfunction()

set(code "// Made by cmake/EmbedScenes.cmake.\n#include <array>\n\n#include \"echoarc/io/builtin.hpp\"\n\nnamespace echoarc::io {\n\n")
embed_texts(builtin_scenes "${SCENES}/*.toml")
embed_texts(builtin_robots "${SCENES}/robots/*.toml")
file(WRITE "${OUTPUT}" "${code}}  // namespace echoarc::io\n")

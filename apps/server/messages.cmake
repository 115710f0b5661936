# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0

# What clients say, read: alone, because it is fuzzed in trees that build no programs and have no Boost.
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
if(NOT TARGET echoarc_messages)
  add_library(echoarc_messages STATIC ${CMAKE_CURRENT_LIST_DIR}/client_message.cpp ${CMAKE_CURRENT_LIST_DIR}/message_fields.cpp)
  target_include_directories(echoarc_messages PUBLIC ${PROJECT_SOURCE_DIR}/apps)
  target_link_libraries(echoarc_messages PUBLIC echoarc::core nlohmann_json::nlohmann_json PRIVATE echoarc_build_flags fmt::fmt)
endif()

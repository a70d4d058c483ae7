# What the page's WebAssembly build (preset `wasm`) takes from the system: headers only. Debian's headers lie beside
# those of its C library, which must not be seen here, so links to just these are put into a folder of their own.
set(CAROM_WASM_HEADERS ${CMAKE_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${CAROM_WASM_HEADERS})
foreach(name fmt hwy nlohmann toml++ fast_float boost Random123 xxhash.h)
  find_path(CAROM_WASM_HOME_OF_${name} ${name} PATHS /usr/include /usr/local/include REQUIRED
            NO_CMAKE_FIND_ROOT_PATH NO_DEFAULT_PATH)
  if(NOT EXISTS ${CAROM_WASM_HEADERS}/${name})
    file(CREATE_LINK ${CAROM_WASM_HOME_OF_${name}}/${name} ${CAROM_WASM_HEADERS}/${name} SYMBOLIC)
  endif()
endforeach()

foreach(library XXHASH RANDOM123 TOMLPP FAST_FLOAT BOOST)
  set(CAROM_${library}_INCLUDE ${CAROM_WASM_HEADERS})
endforeach()
foreach(target fmt::fmt hwy::hwy nlohmann_json::nlohmann_json Threads::Threads)
  add_library(${target} INTERFACE IMPORTED)
  target_include_directories(${target} SYSTEM INTERFACE ${CAROM_WASM_HEADERS})
endforeach()
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)
# Exceptions of WebAssembly itself: those by way of JavaScript would slow every call that can throw.
add_compile_options(-fwasm-exceptions -msimd128 -include ${PROJECT_SOURCE_DIR}/web/engine/missing.hpp)
add_link_options(-fwasm-exceptions)

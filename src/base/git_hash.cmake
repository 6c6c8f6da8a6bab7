# Writes ${OUT} with the hash of the commit that ${SOURCE} is at; touches it only when it changed.
execute_process(COMMAND git describe --always --dirty --exclude=*
                WORKING_DIRECTORY "${SOURCE}" OUTPUT_VARIABLE hash
                OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT hash)
  set(hash "unknown")
endif()
file(WRITE "${OUT}.new" "#define HACKLE_GIT_HASH \"${hash}\"\n")
execute_process(COMMAND "${CMAKE_COMMAND}" -E copy_if_different "${OUT}.new" "${OUT}")

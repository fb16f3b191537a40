# INPUT.comp -> OUTPUT: the same text for OpenGL 4.5, its includes resolved, without #version. What Vulkan alone has is
# rewritten: sets, push constants (a uniform block), specialization constants (SPECIALIZED_<id>, defined before the text
# or else the default).
execute_process(COMMAND ${GLSLANG} -E -I${INCLUDES} ${INPUT}
  OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
string(REGEX REPLACE "#(extension|version|line)[^\n]*" "" text "${text}")
string(REPLACE "[[unroll]]" "" text "${text}")
string(REGEX REPLACE "layout *\\( *constant_id *= *([0-9]+) *\\) *const ([a-z]+) ([A-Za-z0-9_]+) *= *([^;]+);"
                     "\n#ifndef SPECIALIZED_\\1\n#define SPECIALIZED_\\1 \\4\n#endif\nconst \\2 \\3 = \\2(SPECIALIZED_\\1);"
                     text "${text}")
string(REGEX REPLACE "layout *\\( *push_constant *\\)" "layout(std140, binding = 0)" text "${text}")
string(REGEX REPLACE "layout *\\( *set *= *0 *, *binding *= *([0-9]+) *\\) *buffer" "layout(std430, binding = \\1) buffer" text "${text}")
string(REGEX REPLACE "layout *\\( *set *= *0 *, *" "layout(" text "${text}")
# A word that OpenGL's GLSL keeps for itself.
string(REGEX REPLACE "([^A-Za-z0-9_])packed([^A-Za-z0-9_])" "\\1packed_\\2" text "${text}")
file(WRITE ${OUTPUT} "${text}")

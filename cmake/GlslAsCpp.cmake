# INPUT.glsl -> OUTPUT: the same text as members of a C++ class template over Real (renderer/reference/shaders.hpp).
# Only what C++ cannot read is rewritten; names of types and built-ins come from the class that includes it.
file(READ ${INPUT} text)
# Every swizzle is an operator, which GLM's vectors can be given from outside: v.xyz -> v->*xyz.
string(REGEX REPLACE "\\.([xyzw][xyzw]+)([^A-Za-z0-9_])" "->*\\1\\2" text "${text}")
# Literals have the precision of the build.
string(REGEX REPLACE "([^A-Za-z0-9_.])([0-9]+\\.[0-9]*([eE][-+]?[0-9]+)?|[0-9]+[eE][-+]?[0-9]+)" "\\1Real(\\2)" text "${text}")
string(REGEX REPLACE "([(,] *)(inout|out) ([A-Za-z0-9_]+) " "\\1\\3& " text "${text}")
string(REGEX REPLACE "layout\\(constant_id *= *([0-9]+)\\) const ([a-z]+) ([A-Za-z0-9_]+) = ([^;]+);"
                     "const \\2 \\3 = specialized(\\1, \\2(\\4));" text "${text}")
# The class declares bindings and push constants itself.
string(REGEX REPLACE "layout\\([^\n]*" "" text "${text}")
string(REGEX REPLACE "#(extension|version)[^\n]*" "" text "${text}")
string(REPLACE "[[unroll]]" "" text "${text}")
string(REGEX REPLACE "(^|[^A-Za-z0-9_])precise " "\\1" text "${text}")
file(WRITE ${OUTPUT} "${text}")

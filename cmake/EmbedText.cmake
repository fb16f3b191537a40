# INPUT -> OUTPUT: a header that holds the text as a raw string literal named VARIABLE.
file(READ ${INPUT} content)
file(WRITE ${OUTPUT} "inline constexpr char ${VARIABLE}[] = R\"__GLSL__(${content})__GLSL__\";\n")

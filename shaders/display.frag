// SPDX-License-Identifier: MIT
// The film in a rectangle of the window; display.glsl stands before this.
layout(location = 0) out vec4 encoded;

void main() {
  vec2 inRect = (gl_FragCoord.xy - vec2(display.rectX, display.rectY)) / vec2(display.rectWidth, display.rectHeight);
  uvec2 pixel = min(uvec2(max(inRect, 0.0) * vec2(display.width, display.height)),
                    uvec2(display.width - 1u, display.height - 1u));
  encoded = vec4(encodedPixel(pixel.y * display.width + pixel.x), 1.0);
}

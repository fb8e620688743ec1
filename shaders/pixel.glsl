uniform vec2 lower_left;  // of what is drawn into, in the picture

// The pixel of the picture, from its lower left.
vec2 picture_pixel() { return gl_FragCoord.xy + lower_left; }

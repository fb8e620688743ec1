// The patterns of tints: a sign other than the colour.
const int diagonal = 1, chessboard = 2, horizontal = 3, bars = 4;

// How much a pixel of the picture belongs to the pattern.
float pattern_share(int pattern, vec2 p) {
  float rising = step(0.5, fract((p.x - p.y) / 10.0));
  float falling = step(0.5, fract((p.x + p.y) / 10.0));
  if (pattern == diagonal) return 0.55 + 0.45 * rising;
  if (pattern == chessboard) return 0.50 + 0.50 * abs(rising - falling);  // on its corner
  if (pattern == horizontal) return 0.50 + 0.50 * step(0.5, fract(p.y / 6.0));
  if (pattern == bars) return step(fract(p.x / 8.0), 0.5);  // the face is seen between them
  return 1.0;
}

// How much of its light it has there, where it lies over the surface: none at the edge of a bar.
float pattern_light(int pattern, vec2 p) { return pattern == bars ? step(fract(p.x / 8.0), 0.3) : 1.0; }

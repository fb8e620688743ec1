#version 330 core
flat in uint slot;
in float depth;
layout(location = 0) out uint number;
layout(location = 1) out float distance;
void main() {
  number = slot + 1u;
  distance = depth;
}

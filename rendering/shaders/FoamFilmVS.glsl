// SPDX-License-Identifier: GPL-3.0-or-later
//VTK::System::Dec
//
// A film is a line of two vertices. What is known of it stands in a buffer: here it only gets its
// number there.
in vec4 vertexMC;
flat out int filmOfVertex;
//VTK::CustomUniforms::Dec
//VTK::TCoord::Dec
//VTK::Color::Dec
//VTK::Picking::Dec

void main() {
  filmOfVertex = gl_VertexID / 2;
  //VTK::Color::Impl
  //VTK::TCoord::Impl
  gl_Position = vertexMC;
  //VTK::Picking::Impl
}

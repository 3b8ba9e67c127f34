// SPDX-License-Identifier: GPL-3.0-or-later
#include "FilmBatchMapper.h"

#include <algorithm>
#include <vector>

#include <vtkBoundingBox.h>
#include <vtkCamera.h>
#include <vtkDataObject.h>
#include <vtkHardwareSelector.h>
#include <vtkMatrix4x4.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLActor.h>
#include <vtkOpenGLBufferObject.h>
#include <vtkOpenGLCamera.h>
#include <vtkOpenGLHelper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkShader.h>
#include <vtkShaderProgram.h>
#include <vtkTexture.h>
#include <vtkTextureObject.h>

#include "FilmBuffer.h"
#include "FilmPlane.h"
#include "FoamFilmArc.h"
#include "FoamFilmFS.h"
#include "FoamFilmGS.h"
#include "FoamFilmVS.h"
#include "vtkFoamFilmMapper.h"

namespace foam::rendering {
namespace {

void substitute(vtkShader* shader, const std::string& from, const std::string& to) {
  std::string source = shader->GetSource();
  vtkShaderProgram::Substitute(source, from, to);
  shader->SetSource(source);
}

} // namespace

vtkStandardNewMacro(FilmBatchMapper);

const vtkFoamFilmMapper& FilmBatchMapper::film_mapper() const {
  return *vtkFoamFilmMapper::SafeDownCast(this->Parent);
}

int FilmBatchMapper::film_style() const {
  const bool has_texture = film_mapper().GetFilmTexture() != nullptr;
  const int style = film_mapper().GetFilmStyle();
  return style == vtkFoamFilmMapper::Texture && !has_texture ? vtkFoamFilmMapper::Plain : style;
}

vtkMTimeType FilmBatchMapper::GetMTime() {
  return std::max(this->Superclass::GetMTime(), this->Parent->GetMTime());
}

void FilmBatchMapper::ReleaseGraphicsResources(vtkWindow* window) {
  if (vtkTexture* picture = film_mapper().GetFilmTexture()) {
    picture->ReleaseGraphicsResources(window);
  }
  texture_->ReleaseGraphicsResources(window);
  buffer_->ReleaseGraphicsResources();
  this->Superclass::ReleaseGraphicsResources(window);
}

void FilmBatchMapper::put_films() {
  for_each_block([](vtkPolyData* polylines, vtkPolyData*& drawn) { drawn = polylines; });
}

void FilmBatchMapper::put_chords() {
  for_each_block([this](vtkPolyData* polylines, vtkPolyData*& drawn) {
    const auto chords = chords_.find(polylines);
    drawn = chords == chords_.end() ? polylines : chords->second.Get();
  });
}

/// VTK compares the age of what it draws: that of the films counts.
bool FilmBatchMapper::GetNeedToRebuildBufferObjects(vtkRenderer* renderer, vtkActor* actor) {
  put_films();
  const bool need = this->Superclass::GetNeedToRebuildBufferObjects(renderer, actor);
  put_chords();
  return need;
}

void FilmBatchMapper::BuildBufferObjects(vtkRenderer* renderer, vtkActor* actor) {
  const std::string problem = build_films(renderer);
  if (!problem.empty() && problem != problem_) {
    vtkWarningWithObjectMacro(this->Parent, "Films are drawn as ordinary lines: " << problem);
  }
  problem_ = problem;
  this->Superclass::BuildBufferObjects(renderer, actor);
}

std::string FilmBatchMapper::build_films(vtkRenderer* renderer) {
  chords_.clear();
  put_films();
  std::vector<vtkPolyData*> blocks;
  vtkBoundingBox bounds;
  for_each_block([&](vtkPolyData* polylines, vtkPolyData*) {
    blocks.push_back(polylines);
    bounds.AddBounds(polylines->GetBounds());
  });
  double middle[3] = {0, 0, 0};
  if (bounds.IsValid()) {
    bounds.GetCenter(middle);
  }
  origin_ = {middle[0], middle[1]};

  std::vector<float> texels;
  for (vtkPolyData* polylines : blocks) {
    const FilmReading reading = read_drawn_films(polylines);
    if (!reading.problem.empty()) {
      return reading.problem;
    }
    if (!texels.empty() && reading.z != z_) {
      return "blocks lie in different planes of z";
    }
    z_ = reading.z;
    append_films(reading.films, origin_, film_mapper().GetBorderRadius(), texels);
  }
  constexpr std::size_t kMostFilms = 1 << 23; // whose ends have numbers that a float can hold
  const std::size_t count = texels.size() / 4;
  const auto per_film = static_cast<std::size_t>(texels_per_film(film_mapper().GetBorderRadius()));
  GLint largest = 0;
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetVTKWindow());
  window->GetState()->vtkglGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &largest);
  const std::size_t most = std::min(kMostFilms, static_cast<std::size_t>(largest) / per_film);
  if (count / per_film > most) {
    return "there are " + std::to_string(count / per_film) + " of them, and OpenGL here can hold " +
           std::to_string(most);
  }
  if (count > 0) {
    buffer_->SetType(vtkOpenGLBufferObject::TextureBuffer);
    buffer_->Upload(texels, vtkOpenGLBufferObject::TextureBuffer);
    texture_->SetContext(window);
    texture_->CreateTextureBuffer(static_cast<unsigned int>(count), 4, VTK_FLOAT, buffer_);
  }
  for (vtkPolyData* polylines : blocks) {
    chords_[polylines] = chords_of(polylines);
  }
  put_chords();
  return {};
}

bool FilmBatchMapper::draws_films(vtkRenderer* renderer) const {
  vtkHardwareSelector* selector = renderer->GetSelector();
  const bool picks_points =
      selector && selector->GetFieldAssociation() == vtkDataObject::FIELD_ASSOCIATION_POINTS;
  return problem_.empty() && !picks_points;
}

bool FilmBatchMapper::draws_texture() const {
  return problem_.empty() && film_style() == vtkFoamFilmMapper::Texture;
}

void FilmBatchMapper::GetShaderTemplate(std::map<vtkShader::Type, vtkShader*> shaders,
                                        vtkRenderer* renderer, vtkActor* actor) {
  this->Superclass::GetShaderTemplate(shaders, renderer, actor);
  if (!draws_films(renderer)) {
    return;
  }
  vtkShader* geometry = shaders[vtkShader::Geometry];
  shaders[vtkShader::Vertex]->SetSource(FoamFilmVS);
  geometry->SetSource(FoamFilmGS);
  substitute(geometry, "//FilmArc::Dec", FoamFilmArc);

  // To VTK's own fragment shader comes how much of the pixel is covered, before anything else is
  // done with it, and then as an opacity.
  vtkShader* fragment = shaders[vtkShader::Fragment];
  substitute(fragment, "//VTK::CustomUniforms::Dec",
             std::string("//VTK::CustomUniforms::Dec\n") + FoamFilmFS);
  substitute(fragment, "//FilmArc::Dec", FoamFilmArc);
  substitute(fragment, "//FilmStyle::Dec", "#define FILM_STYLE " + std::to_string(film_style()));
  const char* least = renderer->GetSelector() ? "0.5" : "1.0 / 512.0";
  substitute(fragment, "//VTK::Clip::Impl",
             std::string("vec4 paint;\n"
                         "  float coverage = filmCoverage(paint);\n"
                         "  if (coverage < ") +
                 least +
                 ") { discard; }\n"
                 "  //VTK::Clip::Impl");
  substitute(fragment, "//VTK::TCoord::Impl",
             "//VTK::TCoord::Impl\n"
             "  gl_FragData[0] *= vec4(paint.rgb, paint.a * coverage);\n");
}

void FilmBatchMapper::ReplaceShaderValues(std::map<vtkShader::Type, vtkShader*> shaders,
                                          vtkRenderer* renderer, vtkActor* actor) {
  this->Superclass::ReplaceShaderValues(shaders, renderer, actor);
  if (draws_films(renderer)) {
    // VTK passes point data on vertex by vertex; along a film they go from one end to the other.
    // From VTK 9.3 on coordinates in a colour map have a name of their own.
    vtkShader* geometry = shaders[vtkShader::Geometry];
    for (const std::string name :
         {"vertexColorVSOutput", "tcoordVCVSOutput", "colorTCoordVCVSOutput"}) {
      substitute(geometry, name + "[i]", "mix(" + name + "[0], " + name + "[1], t)");
    }
  }
}

void FilmBatchMapper::RenderPieceStart(vtkRenderer* renderer, vtkActor* actor) {
  this->Superclass::RenderPieceStart(renderer, actor);
  if (problem_.empty()) {
    texture_->Activate();
  }
  if (draws_texture()) {
    film_mapper().GetFilmTexture()->Render(renderer);
  }
}

void FilmBatchMapper::RenderPieceFinish(vtkRenderer* renderer, vtkActor* actor) {
  if (draws_texture()) {
    film_mapper().GetFilmTexture()->PostRender(renderer);
  }
  if (problem_.empty()) {
    texture_->Deactivate();
  }
  this->Superclass::RenderPieceFinish(renderer, actor);
}

void FilmBatchMapper::SetMapperShaderParameters(vtkOpenGLHelper& cells, vtkRenderer* renderer,
                                                vtkActor* actor) {
  this->Superclass::SetMapperShaderParameters(cells, renderer, actor);
  vtkShaderProgram* program = cells.Program;
  if (!program->IsUniformUsed("films")) {
    return;
  }
  program->SetUniformi("films", texture_->GetTextureUnit());
  if (draws_texture()) {
    program->SetUniformi("filmTexture", film_mapper().GetFilmTexture()->GetTextureUnit());
  }
  program->SetUniformi("filmTexels", texels_per_film(film_mapper().GetBorderRadius()));
  program->SetUniformf("halfWidth", static_cast<float>(0.5 * film_mapper().GetFilmWidth()));

  vtkMatrix4x4 *world_to_view, *view_to_clip, *world_to_clip;
  vtkMatrix3x3* normals;
  auto* camera = vtkOpenGLCamera::SafeDownCast(renderer->GetActiveCamera());
  camera->GetKeyMatrices(renderer, world_to_view, normals, view_to_clip, world_to_clip);
  vtkNew<vtkMatrix4x4> model_to_clip; // the camera keeps its matrices transposed
  vtkMatrix4x4::Transpose(world_to_clip, model_to_clip);
  if (!actor->GetIsIdentity()) {
    vtkMatrix4x4::Multiply4x4(model_to_clip, actor->GetMatrix(), model_to_clip);
  }
  int viewport[4];
  vtkOpenGLRenderWindow::SafeDownCast(renderer->GetVTKWindow())
      ->GetState()
      ->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  FilmPlane plane = film_plane(model_to_clip->GetData(), origin_, z_, viewport);
  program->SetUniformMatrix4x4("planeToClip", plane.plane_to_clip.data());
  program->SetUniformMatrix3x3("pixelToPlane", plane.pixel_to_plane.data());
  program->SetUniform2f("viewOrigin", plane.view_origin.data());
  program->SetUniform2f("viewportSize", plane.viewport_size.data());
}

} // namespace foam::rendering

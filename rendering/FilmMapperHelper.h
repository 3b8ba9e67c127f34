// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include <vtkCompositeMapperHelper2.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include "geometry/vec2.h"

class vtkOpenGLBufferObject;
class vtkTexture;
class vtkTextureObject;

namespace foam::rendering {

/// The part of vtkFoamFilmMapper that talks to OpenGL.
class FilmMapperHelper : public vtkCompositeMapperHelper2 {
public:
  static FilmMapperHelper* New();
  vtkTypeMacro(FilmMapperHelper, vtkCompositeMapperHelper2);

  /// Pixels. Changes no buffer.
  void SetFilmWidth(double width) { film_width_ = width; }
  /// cm. Changes the buffer.
  vtkSetMacro(BorderRadius, double);
  /// One of vtkFoamFilmMapper::Styles. Changes the shader.
  vtkSetMacro(FilmStyle, int);
  void SetFilmTexture(vtkTexture* texture) { picture_ = texture; }

  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  FilmMapperHelper() = default;
  ~FilmMapperHelper() override = default;

  void BuildBufferObjects(vtkRenderer* renderer, vtkActor* actor) override;
  void GetShaderTemplate(std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer,
                         vtkActor* actor) override;
  void ReplaceShaderValues(std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer,
                           vtkActor* actor) override;
  void RenderPieceStart(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPieceFinish(vtkRenderer* renderer, vtkActor* actor) override;
  void SetMapperShaderParameters(vtkOpenGLHelper& cells, vtkRenderer* renderer,
                                 vtkActor* actor) override;

private:
  /// Fills the buffer with the films of all blocks; why that cannot be done, or nothing.
  std::string build_films(vtkRenderer* renderer);
  bool draws_films(vtkRenderer* renderer) const;
  bool draws_texture() const;

  double film_width_ = 2;
  double BorderRadius = 0; // these two are named for vtkSetMacro
  int FilmStyle = 0;
  vtkSmartPointer<vtkTexture> picture_; ///< for the style Texture

  std::string problem_ = "no films yet"; ///< why films are drawn as ordinary lines
  std::map<vtkPolyData*, vtkSmartPointer<vtkPolyData>> chords_;
  Vec2 origin_; ///< of the positions in the buffer, cm
  double z_ = 0;
  vtkNew<vtkOpenGLBufferObject> buffer_;
  vtkNew<vtkTextureObject> texture_;
};

} // namespace foam::rendering

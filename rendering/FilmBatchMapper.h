// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include "CompositeMapper.h"
#include "geometry/vec2.h"

class vtkFoamFilmMapper;
class vtkOpenGLBufferObject;
class vtkTextureObject;

namespace foam::rendering {

/// The part of vtkFoamFilmMapper that talks to OpenGL.
class FilmBatchMapper final : public BatchMapper {
public:
  static FilmBatchMapper* New();
  vtkTypeMacro(FilmBatchMapper, BatchMapper);

  /// Of what is drawn and of the vtkFoamFilmMapper that it is drawn for.
  vtkMTimeType GetMTime() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  FilmBatchMapper() = default;
  ~FilmBatchMapper() override = default;

  bool GetNeedToRebuildBufferObjects(vtkRenderer* renderer, vtkActor* actor) override;
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
  const vtkFoamFilmMapper& film_mapper() const;
  int film_style() const;
  /// What VTK draws: of a block that has them the chords.
  void put_films();
  void put_chords();
  /// Fills the buffer with the films of all blocks; why that cannot be done, or nothing.
  std::string build_films(vtkRenderer* renderer);
  bool draws_films(vtkRenderer* renderer) const;
  bool draws_texture() const;

  std::string problem_ = "no films yet"; ///< why films are drawn as ordinary lines
  std::map<vtkPolyData*, vtkSmartPointer<vtkPolyData>> chords_;
  Vec2 origin_; ///< of the positions in the buffer, cm
  double z_ = 0;
  vtkNew<vtkOpenGLBufferObject> buffer_;
  vtkNew<vtkTextureObject> texture_;
};

} // namespace foam::rendering

// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * \class vtkFoamFilmMapper
 * \brief Draws films as the circular arcs that they are.
 *
 * The input is the films of a foam: polylines with the cell array HalfAngle (rad). Of each polyline
 * only the ends are used; a geometry shader puts a ribbon around the arc, and a fragment shader
 * computes how far each pixel is from it. So films are smooth at any zoom, and have a constant
 * width in pixels; they are drawn with anti-aliased edges, as translucent geometry. Each pixel near
 * a junction is drawn by the film that is nearest, so that films join without overlaps and gaps.
 *
 * If the input is not films in a plane of constant z, or OpenGL cannot do it, the mapper warns and
 * draws as its superclass does.
 *
 * After B. K. Vedel-Larsen, Quasi-static Simulation of Foam in the Vertex Model, University of
 * Copenhagen, 2010, chapter 5, and, for the distance field, J. A. Bærentzen, S. L. Nielsen, M. Gjøl
 * and B. D. Larsen, Two methods for antialiased wireframe drawing with hidden line removal, Proc.
 * SCCG 2008.
 *
 * \sa vtkFoamFilmsRepresentation
 */
#ifndef vtkFoamFilmMapper_h
#define vtkFoamFilmMapper_h

#include <algorithm>

#include "CompositeMapper.h"
#include "vtkFoamRenderingModule.h" // for the export macro
#include "vtkSmartPointer.h"        // for a member
#include "vtkTexture.h"             // for a member

class VTKFOAMRENDERING_EXPORT vtkFoamFilmMapper : public foam::rendering::CompositeMapper {
public:
  static vtkFoamFilmMapper* New();
  vtkTypeMacro(vtkFoamFilmMapper, foam::rendering::CompositeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Width of a film in pixels, at any zoom. Default 2. As it changes no buffer, the mapper does
  /// not count as modified.
  void SetFilmWidth(double width) { this->FilmWidth = std::max(width, 0.0); }
  double GetFilmWidth() const { return this->FilmWidth; }
  ///@}

  ///@{
  /// Radius (cm) of the sides of Plateau borders, were the films straight; 0, the default, for a
  /// dry foam.
  vtkSetClampMacro(BorderRadius, double, 0, VTK_DOUBLE_MAX);
  double GetBorderRadius() const { return this->BorderRadius; }
  ///@}

  /// How a film is drawn.
  enum Styles {
    Plain = 0,  ///< an even line
    Ink = 1,    ///< a stroke of a pen
    Texture = 2 ///< a picture that is repeated along the film
  };

  ///@{
  /// One of Styles. Default Plain.
  vtkSetClampMacro(FilmStyle, int, Plain, Texture);
  int GetFilmStyle() const { return this->FilmStyle; }
  ///@}

  ///@{
  /// The picture for the style Texture: its height becomes the film's width, its colours multiply
  /// the film's. Without one films are drawn plain.
  virtual void SetFilmTexture(vtkTexture* texture);
  vtkTexture* GetFilmTexture() const { return this->FilmTexture; }
  ///@}

  /// Films have soft edges, which are blended with what is behind.
  bool HasTranslucentPolygonalGeometry() override { return true; }

protected:
  vtkFoamFilmMapper();
  ~vtkFoamFilmMapper() override;

  foam::rendering::BatchMapper* NewBatchMapper() override;

  double FilmWidth = 2;
  double BorderRadius = 0;
  int FilmStyle = Plain;
  vtkSmartPointer<vtkTexture> FilmTexture;

private:
  vtkFoamFilmMapper(const vtkFoamFilmMapper&) = delete;
  void operator=(const vtkFoamFilmMapper&) = delete;
};

#endif

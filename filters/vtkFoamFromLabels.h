// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkFoamFromLabels
 * @brief Builds a two-dimensional dry foam from a picture in which bubbles are numbered.
 *
 * The foam has the neighbours and, as its target areas, the areas of the picture's regions: what
 * hangs together of a label by the sides of pixels. A bubble's BubbleId is its label. Films are
 * arcs with the ends of the line between two regions and with its area beside them. Lines of
 * background that are one or two pixels wide are closed first. Points of the image are the middles
 * of pixels, and if the labels are cell data cells are pixels.
 *
 * The films' field data say what of the picture is no bubble as it stands, and a warning does:
 * Holes, regions inside of a single bubble, which are taken for a part of it; SplitLabels, parts of
 * a label beside its largest one, and Pockets, background between bubbles, which are bubbles with
 * ids above all labels; LeftOut, regions that do not hang together with the foam.
 *
 * @sa vtkFoamFromPolygons vtkFoamFromRegions
 */
#ifndef vtkFoamFromLabels_h
#define vtkFoamFromLabels_h

#include <string> // for the name of an array

#include "vtkFoamFromRegions.h"

class VTKFOAMFILTERS_EXPORT vtkFoamFromLabels : public vtkFoamFromRegions {
public:
  static vtkFoamFromLabels* New();
  vtkTypeMacro(vtkFoamFromLabels, vtkFoamFromRegions);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum BoundaryType { Free = 0, Inner = 1, Container = 2, Periodic = 3 };

  ///@{
  /**
   * What becomes of bubbles at the picture's border: Free (default), they have films along it;
   * Inner, they are left out, and stand for the world; Container, it is a wall, along which films
   * slide; Periodic, it meets the opposite border, and a foam with background all round it is free.
   */
  vtkSetClampMacro(Boundary, int, Free, Periodic);
  vtkGetMacro(Boundary, int);
  ///@}

  ///@{
  /**
   * Name of the array of labels, whole numbers from 0, of the points or the cells. Without a name,
   * the default, the active scalars.
   */
  vtkSetStdStringFromCharMacro(LabelArray);
  vtkGetCharFromStdStringMacro(LabelArray);
  ///@}

  ///@{
  /**
   * The label of what is outside of the foam and of lines between bubbles; −1 if there is none.
   * Default 0.
   */
  vtkSetMacro(Background, int);
  vtkGetMacro(Background, int);
  ///@}

protected:
  vtkFoamFromLabels();
  ~vtkFoamFromLabels() override;

  void MakeFoam(vtkInformation* request, vtkInformationVector** inputs,
                vtkInformationVector* outputs) override;

private:
  vtkFoamFromLabels(const vtkFoamFromLabels&) = delete;
  void operator=(const vtkFoamFromLabels&) = delete;

  int Boundary = Free;
  std::string LabelArray;
  int Background = 0;
};

#endif

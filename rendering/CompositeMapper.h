// SPDX-License-Identifier: GPL-3.0-or-later
//
// VTK's mapper of blocks of polydata, as it is before and from VTK 9.3: what differs is here.
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#if __has_include(<vtkOpenGLBatchedPolyDataMapper.h>)
#include <vtkCompositePolyDataMapper.h>
#include <vtkOpenGLBatchedPolyDataMapper.h>
#include <vtkOpenGLCompositePolyDataMapperDelegator.h>
#else
#include <vtkCompositeMapperHelper2.h>
#include <vtkCompositePolyDataMapper2.h>
#endif

namespace foam::rendering {

#if __has_include(<vtkOpenGLBatchedPolyDataMapper.h>)

/// Draws several blocks at once.
class BatchMapper : public vtkOpenGLBatchedPolyDataMapper {
public:
  vtkTypeMacro(BatchMapper, vtkOpenGLBatchedPolyDataMapper);

protected:
  /// Calls f(block, drawn) with every block and what is drawn for it, which may be replaced.
  template <class F> void for_each_block(const F& f) {
    for (auto& [address, element] : this->VTKPolyDataToGLBatchElement) {
      f(reinterpret_cast<vtkPolyData*>(address), element->Parent.PolyData);
    }
  }
};

/// Draws blocks by BatchMappers of a derived class.
class CompositeMapper : public vtkCompositePolyDataMapper {
public:
  vtkTypeMacro(CompositeMapper, vtkCompositePolyDataMapper);

protected:
  virtual BatchMapper* NewBatchMapper() = 0;

private:
  class Delegator : public vtkOpenGLCompositePolyDataMapperDelegator {
  public:
    explicit Delegator(BatchMapper* mapper) {
      this->GLDelegate = mapper;
      this->Delegate = vtkSmartPointer<vtkPolyDataMapper>::Take(mapper);
      this->InitializeObjectBase();
    }
  };

  vtkCompositePolyDataMapperDelegator* CreateADelegator() final {
    return new Delegator(this->NewBatchMapper());
  }
};

#else

/// Draws several blocks at once.
class BatchMapper : public vtkCompositeMapperHelper2 {
public:
  vtkTypeMacro(BatchMapper, vtkCompositeMapperHelper2);

protected:
  /// Calls f(block, drawn) with every block and what is drawn for it, which may be replaced.
  template <class F> void for_each_block(const F& f) {
    for (auto& [block, data] : this->Data) {
      f(block, data->Data);
    }
  }
};

/// Draws blocks by BatchMappers of a derived class.
class CompositeMapper : public vtkCompositePolyDataMapper2 {
public:
  vtkTypeMacro(CompositeMapper, vtkCompositePolyDataMapper2);

protected:
  virtual BatchMapper* NewBatchMapper() = 0;

private:
  vtkCompositeMapperHelper2* CreateHelper() final { return this->NewBatchMapper(); }
};

#endif

} // namespace foam::rendering

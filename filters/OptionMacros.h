// SPDX-License-Identifier: GPL-3.0-or-later
//
// Properties of a filter that are core's options, whose defaults stand there alone. The filter's
// header declares them: VTK's wrappers read it together with this one, and without core's. Its .cxx
// lists them once, with where each stands, and makes of the list the definitions and PrintSelf:
//
//   using ThisClass = vtkFoamFilter;
//   #define FOAM_OPTIONS(option, choice) option(Name, type, place) choice(Name, place) …
//   FOAM_OPTIONS(foamDefineOption, foamDefineChoice)
#ifndef OptionMacros_h
#define OptionMacros_h

#include <algorithm>
#include <utility>

/// Declares what vtkSetMacro and vtkGetMacro define.
#define foamOptionMacro(name, type)                                                                \
  virtual void Set##name(type _arg);                                                               \
  virtual type Get##name()

/// Declares what vtkSetClampMacro and vtkGetMacro define, for an enumeration.
#define foamChoiceMacro(name, first, last)                                                         \
  foamOptionMacro(name, int);                                                                      \
  virtual int Get##name##MinValue() {                                                              \
    return first;                                                                                  \
  }                                                                                                \
  virtual int Get##name##MaxValue() {                                                              \
    return last;                                                                                   \
  }

#define foamDefineOption(name, type, place)                                                        \
  void ThisClass::Set##name(type _arg) {                                                           \
    vtkDebugMacro(<< " setting " #name " to " << _arg);                                            \
    if (foam::filters::changes(place, _arg)) {                                                     \
      this->Modified();                                                                            \
    }                                                                                              \
  }                                                                                                \
  type ThisClass::Get##name() {                                                                    \
    return static_cast<type>(place);                                                               \
  }

#define foamDefineChoice(name, place)                                                              \
  void ThisClass::Set##name(int _arg) {                                                            \
    vtkDebugMacro(<< " setting " #name " to " << _arg);                                            \
    const int nearest =                                                                            \
        std::clamp(_arg, this->Get##name##MinValue(), this->Get##name##MaxValue());                \
    if (foam::filters::changes(place, nearest)) {                                                  \
      this->Modified();                                                                            \
    }                                                                                              \
  }                                                                                                \
  int ThisClass::Get##name() {                                                                     \
    return static_cast<int>(place);                                                                \
  }

/// In PrintSelf(os, indent).
#define foamPrintOption(name, ...) os << indent << #name ": " << this->Get##name() << "\n";

namespace foam::filters {

/// Gives an option a value. \returns whether it had another
template <class Option, class Value> bool changes(Option& option, Value value) {
  const auto wanted = static_cast<Option>(value);
  return std::exchange(option, wanted) != wanted;
}

} // namespace foam::filters

#endif

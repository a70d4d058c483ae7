// Every observable's entry in the registry. A new observable is a file with its class and its entry, a line here, and
// a line in registry.cpp.
#pragma once

#include "carom/observe/registry.hpp"

namespace carom {

ObservableKind msd_kind();
ObservableKind pressure_kind();
ObservableKind pressure_tensor_kind();
ObservableKind psi6_kind();
ObservableKind rate_kind();
ObservableKind rdf_kind();
ObservableKind speeds_kind();
ObservableKind structure_factor_kind();
ObservableKind temperature_kind();
ObservableKind temperature_profile_kind();
ObservableKind vacf_kind();
ObservableKind wall_pressure_kind();

}  // namespace carom

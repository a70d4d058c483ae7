// Every observable's entry in the registry. A new observable is a file with its class and its entry, a line here, and
// a line in registry.cpp.
#pragma once

#include "carom/observe/registry.hpp"

namespace carom {

ObservableKind pressure_kind();

}  // namespace carom

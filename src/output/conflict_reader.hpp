// Reads the table of conflicts (CSV) that ConflictWriter writes.
#pragma once

#include <functional>
#include <string>

#include "conflict/conflict.hpp"

namespace pedzone {

/// Visits the conflicts of a file in its order; numbers are rounded to what it holds. Throws
/// InputError where it is missing, is another table, is cut off or holds what is no number; passes
/// on what the visitor throws.
void visit_conflicts(const std::string& file, const std::function<void(const Conflict&)>& visitor);

}  // namespace pedzone

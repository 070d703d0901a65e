// XML too large to hold: elements one after the other, from a file, gzipped or not.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "core/gzip_file.hpp"
#include "core/xml.hpp"

namespace pedzone {

/// An opening tag with its attributes. Valid while it is visited.
class XmlElement {
 public:
  /// `attributes`: names and values by turns, ended by a null pointer.
  XmlElement(const std::string& file, int line, int depth, const char* name,
             const char** attributes)
      : file_(file), line_(line), depth_(depth), name_(name), attributes_(attributes) {}

  std::string_view name() const { return name_; }
  int depth() const { return depth_; }  ///< 0: the document element

  /// An attribute's value; nothing where it is not given.
  std::optional<std::string_view> value(std::string_view attribute) const;
  /// The same of one that has to be there and not be empty; throws InputError.
  std::string_view required(std::string_view attribute) const;
  /// Value of an attribute as a number within `range`; throws InputError where it is none.
  double number(std::string_view attribute, const NumberRange& range) const;

  /// The error for the element, or for one of its attributes. `value` may be empty.
  InputError error(const std::string& problem, std::string_view attribute = {},
                   std::string_view value = {}, const std::string& allowed = "") const;

 private:
  const std::string& file_;
  int line_, depth_;
  std::string_view name_;
  const char** attributes_;
};

using ElementVisitor = std::function<void(const XmlElement&)>;

/// Visits all opening tags in their order, those of files that an <include href="..."/> names in
/// its place. Throws InputError when the file is missing, cannot be decompressed, is not
/// well-formed, or its document element is not `root` (any when empty); passes on what a visitor
/// throws.
void visit_elements(const std::string& file, std::string_view root, const ElementVisitor& visitor,
                    const ReadProgress& progress = {});

}  // namespace pedzone

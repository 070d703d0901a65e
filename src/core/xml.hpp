// XML input: a file, gzipped or not, with errors that name file, line, element and value.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace pedzone {

/// Closed range of a number, in the unit of what it stands for.
struct NumberRange {
  double least, most;
};

/// A parsed file. Nodes stay valid as long as it does.
class XmlFile {
 public:
  /// Reads and parses. Throws InputError when the file is missing, cannot be decompressed, is
  /// not well-formed, or its document element is not one of `roots` (any when empty).
  explicit XmlFile(const std::string& file, std::initializer_list<std::string_view> roots = {});

  pugi::xml_node root() const { return document_.document_element(); }
  const std::string& file() const { return file_; }
  /// Path of a file that this one names: from its own folder on, as in SUMO's files.
  std::string beside(const std::string& name) const;

  /// Line of a node's opening tag, 1-based.
  int line(const pugi::xml_node& node) const;

  /// The error for a node, or for one of its attributes. `value` may be empty.
  InputError error(const std::string& problem, const pugi::xml_node& node,
                   const std::string& attribute = "", const std::string& value = "",
                   const std::string& allowed = "") const;

  /// Value of an attribute that has to be there and not be empty.
  std::string required(const pugi::xml_node& node, const char* attribute) const;

  /// Value of an attribute as a number within `range`; throws when it is none.
  double number(const pugi::xml_node& node, const char* attribute, const NumberRange& range) const;
  /// The same; `otherwise` where the attribute is not given.
  double number(const pugi::xml_node& node, const char* attribute, const NumberRange& range,
                double otherwise) const;

  /// Throws unless all attributes of the node are among `attributes` (names of namespaces aside)
  /// and all its child elements among `children`.
  void check_names(const pugi::xml_node& node, std::initializer_list<std::string_view> attributes,
                   std::initializer_list<std::string_view> children) const;

 private:
  int line_at(std::ptrdiff_t offset) const;

  std::string file_;
  std::string text_;                   ///< what the nodes point into
  std::vector<std::size_t> newlines_;  ///< offsets of line ends in the text, ascending
  pugi::xml_document document_;
};

/// A whole string as a finite number, independent of the locale. False when it is none.
bool parse_number(std::string_view text, double& number);

/// Words of a list, split at white space (and at `separator` where one is given).
std::vector<std::string> split_words(std::string_view text, char separator = ' ');

/// `range` as "least to most".
std::string describe(const NumberRange& range);

/// A document as the text of a file.
std::string xml_text(const pugi::xml_document& document);

}  // namespace pedzone

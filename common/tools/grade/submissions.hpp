// What students handed in: whose folder it is, and where their chapters or pictures lie in it.
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "grades.hpp"

namespace texmap::grade {

/// A picture that was handed in for an item, or why none can be taken.
struct FoundPicture {
  std::filesystem::path path;
  std::string why_not;
};

/// One student's folder.
struct Submission {
  std::string folder;  ///< as the instructor named it
  std::string name;
  std::filesystem::path path;
  std::filesystem::path checkout;  ///< the folder that holds chapters/; empty for pictures
  std::map<std::string, FoundPicture> pictures;  ///< by the item's name
  std::string note;
};

/// The submissions in the folders that were named. A folder that has no work of its own, but two or
/// more folders with work, is a class: each folder in it is a student's.
///
/// @param items  what pictures are looked for, by name or number, in any case
/// Links below the folders that were named are not followed.
[[nodiscard]] std::vector<Submission> find_submissions(
    const std::vector<std::filesystem::path>& folders, const std::vector<Item>& items);

/// Names for the pages of the students, one for each: no two are equal in any case.
[[nodiscard]] std::vector<std::string> page_names(const std::vector<Submission>& submissions);

}  // namespace texmap::grade

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
  std::filesystem::path checkout;  ///< holds chapters/ or the chapters; empty for pictures
  std::map<std::string, FoundPicture> pictures;  ///< by the item's name
  std::string note;
  std::string seen = {};  ///< pictures and code that lie there, by name, where no checkout is
};

/// What a folder that was named is: the only one named, it is a class if folders in it have work.
enum class Reading { by_structure, one_student, students };

/// The submissions that were found.
struct Found {
  std::vector<Submission> submissions;
  std::vector<std::string> remarks;  ///< how a folder was read that can be read in two ways
};

/// The submissions in the folders that were named. Two or more folders with work make a class, also
/// next to a picture; the folder with chapters/ is one student's.
///
/// @param items  what pictures are looked for, by name or number, in any case
/// Links below the folders that were named are not followed.
[[nodiscard]] Found find_submissions(const std::vector<std::filesystem::path>& folders,
                                     const std::vector<Item>& items,
                                     Reading reading = Reading::by_structure);

/// Names for the pages of the students, one for each: no two are equal in any case.
[[nodiscard]] std::vector<std::string> page_names(const std::vector<Submission>& submissions);

}  // namespace texmap::grade

// Where a texture is looked for.
#include <doctest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "engine/files/find_texture.hpp"
#include "support/temporary_folder.hpp"

namespace {

namespace fs = std::filesystem;
using texmap::find_texture;
using texmap::test::image_error_of;
using texmap::test::put;
using texmap::test::TemporaryFolder;

constexpr const char* variable = "TEXMAP_ASSETS";

// The current folder, put back at the end of a test; the variable of the environment is not set.
class Surroundings {
 public:
  explicit Surroundings(const std::string& folder) : folder_before_(fs::current_path()) {
    unsetenv(variable);
    fs::current_path(folder);
  }
  ~Surroundings() { fs::current_path(folder_before_); }
  Surroundings(const Surroundings&) = delete;
  Surroundings& operator=(const Surroundings&) = delete;

 private:
  fs::path folder_before_;
};

std::string error_of_finding(const std::string& name) {
  return image_error_of([&] { static_cast<void>(find_texture(name)); });
}

std::string beside_the_program() {
  return fs::read_symlink("/proc/self/exe").parent_path().string() + "/assets";
}

}  // namespace

TEST_CASE("a name comes back as it is where it is there, has a slash or cannot be loaded") {
  const TemporaryFolder folder;
  const Surroundings surroundings(folder.path());
  put("here.png", {1});
  fs::create_symlink("nowhere", "dangling");
  fs::create_directory("folder");
  for (const std::string& name :
       {std::string("here.png"), folder / "here.png", folder / "missing.png",
        std::string("./missing.png"), std::string("a/b"), std::string("dangling"),
        std::string("folder"), std::string(300, 'x'), std::string()}) {
    CHECK(find_texture(name) == name);
  }
}

TEST_CASE(
    "a bare name is looked for here, then in the assets next to the program, then in the folder "
    "that the environment names") {
  const TemporaryFolder folder;
  const TemporaryFolder assets;
  const Surroundings surroundings(folder.path());
  setenv(variable, assets.path().c_str(), 1);
  const std::string name = "texmap-test-" + std::to_string(getpid()) + ".png";
  put(assets / name, {1});
  CHECK(find_texture(name) == assets / name);
  if (fs::exists("/proc/self/exe")) {
    const bool made = fs::create_directory(beside_the_program());
    put(beside_the_program() + "/" + name, {1});
    CHECK(find_texture(name) == beside_the_program() + "/" + name);
    put(name, {1});
    CHECK(find_texture(name) == name);
    fs::remove(beside_the_program() + "/" + name);
    if (made) fs::remove(beside_the_program());
  }
  put(name, {1});
  CHECK(find_texture(name) == name);
}

TEST_CASE("a name that is nowhere is an error that lists every place in order") {
  const TemporaryFolder folder;
  const Surroundings surroundings(folder.path());
  setenv(variable, "/an/empty/place", 1);
  const std::string name = "nowhere to be found.png";
  // The assets of the build come first of all assets.
  const fs::path assets = fs::path(TEXMAP_TESTS_DIR).parent_path() / "assets";
  const std::string front = "cannot load texture '" + name + "': not found; looked for " + name +
                            ", " + (assets / name).string() + ", ";
  const std::string back = "assets/" + name + ", /an/empty/place/" + name;
  const std::string said = error_of_finding(name);
  INFO("said: ", said);
  CHECK(said.substr(0, front.size()) == front);
  CHECK(said.ends_with(back));
  if (fs::exists("/proc/self/exe"))
    CHECK(said.find(", " + beside_the_program() + "/" + name + ", ") != std::string::npos);

  unsetenv(variable);
  const std::string without = error_of_finding(name);
  CHECK(without.find("/an/empty/place") == std::string::npos);
  CHECK(said.substr(0, without.size()) == without);
  setenv(variable, "", 1);
  CHECK(error_of_finding(name) == without);
}

// The program pack_png: files become smaller, and pixels stay.
#include <doctest.h>

#include "engine/picture/load_image.hpp"
#include "engine/picture/save_png.hpp"
#include "support/made_pictures.hpp"
#include "support/running.hpp"
#include "support/temporary_folder.hpp"

using namespace texmap;
using namespace texmap::test;

TEST_CASE("plain pictures of a folder are packed once, and all other files stay as they are") {
  const TemporaryFolder folder;
  const std::filesystem::path golden = TEXMAP_TESTS_DIR "/golden/08_clamp.png";
  const Image image = load_image(golden);
  std::filesystem::create_directory(folder / "diff");
  for (const char* const name : {"a.png", "diff/b.png"}) save_png(image, folder / name);
  const std::vector<std::uint8_t> fast = bytes_of(folder / "a.png");
  // The same picture with a chunk of text behind its header, as another program may write it.
  std::vector<std::uint8_t> with_text = fast;
  const std::vector<std::uint8_t> chunk = {0, 0, 0, 3, 't', 'E', 'X', 't', 'a', 0, 'b', 0, 0, 0, 0};
  with_text.insert(with_text.begin() + 33, chunk.begin(), chunk.end());
  put(folder / "text.png", with_text);
  put(folder / "cut.png", {fast.begin(), fast.begin() + 30});
  put(folder / "notes.txt", {'a'});

  const std::string program = "'" TEXMAP_PACK_PNG "' '" + folder.path() + "'";
  const Outcome first = run(program);
  CHECK(first.status == 0);
  CHECK(first.err.empty());
  CHECK(first.out.find("2 pictures packed: ") == 0);
  for (const char* const name : {"a.png", "diff/b.png"}) {
    CHECK(bytes_of(folder / name).size() < fast.size() * 95 / 100);
    CHECK(load_image(folder / name) == image);
  }
  CHECK(bytes_of(folder / "text.png") == with_text);
  CHECK(bytes_of(folder / "cut.png").size() == 30);

  const std::vector<std::uint8_t> close = bytes_of(folder / "a.png");
  const Outcome second = run(program);
  CHECK(second.status == 0);
  CHECK(second.out.empty());
  CHECK(bytes_of(folder / "a.png") == close);
}

TEST_CASE("a folder that is not there is an error") {
  const Outcome outcome = run("'" TEXMAP_PACK_PNG "' /nowhere/at/all");
  CHECK(outcome.status == 1);
  CHECK(outcome.err.find("/nowhere/at/all") != std::string::npos);
}

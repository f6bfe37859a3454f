// SPDX-License-Identifier: MIT
// Files of parts: what is whole is kept, what is not is told.
#include "map/part.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "map/checksum.h"
#include "map/write.h"
#include "pipeline/files.h"
#include "toolchain/workshop.h"

namespace qvgen::map {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::ThrowsMessage;

About some_about() {
  About about;
  about.robot = "arm";
  about.task = "pose";
  about.program = "1";
  about.limits_known = true;
  about.plan.sphere = {{0, 0, 0}, 1, 0.15};
  about.plan.targets = 3;
  return about;
}

std::vector<Cell> cells_of(const About& about, int block) {
  const Grid grid(about.plan.sphere);
  std::vector<Cell> cells(static_cast<std::size_t>(grid.first_of(block + 1) - grid.first_of(block)));
  for (Cell& cell : cells) {
    cell.reached = static_cast<std::uint32_t>(block % 4);
    cell.see(block, 0.5);
  }
  return cells;
}

Part some_part(int first, int last) {
  Part part{some_about(), {}};
  for (int block = first; block <= last; ++block) part.blocks[block] = cells_of(part.about, block);
  return part;
}

TEST(Checksum, IsThatOfZipFiles) { EXPECT_EQ(checksum("123456789"), 0xCBF43926U); }

TEST(Parts, SayWhichBlocksAreMissing) {
  EXPECT_EQ(missing_blocks(some_part(0, 999).blocks), "");
  EXPECT_EQ(missing_blocks(some_part(1, 998).blocks), "0, 999");
  Blocks blocks = some_part(0, 999).blocks;
  for (const int gone : {3, 17, 18, 19}) blocks.erase(gone);
  EXPECT_EQ(missing_blocks(blocks), "3, 17:19");
}

class Files : public testing::Test {
 protected:
  toolchain::Workshop workshop;
  fs::path write(const std::string& name, const Part& part) {
    write_map(part, workshop.folder() / name);
    return workshop.folder() / name;
  }
};

TEST_F(Files, AreMergedInAnyOrder) {
  const auto a = write("a.part", some_part(0, 400)), b = write("b.part", some_part(390, 999));
  EXPECT_EQ(part_text(merged({b, a})), part_text(some_part(0, 999)));
}

TEST_F(Files, OfDifferentMapsAreRefused) {
  const auto a = write("a.part", some_part(0, 400));
  Part other = some_part(401, 999);
  other.about.plan.targets = 4;
  const auto b = write("b.part", other);
  EXPECT_THAT([&] { merged({a, b}); }, ThrowsMessage<std::runtime_error>(HasSubstr("orientations 4, not 3")));
  Part changed = some_part(400, 400);
  changed.blocks[400][0].reached += 1;
  const auto c = write("c.part", changed);
  EXPECT_THAT([&] { merged({a, c}); }, ThrowsMessage<std::runtime_error>(HasSubstr("block 400")));
  EXPECT_THAT([&] { merged({workshop.folder() / "none.part"}); },
              ThrowsMessage<std::runtime_error>(HasSubstr("there is no file")));
  workshop.write("x.part", "nothing of the kind");
  EXPECT_THAT([&] { merged({workshop.folder() / "x.part"}); },
              ThrowsMessage<std::runtime_error>(HasSubstr("no part of a map")));
}

TEST_F(Files, ThatAreCutShortOrDamagedAreRefused) {
  const auto a = write("a.part", some_part(0, 9));
  std::string text = *pipeline::content_of(a);
  workshop.write("short.part", text.substr(0, text.size() - 1));
  EXPECT_THAT([&] { read_part(workshop.folder() / "short.part"); },
              ThrowsMessage<std::runtime_error>(HasSubstr("cut short or damaged")));
  text[text.size() - 20] = static_cast<char>(text[text.size() - 20] ^ 1);
  workshop.write("damaged.part", text);
  EXPECT_THROW(read_part(workshop.folder() / "damaged.part"), std::runtime_error);
}

TEST_F(Files, WithMissingBlocksAreNotWritten) {
  Part part = some_part(0, 999);
  part.blocks.erase(12);
  EXPECT_THAT([&] { write("map.npz", part); },
              ThrowsMessage<std::runtime_error>(HasSubstr("the blocks 12 are missing")));
  EXPECT_FALSE(fs::exists(workshop.folder() / "map.npz"));
}

TEST_F(Files, ThatAreUnfinishedGoOnAfterAnyCut) {
  const fs::path file = workshop.folder() / "map.unfinished";
  const std::string whole = part_text(some_part(0, 20));
  for (std::size_t cut = 0; cut <= whole.size(); cut += cut < 600 ? 37 : 211) {
    workshop.write("map.unfinished", whole.substr(0, cut));
    Journal journal(file, some_about());
    const int next = static_cast<int>(journal.blocks().size());
    for (int block = next; block <= 20; ++block) journal.add(block, cells_of(some_about(), block));
    EXPECT_EQ(part_text(journal.part()), whole) << cut;
    EXPECT_EQ(*pipeline::content_of(file), whole) << cut;
  }
}

TEST_F(Files, ThatAreUnfinishedBelongToOneMapAndOneProcess) {
  const fs::path file = workshop.folder() / "map.unfinished";
  {
    Journal journal(file, some_about());
    EXPECT_THAT([&] { Journal(file, some_about()); },
                ThrowsMessage<std::runtime_error>(HasSubstr("another process")));
  }
  EXPECT_FALSE(fs::exists(file)) << "nothing to go on with";
  { Journal(file, some_about()).add(0, cells_of(some_about(), 0)); }
  About other = some_about();
  other.plan.sphere.resolution = 0.1;
  EXPECT_THAT([&] { Journal(file, other); },
              ThrowsMessage<std::runtime_error>(HasSubstr("has resolution 0.15, not 0.1")));
  EXPECT_TRUE(fs::exists(file));
  Journal again(file, some_about());
  EXPECT_EQ(again.blocks().size(), 1U);
}

}  // namespace
}  // namespace qvgen::map

// scene_obj_path_test.cpp: which files a model may open.
#include <sys/stat.h>

#include "scene_obj_testing.h"

namespace raster {
namespace {

namespace fs = std::filesystem;
using testing::Folder;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::load;
using testing::Loaded;

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

/// A folder with model/ in it and, beside that, the file outside.mtl that defines `secret`.
struct Yard {
    Folder folder;
    Yard() {
        folder.write("outside.mtl", "newmtl secret\n");
        folder.write("model/inside.mtl", "newmtl secret\n");
        folder.write("model/sub/deep.mtl", "newmtl secret\n");
    }
    Loaded load(const std::string& names, bool allow_outside = false) const {
        ObjOptions options;
        options.allow_outside = allow_outside;
        return testing::load(
            folder.write("model/m.obj", "mtllib " + names + "\n" + triangle + "usemtl secret\nf 1 2 3\n"), options);
    }
    void expect_read(const std::string& names, bool allow_outside = false) const {
        const Loaded l = load(names, allow_outside);
        ASSERT_TRUE(l.ok()) << names << ": " << l.error();
        EXPECT_THAT(l.warnings(), IsEmpty()) << names;
        EXPECT_EQ(l.model->parts[0].material, 0) << names;
    }
    void expect_refused(const std::string& names, const std::string& why, bool allow_outside = false) const {
        const Loaded l = load(names, allow_outside);
        ASSERT_TRUE(l.ok()) << names << ": " << l.error();
        EXPECT_TRUE(l.model->materials.empty()) << names;
        EXPECT_THAT(l.warnings().at(0), HasSubstr(":1: material file '" + names + "': " + why)) << names;
    }
};

TEST(ObjPaths, WhatLiesInTheFolderIsOpened) {
    const Yard yard;
    for (const std::string name : {"inside.mtl", "./inside.mtl", "sub/deep.mtl", "sub\\deep.mtl", "sub/../inside.mtl"})
        yard.expect_read(name);
    fs::create_symlink("inside.mtl", yard.folder.path("model/link.mtl"));
    yard.expect_read("link.mtl");
}

TEST(ObjPaths, WhatLeadsOutOfTheFolderIsRefused) {
    const Yard yard;
    const std::string out = "refused: leads out of the model's folder";
    yard.expect_refused("../outside.mtl", out);
    yard.expect_refused("..\\outside.mtl", out);
    yard.expect_refused("sub/../../outside.mtl", out);
    yard.expect_refused("../../../../../../../../etc/passwd", out);
    yard.expect_refused("/etc/passwd", out);
    yard.expect_refused("C:\\Windows\\win.ini", out);
    yard.expect_refused(yard.folder.path("outside.mtl"), out);
    yard.expect_refused(yard.folder.path("model/inside.mtl"), out);
    yard.expect_refused("../model-2/x.mtl", out);
    fs::create_symlink("../outside.mtl", yard.folder.path("model/link.mtl"));
    yard.expect_refused("link.mtl", out);
    fs::create_directory_symlink("..", yard.folder.path("model/up"));
    yard.expect_refused("up/outside.mtl", out);

    yard.expect_read("../outside.mtl", true);
    yard.expect_read(yard.folder.path("outside.mtl"), true);
    yard.expect_read("link.mtl", true);
    yard.expect_read("up/outside.mtl", true);
}

TEST(ObjPaths, FoldersPipesAndDevicesAreRefusedAlways) {
    const Yard yard;
    ASSERT_EQ(::mkfifo(yard.folder.path("model/fifo").c_str(), 0600), 0);  // opening it would wait for ever
    for (const bool allow_outside : {false, true}) {
        yard.expect_refused("fifo", "refused: not a regular file", allow_outside);
        yard.expect_refused("sub", "refused: a folder", allow_outside);
        yard.expect_refused(".", "refused: a folder", allow_outside);
    }
    yard.expect_refused("/dev/zero", "refused: leads out");
    yard.expect_refused("/dev/zero", "refused: not a regular file", true);
    yard.expect_refused("/dev/stdin", "refused: not a regular file", true);
}

TEST(ObjPaths, ImpossibleNamesAreNotFound) {
    const Yard yard;
    yard.expect_refused("none.mtl", "not found");
    yard.expect_refused("inside.mtl/x", "not found");
    yard.expect_refused(std::string(300, 'x').substr(0, 119), "not found");
    EXPECT_THAT(yard.load(std::string(300, 'x')).warnings()[0], HasSubstr("not found: "));
    EXPECT_THAT(yard.load(std::string(100'000, 'x')).warnings()[0], HasSubstr("not a file name"));
    fs::create_symlink("loop.mtl", yard.folder.path("model/loop.mtl"));
    yard.expect_refused("loop.mtl", "not found");
}

TEST(ObjPaths, TheModelsFolderMayItselfBeALink) {
    const Yard yard;
    yard.folder.write("model/m.obj", "mtllib inside.mtl\n" + triangle + "usemtl secret\nf 1 2 3\n");
    fs::create_directory_symlink("model", yard.folder.path("link"));
    const Loaded l = load(yard.folder.path("link/m.obj"));
    ASSERT_TRUE(l.ok()) << l.error();
    EXPECT_THAT(l.warnings(), IsEmpty());
}

TEST(ObjPaths, ALargeMaterialFileIsRefused) {
    const Folder folder;
    folder.write("m.mtl", "newmtl a\n");
    ObjOptions options;
    options.max_material_bytes = 5;
    const Loaded l = load(folder.write("m.obj", "mtllib m.mtl\n" + triangle + "f 1 2 3\n"), options);
    ASSERT_TRUE(l.ok());
    EXPECT_THAT(l.warnings()[0], HasSubstr("larger than the limit of 5 bytes"));
}

}  // namespace
}  // namespace raster

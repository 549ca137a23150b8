// scene_obj_material_test.cpp: MTL files, textures, and which files a model may open.
#include <sys/stat.h>

#include <raster/image/decode.h>
#include <raster/image/png.h>
#include <raster/scene/obj_material.h>

#include "scene_obj_testing.h"

namespace raster {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using testing::expect_sound;
using testing::Folder;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::load;
using testing::Loaded;
using testing::strict;

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

/// The materials of an MTL text, by the whole way.
Loaded with_mtl(const std::string& mtl, const ObjOptions& options = {}) {
    const Folder folder;
    folder.write("m.mtl", mtl);
    return load(folder.write("m.obj", "mtllib m.mtl\n" + triangle + "usemtl a\nf 1 2 3\n"), options);
}

std::string bytes_of(const Image8& image) {
    const Result<Bytes> png = encode_png(image);
    return png ? std::string(reinterpret_cast<const char*>(png->data()), png->size()) : "";
}

// ------------------------------------------------------------------------------------------- statements

TEST(Mtl, EveryKeyThatIsUsed) {
    const Loaded l = with_mtl(
        "newmtl a\nKa 0.1 0.2 0.3\nKd 0.4 0.5 0.6\nKs 0.7 0.8 0.9\nKe 1 2 3\nNs 99.5\nNi 1.45\nd 0.25\nillum 3\n"
        "Pr 0.5\nPm 1\nPs 0.125\n");
    ASSERT_TRUE(l.ok()) << l.error();
    EXPECT_THAT(l.warnings(), IsEmpty());
    ASSERT_EQ(l.model->materials.size(), 1u);
    const Material& m = l.model->materials[0];
    EXPECT_EQ(m.name, "a");
    EXPECT_EQ(m.ambient, glm::vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(m.diffuse, glm::vec3(0.4f, 0.5f, 0.6f));
    EXPECT_EQ(m.specular, glm::vec3(0.7f, 0.8f, 0.9f));
    EXPECT_EQ(m.emission, glm::vec3(1, 2, 3));
    EXPECT_EQ(m.shininess, 99.5f);
    EXPECT_EQ(m.index_of_refraction, 1.45f);
    EXPECT_EQ(m.alpha, 0.25f);
    EXPECT_EQ(m.illumination, 3);
    EXPECT_EQ(m.roughness, 0.5f);
    EXPECT_EQ(m.metallic, 1.0f);
    EXPECT_EQ(m.sheen, 0.125f);
    EXPECT_EQ(l.model->parts[0].material, 0);
}

TEST(Mtl, WhatIsNotGivenHasTheDefault) {
    const Material m = with_mtl("newmtl a\n").model->materials[0], d;
    EXPECT_EQ(m.diffuse, d.diffuse);
    EXPECT_EQ(m.shininess, d.shininess);
    EXPECT_EQ(m.alpha, 1.0f);
    EXPECT_EQ(m.diffuse_texture, -1);
}

TEST(Mtl, OneNumberIsAGreyAndValuesStayInTheirRanges) {
    const Material m = with_mtl("newmtl a\nKd 0.5\nd 7\nNs -3\nillum 99\nPr -1\n").model->materials[0];
    EXPECT_EQ(m.diffuse, glm::vec3(0.5f));
    EXPECT_EQ(m.alpha, 1.0f);
    EXPECT_EQ(m.shininess, 0.0f);
    EXPECT_EQ(m.illumination, 10);
    EXPECT_EQ(m.roughness, 0.0f);
}

TEST(Mtl, TransparencyIsTheOppositeOfDAndDCounts) {
    EXPECT_EQ(with_mtl("newmtl a\nTr 0.25\n").model->materials[0].alpha, 0.75f);
    EXPECT_EQ(with_mtl("newmtl a\nd 0.5\nTr 0.25\n").model->materials[0].alpha, 0.5f);
    EXPECT_EQ(with_mtl("newmtl a\nTr 0.25\nd 0.5\n").model->materials[0].alpha, 0.5f);
    EXPECT_EQ(with_mtl("newmtl a\nd -halo 0.5\n").model->materials[0].alpha, 0.5f);
    EXPECT_EQ(with_mtl("newmtl b\nd 0.5\nnewmtl a\nTr 0.25\n").model->materials[1].alpha, 0.75f);
}

TEST(Mtl, ABadNumberLeavesTheValueAndUnknownKeysAreCountedByName) {
    const std::string text = "newmtl a\nKd 1 nan 0\nNs 1e999\nd\nKm 0.05\nKm 0.1\nfoo\nillum x\n";
    const Loaded l = with_mtl(text);
    ASSERT_TRUE(l.ok()) << l.error();
    EXPECT_EQ(l.model->materials[0].diffuse, Material{}.diffuse);
    EXPECT_EQ(l.model->materials[0].shininess, Material{}.shininess);
    EXPECT_THAT(l.warnings(),
                ElementsAre("m.mtl:2: Kd without a number that can be used: '1 nan 0'",
                            "m.mtl:3: Ns without a number that can be used: '1e999'",
                            "m.mtl:4: d without a number that can be used: ''", "m.mtl:5: unknown key 'Km' (2 times)",
                            "m.mtl:7: unknown key 'foo'", "m.mtl:8: illum without a number that can be used: 'x'"));
    EXPECT_EQ(with_mtl(text, strict()).error(), "m.mtl:2: Kd without a number that can be used: '1 nan 0'");
    EXPECT_EQ(with_mtl("newmtl a\nfoo 1\n", strict()).error(), "m.mtl:2: unknown key 'foo'");
}

TEST(Mtl, KnownKeysThatAreNotUsedAreNoFaults) {
    const Loaded l = with_mtl("newmtl a\nTf 1 1 1\nmap_Bump x.png\nTf 1 1 1\nKd spectral x.rfl\n", strict());
    ASSERT_TRUE(l.ok()) << l.error();
    EXPECT_THAT(l.warnings(),
                ElementsAre("m.mtl:2: Tf is not used here (2 times)", "m.mtl:3: map_Bump is not used here",
                            "m.mtl:5: Kd in other terms than r g b is not used here"));
}

TEST(Mtl, TheTextRulesAreThoseOfObjFiles) {
    const Loaded l = with_mtl("\xef\xbb\xbf  newmtl a\r\nKd 1 \\\r\n 0 0\r# c\r\n\tNs\t5 # shiny");
    ASSERT_TRUE(l.ok()) << l.error();
    EXPECT_THAT(l.warnings(), IsEmpty());
    EXPECT_EQ(l.model->materials[0].diffuse, glm::vec3(1, 0, 0));
    EXPECT_EQ(l.model->materials[0].shininess, 5.0f);
    EXPECT_THAT(with_mtl(std::string("newmtl a\nKd 1\0 0 0\n", 20)).warnings(),
                ElementsAre("m.mtl:2: zero bytes, taken for blanks"));
    EXPECT_THAT(with_mtl("\xff\xfen\n").warnings()[0], HasSubstr("UTF-16"));
    EXPECT_THAT(with_mtl("newmtl a\nKd " + std::string(70000, '1') + "\n").warnings(),
                ElementsAre(HasSubstr("m.mtl:2: longer than 65536 bytes")));
}

TEST(Mtl, OddDefinitions) {
    const Loaded l = with_mtl("Kd 1 0 0\nNs 3\nnewmtl a\nKd 0 1 0\nnewmtl a\nKd 0 0 1\nnewmtl Material #25\n");
    ASSERT_TRUE(l.ok()) << l.error();
    EXPECT_EQ(l.model->materials[0].diffuse, glm::vec3(0, 1, 0));
    EXPECT_EQ(l.model->materials[1].name, "Material #25");
    EXPECT_THAT(l.warnings(), ElementsAre("m.mtl: 2 statements before the first newmtl (first at line 1)",
                                          "m.mtl:5: material 'a' is defined again; the first definition counts"));
}

// ---------------------------------------------------------------------------------------- which materials

TEST(ObjMaterials, AreFoundByNameWhereverTheFileIsNamed) {
    const Folder folder;
    folder.write("one.mtl", "newmtl red\nKd 1 0 0\nnewmtl hard shiny plastic\nKd 0 1 0\n");
    folder.write("my own.mtl", "newmtl blue\nKd 0 0 1\n");
    const Loaded l =
        load(folder.write("m.obj", triangle + "usemtl blue \nf 1 2 3\nmtllib one.mtl my own.mtl\nmtllib my own.mtl\n"
                                              "usemtl red\nf 1 2 3\nusemtl hard shiny plastic\t\nf 1 2 3\n"));
    ASSERT_TRUE(l.ok()) << l.error();
    expect_sound(*l.model);
    ASSERT_EQ(l.model->parts.size(), 3u);
    EXPECT_EQ(l.model->materials[std::size_t(l.model->parts[0].material)].name, "blue");
    EXPECT_EQ(l.model->materials[std::size_t(l.model->parts[1].material)].name, "red");
    EXPECT_EQ(l.model->materials[std::size_t(l.model->parts[2].material)].name, "hard shiny plastic");
    EXPECT_THAT(l.warnings(), ElementsAre(HasSubstr(":6: material file 'my': not found"),
                                          HasSubstr(":6: material file 'own.mtl': not found")));
}

TEST(ObjMaterials, SeveralFilesInOneStatementAreAllRead) {
    const Folder folder;
    folder.write("a.mtl", "newmtl a\n");
    folder.write("sub/b.mtl", "newmtl b\n");
    const Loaded l = load(folder.write(
        "m.obj", "mtllib a.mtl sub\\b.mtl\nmtllib a.mtl\n" + triangle + "usemtl b\nf 1 2 3\nusemtl a\nf 1 2 3\n"));
    ASSERT_TRUE(l.ok()) << l.error();
    EXPECT_THAT(l.warnings(), IsEmpty());
    EXPECT_EQ(l.model->materials.size(), 2u);
}

TEST(ObjMaterials, MissingFilesAndUnknownNamesAreTheDefaultWithOneWarningAName) {
    const Folder folder;
    const std::string path = folder.write("m.obj", "mtllib no.mtl\nmtllib no.mtl\n" + triangle +
                                                       "usemtl gold\nf 1 2 3\nusemtl lead\nusemtl gold\nf 1 3 2\n");
    const Loaded l = load(path);
    ASSERT_TRUE(l.ok()) << l.error();
    EXPECT_THAT(l.warnings(), ElementsAre(path + ":1: material file 'no.mtl': not found",
                                          path + ":6: unknown material 'gold'; the default takes its place"));
    EXPECT_EQ(l.model->parts[0].material, -1);
    EXPECT_EQ(load(path, strict()).error(), path + ":1: material file 'no.mtl': not found");
    const std::string only_name = folder.write("n.obj", triangle + "usemtl gold\nf 1 2 3\n");
    EXPECT_EQ(load(only_name, strict()).error(),
              only_name + ":4: unknown material 'gold'; the default takes its place");
}

TEST(ObjMaterials, WithoutAFolderNoFileIsOpened) {
    const Loaded l = testing::parse("mtllib /etc/passwd\n" + triangle + "f 1 2 3\n");
    ASSERT_TRUE(l.ok());
    EXPECT_THAT(l.warnings(), ElementsAre("m.obj:1: material file '/etc/passwd' is not opened"));
}

// ------------------------------------------------------------------------------- files outside the folder

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

// -------------------------------------------------------------------------------------------- textures

/// A model whose material has the line `map_Kd LINE`.
struct Textured {
    Folder folder;
    Loaded load(const std::string& line, ObjOptions options = {}) const {
        folder.write("m.mtl", "newmtl a\nmap_Kd " + line + "\n");
        return testing::load(folder.write("m.obj", "mtllib m.mtl\n" + triangle + "usemtl a\nf 1 2 3\n"), options);
    }
    void expect_checker(const std::string& name, const std::string& why) const {
        const Loaded l = load(name);
        ASSERT_TRUE(l.ok()) << l.error();
        ASSERT_EQ(l.model->textures.size(), 1u);
        EXPECT_EQ(l.model->textures[0].image, missing_texture());
        EXPECT_EQ(l.model->materials[0].diffuse_texture, 0);
        ASSERT_EQ(l.warnings().size(), 1u);
        EXPECT_THAT(l.warnings()[0], HasSubstr("m.mtl:2: texture '" + name + "': " + why));
        EXPECT_THAT(l.warnings()[0], HasSubstr("; a checker takes its place"));
        EXPECT_THAT(load(name, strict()).error(), HasSubstr("m.mtl:2: texture '" + name + "': " + why));
    }
};

const Image8 small_image(3, 2, 3, 77);

TEST(ObjTextures, AreLoadedOnceAndBelongToTheirSlots) {
    const Folder folder;
    folder.write("a.png", bytes_of(small_image));
    folder.write("tex/b.png", bytes_of(Image8(1, 1, 1, 5)));
    folder.write("m.mtl",
                 "newmtl a\nmap_Kd a.png\nmap_Ks tex\\b.png\nmap_Ka .\\a.png\nnewmtl b\nmap_Ke tex/b.png\nmap_d a.png\n"
                 "newmtl unused\nmap_Kd none.png\n");
    const Loaded l =
        load(folder.write("m.obj", "mtllib m.mtl\n" + triangle + "usemtl a\nf 1 2 3\nusemtl b\nf 3 2 1\n"));
    ASSERT_TRUE(l.ok()) << l.error();
    EXPECT_THAT(l.warnings(), IsEmpty());  // textures of materials that nothing uses are not looked for
    expect_sound(*l.model);
    ASSERT_EQ(l.model->textures.size(), 2u);
    EXPECT_EQ(l.model->textures[0].name, "a.png");
    EXPECT_EQ(l.model->textures[0].image, small_image);
    const Material &a = l.model->materials[0], &b = l.model->materials[1];
    EXPECT_THAT((std::vector{a.diffuse_texture, a.specular_texture, a.ambient_texture, a.emission_texture,
                             a.alpha_texture, b.emission_texture, b.alpha_texture, b.diffuse_texture}),
                ElementsAre(0, 1, 0, -1, -1, 1, 0, -1));
}

TEST(ObjTextures, StandBesideTheMaterialFileOrTheModel) {
    const Folder folder;
    folder.write("mtl/near.png", bytes_of(small_image));
    folder.write("far.png", bytes_of(small_image));
    folder.write("mtl/m.mtl", "newmtl a\nmap_Kd near.png\nmap_Ks far.png\nmap_Ka ../far.png\n");
    const Loaded l = load(folder.write("m.obj", "mtllib mtl/m.mtl\n" + triangle + "usemtl a\nf 1 2 3\n"));
    ASSERT_TRUE(l.ok()) << l.error();
    EXPECT_THAT(l.warnings(), IsEmpty());
    EXPECT_EQ(l.model->textures.size(), 2u);
}

TEST(ObjTextures, OptionsAreReadAndTheNameFound) {
    const Textured t;
    t.folder.write("my image.png", bytes_of(small_image));
    t.folder.write("-x.png", bytes_of(small_image));
    const std::string unused = "m.mtl:2: texture options other than -clamp are not used here";
    for (const std::string options :
         {"-s 2 ", "-s 2 3 ", "-s 2 3 4 ", "-o 0.5 ", "-t 1 ", "-mm 0 ", "-mm 0 2 ", "-blendu on ",
          "-bm 1 -imfchan r -texres 64 ", "-s 1 1 1 -o 0 0 -colorspace sRGB "}) {
        const Loaded l = t.load(options + "my image.png", strict());
        ASSERT_TRUE(l.ok()) << options << l.error();
        EXPECT_EQ(l.model->textures[0].name, "my image.png");
        EXPECT_FALSE(l.model->materials[0].clamp_texture);
        EXPECT_THAT(l.warnings(), ElementsAre(unused)) << options;
    }
    EXPECT_TRUE(t.load("-clamp on my image.png").model->materials[0].clamp_texture);
    EXPECT_THAT(t.load("-clamp on my image.png").warnings(), IsEmpty());
    EXPECT_FALSE(t.load("-clamp off my image.png").model->materials[0].clamp_texture);
    EXPECT_TRUE(t.load("-s 2 -clamp on my image.png").model->materials[0].clamp_texture);
    EXPECT_THAT(t.load("-x.png").warnings(), IsEmpty());
    EXPECT_THAT(t.load("-clamp on").warnings(), ElementsAre("m.mtl:2: map_Kd without a file name"));
    EXPECT_THAT(t.load("").warnings(), ElementsAre("m.mtl:2: map_Kd without a file name"));
}

TEST(ObjTextures, WhatCannotBeUsedBecomesAChecker) {
    const Textured t;
    t.expect_checker("none.png", "not found");
    t.expect_checker("../x.png", "refused: leads out of the model's folder");
    t.expect_checker("/etc/passwd", "refused: leads out of the model's folder");
    t.expect_checker(".", "refused: a folder");
    ASSERT_EQ(::mkfifo(t.folder.path("fifo.png").c_str(), 0600), 0);
    t.expect_checker("fifo.png", "refused: not a regular file");
    const std::string png = bytes_of(Image8(40, 40, 3, 9));
    t.folder.write("cut.png", png.substr(0, png.size() / 2));
    t.expect_checker("cut.png", "");
    t.folder.write("text.png", "this is no picture");
    t.expect_checker("text.png", "");
    t.folder.write("empty.png", "");
    t.expect_checker("empty.png", "");
    std::string corrupt = png;
    for (std::size_t i = 40; i < corrupt.size() - 12; ++i) corrupt[i] = char(~corrupt[i]);
    t.folder.write("corrupt.png", corrupt);
    t.expect_checker("corrupt.png", "");
    const Result<Bytes> deep = encode_png(Image16(2, 2, 3, 1000));
    ASSERT_TRUE(deep);
    t.folder.write("deep.png", std::string(reinterpret_cast<const char*>(deep->data()), deep->size()));
    t.expect_checker("deep.png", "16 bits a channel; 8 are expected");
    t.folder.write("float.pfm", "PF\n1 1\n-1.0\n" + std::string(12, '\0'));
    t.expect_checker("float.pfm", "floats; 8 bits a channel are expected");
}

TEST(ObjTextures, ABombAndAnEmptyPictureAreRefusedByTheirHeader) {
    const Textured t;
    std::string png = bytes_of(small_image);
    const auto with_size = [&](std::uint32_t width, std::uint32_t height) {
        std::string changed = png;
        for (int i = 0; i < 4; ++i) {
            changed[16 + std::size_t(i)] = char(width >> (24 - 8 * i));
            changed[20 + std::size_t(i)] = char(height >> (24 - 8 * i));
        }
        return changed;
    };
    t.folder.write("bomb.png", with_size(65535, 65535));
    t.expect_checker("bomb.png", "");
    t.folder.write("zero.png", with_size(0, 5));
    t.expect_checker("zero.png", "");
    t.folder.write("ppm.ppm", "P6\n60000 60000\n255\n");
    t.expect_checker("ppm.ppm", "");
}

TEST(ObjTextures, AllTogetherStayBelowTheLimit) {
    const Textured t;
    t.folder.write("a.png", bytes_of(Image8(10, 10, 3, 9)));
    ObjOptions options;
    options.max_texture_bytes = 300;
    EXPECT_THAT(t.load("a.png", options).warnings(),
                ElementsAre(HasSubstr("a.png': 10x10 pixels: more than 75 in all")));
    options.load_textures = false;
    const Loaded l = t.load("a.png", options);
    EXPECT_THAT(l.warnings(), IsEmpty());
    EXPECT_EQ(l.model->materials[0].diffuse_texture, -1);
    EXPECT_TRUE(l.model->textures.empty());
}

TEST(ObjTextures, TheCheckerIsMagentaAndBlackByTurns) {
    const Image8 checker = missing_texture();
    EXPECT_EQ(checker.width, 8);
    EXPECT_EQ(checker.height, 8);
    ASSERT_EQ(checker.channels, 3);
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 8; ++x) {
            const std::uint8_t expected = (x + y) % 2 == 0 ? 255 : 0;
            EXPECT_EQ(checker.pixel(x, y)[0], expected);
            EXPECT_EQ(checker.pixel(x, y)[1], 0);
            EXPECT_EQ(checker.pixel(x, y)[2], expected);
        }
    }
}

}  // namespace
}  // namespace raster

// scene_obj_texture_test.cpp: textures, and what stands in for those that cannot be used.
#include <sys/stat.h>

#include <raster/image/png.h>
#include <raster/testing/matchers.h>

#include "scene_obj_testing.h"

namespace raster {
namespace {

using ::testing::ElementsAre;
using testing::expect_sound;
using testing::Folder;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::load;
using testing::Loaded;
using testing::strict;

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

std::string bytes_of(const Image8& image) {
    const Result<Bytes> png = encode_png(image);
    return png ? std::string(reinterpret_cast<const char*>(png->data()), png->size()) : "";
}

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
    // Three of 300 bytes leave 100, which may be 25 pixels.
    for (const char* name : {"b.png", "c.png", "d.png"}) t.folder.write(name, bytes_of(Image8(10, 10, 3, 9)));
    options.max_texture_bytes = 1000;
    EXPECT_THAT(t.load("a.png\nmap_Ka b.png\nmap_Ks c.png\nmap_Ke d.png", options).warnings(),
                ElementsAre(HasSubstr("m.mtl:5: texture 'd.png': 10x10 pixels: more than 25 in all")));
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

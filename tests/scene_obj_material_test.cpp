// scene_obj_material_test.cpp: MTL files to materials, and materials to the faces that name them.
#include <raster/scene/obj_material.h>

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

/// The materials of an MTL text, by the whole way.
Loaded with_mtl(const std::string& mtl, const ObjOptions& options = {}) {
    const Folder folder;
    folder.write("m.mtl", mtl);
    return load(folder.write("m.obj", "mtllib m.mtl\n" + triangle + "usemtl a\nf 1 2 3\n"), options);
}

// ------------------------------------------------------------------------------------------- statements

TEST(Mtl, EveryKeyThatIsUsed) {
    const Loaded l = with_mtl(
        "newmtl a\nKa 0.1 0.2 0.3\nKd 0.4 0.5 0.6\nKs 0.7 0.8 0.9\nKe 1 2 3\nNs 99.5\nNi 1.45\nd 0.25\nillum 3\n"
        "Pr 0.5\nPm 1\nPs 0.125\nPc 0.25\nPcr 0.75\naniso 0.5\nanisor 0.0625\n");
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
    EXPECT_EQ(m.clearcoat, 0.25f);
    EXPECT_EQ(m.clearcoat_roughness, 0.75f);
    EXPECT_EQ(m.anisotropy, 0.5f);
    EXPECT_EQ(m.anisotropy_rotation, 0.0625f);
    EXPECT_TRUE(m.physically_based);
    EXPECT_EQ(l.model->parts[0].material, 0);
}

TEST(Mtl, WhatIsNotGivenHasTheDefault) {
    const Material m = with_mtl("newmtl a\n").model->materials[0], d;
    EXPECT_EQ(m.diffuse, d.diffuse);
    EXPECT_EQ(m.shininess, d.shininess);
    EXPECT_EQ(m.alpha, 1.0f);
    EXPECT_EQ(m.diffuse_texture, -1);
    EXPECT_FALSE(m.physically_based);
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

}  // namespace
}  // namespace raster

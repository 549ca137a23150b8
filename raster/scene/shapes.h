// shapes.h: models made by formula: solids, surfaces of revolution, the Utah teapot, the Cornell box.
//
// All have unit normals, texture coordinates in [0, 1] that are not mirrored (u to the right and v up, seen
// from the front), triangles counter-clockwise seen from the front (outside), white vertex colours and one
// named part unless said otherwise. y is up. Counts outside their range are brought into it. The floats are
// the same on every machine.
#pragma once

#include <span>
#include <vector>

#include <glm/glm.hpp>

#include <raster/scene/camera.h>
#include <raster/scene/model.h>

namespace raster {

/// The box between two corners: 6 faces with normals of their own, each of divisions x divisions quads, 1 to 256, the
/// whole texture on each face.
Model box(const glm::vec3& low, const glm::vec3& high, int divisions = 1);
/// The box from -1 to 1: side 2, as the box of the benchmark scenes.
Model cube();
/// The regular tetrahedron on four corners of the cube from -1 to 1, with flat faces.
Model tetrahedron();
/// The square from -1 to 1 in x and z at y = 0, facing up, as divisions x divisions quads; 1 to 1024.
Model plane(int divisions = 8);

/// A point of a profile: distance from the y axis and height, and the normal in the same terms. Two points at
/// one place with different normals make a sharp edge.
struct ProfilePoint {
    glm::dvec2 position;
    glm::dvec2 normal;
};
/// Points with the normals of a smooth curve through them: the outside is on the right, walking from first to
/// last, so outlines go from the bottom up. A profile that ends where it began is taken as closed. The normal
/// of a point is the mean of those of the lines beside it; a point given twice is a sharp edge. Fewer than 2
/// points give none.
std::vector<ProfilePoint> smooth_profile(std::span<const glm::dvec2> points);
/// The profile turned around the y axis in `segments` steps, 3 to 1024. u goes once round, from -z by -x, +z
/// and +x; v goes from the first point of the profile to the last, by index. A point on the axis becomes a
/// pole.
Model surface_of_revolution(std::span<const ProfilePoint> profile, int segments);

/// A curve through points (Catmull and Rom, A class of local interpolating splines, 1974), `steps` pieces from each to
/// the next, 1 to 64; 1 is the points themselves. A point given twice stays a sharp corner.
std::vector<glm::dvec2> curve_through(std::span<const glm::dvec2> points, int steps);
/// A vase with a wall, 2.4 high on y = 0, closed at its bottom: a surface of revolution with `steps` bands between each
/// two points of its outline, 1 to 64.
Model vase(int segments = 96, int steps = 8);
/// A closed cylinder of radius 1 around the y axis, from y = -1 to 1, with sharp edges.
Model cylinder(int segments = 96);

/// Radius 1 around the origin; 3 to 1024 meridians and 2 to 1024 parallels' bands. The normals are exact.
Model sphere(int segments = 48, int rings = 24);
/// Radius 1 around the origin, from an icosahedron whose every edge is cut into `divisions` pieces, 1 to 256: 20
/// divisions^2 triangles of much the same size. The normals are exact. Texture coordinates are those of sphere(); the
/// triangles across the seam go on to 1.1.
Model icosphere(int divisions = 8);
/// A ring of radius 1 around the y axis with a tube of the given radius, above 0 and below 1; normals are
/// exact.
Model torus(float tube_radius = 0.4f, int segments = 64, int sides = 32);
/// The lower half of a sphere of radius 1 without a lid: a sheet whose front is outside, so that one looks at
/// back faces inside. It tells two-sided lighting from one-sided.
Model bowl(int segments = 48, int rings = 12);

/// The Utah teapot (Newell 1975): 32 bicubic Bezier patches, each as subdivisions x subdivisions quads, 1 to
/// 256; 64 n^2 - 8 n triangles. From 2 on it has all its shape; 1 leaves handle and spout flat. Exact
/// normals, also at the two poles. Parts: rim, body, handle, spout, lid, bottom. The spout points to +x and y
/// is up: the box is (-3, 0, -2) to (3.434, 3.15, 2), at a coarse subdivision a little less at the spout. It
/// is not a closed surface: six loops are open, inside the rim, under the lid and at both ends of handle and
/// spout. Each patch has the whole texture.
Model teapot(int subdivisions = 10);

/// The Cornell box as measured (Cornell University Program of Computer Graphics, "Cornell Box Data"), in
/// millimetres: x to the left, y up, z away from the viewer, open at z = 0. Parts floor, ceiling (with the
/// hole for the light), light, back_wall, right_wall, left_wall, short_block, tall_block; materials white,
/// red, green, light. All faces look into the room; the blocks have no underside. The colours are linear RGB
/// for the measured spectra.
Model cornell_box();
/// The camera of the measurements: 800 mm in front of the opening, a square picture of 39.3 degrees.
Camera cornell_camera();

/// Three long triangles, each partly in front of the next, round in a circle: no order of painting is right
/// (the counterexample to the painter's algorithm; Newell, Newell and Sancha 1972). They face +z. Parts and
/// materials blue, orange and white.
Model cyclic_trio();

}  // namespace raster

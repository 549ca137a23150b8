# physical.sh: reflectance by physics, in the order of the lectures. Sourced by gallery.sh, after figures.sh.

curve fresnel fresnel
figure R1 "Fresnel: how much a smooth boundary reflects" \
    "For a dielectric, Snell's law n1 sin(theta1) = n2 sin(theta2) gives the angle inside and Fresnel's equations the part that is reflected: 4 % of the light that meets glass head on, all of it at 90 degrees. From inside, everything beyond the critical angle of 41.8 degrees comes back. A conductor's index is complex, n + ik, and differs between the colours: that is the colour of gold and copper, which fades to white at grazing angles."
plot fresnel_dielectric "Glass, n = 1.5" <<GNUPLOT
set key top left
set xlabel 'angle of incidence, degrees'; set ylabel 'reflectance'
plot [0:90] [0:1.02] '$data/fresnel' using 1:2 lc rgb '#1f4e9c' lw 2 title 'from air into glass', \
    '' using 1:3 lc rgb '#d95f02' lw 2 dt 2 title 'from glass into air'
GNUPLOT
plot fresnel_conductor "Gold, copper and aluminium, each at 650, 550 and 450 nm" <<GNUPLOT
set xlabel 'angle of incidence, degrees'; set ylabel 'reflectance'
set key bottom left maxrows 3 font ',10' samplen 1.5 width -1
plot [0:90] [0.2:1.02] '$data/fresnel' using 1:4 lc rgb '#c00000' lw 2 title 'gold, red', \
    '' using 1:5 lc rgb '#008000' lw 2 title 'gold, green', '' using 1:6 lc rgb '#0000c0' lw 2 title 'gold, blue', \
    '' using 1:7 lc rgb '#c00000' lw 2 dt 2 title 'copper, red', '' using 1:8 lc rgb '#008000' lw 2 dt 2 title 'copper, green', \
    '' using 1:9 lc rgb '#0000c0' lw 2 dt 2 title 'copper, blue', \
    '' using 1:10 lc rgb '#c00000' dt 3 lw 2 title 'aluminium, red', '' using 1:11 lc rgb '#008000' dt 3 lw 2 title 'aluminium, green', \
    '' using 1:12 lc rgb '#0000c0' dt 3 lw 2 title 'aluminium, blue'
GNUPLOT

curve lobes lobes 65 phong:shininess=20 blinn-phong:shininess=80 glazed-clay:roughness=0.3
figure R3 "Torrance-Sparrow: the highlight at grazing angles" \
    "Real highlights do not follow Phong: they are dull where one looks straight at a surface and bright at grazing angles, and there they peak beyond the mirror direction. Mirrors in grooves explain it: F G D / (4 (n l)(n v))."
picture grazing_front 450x240 "Light from the front: Phong left, Torrance and Sparrow right" $scenes/grazing.json --light directional:dir=-0.5,-0.6,-1
picture grazing 450x240 "The same two with the light behind them" $scenes/grazing.json
plot lobes_grazing "The light comes from 65 degrees; the mirror direction is at 65 on the right" <<GNUPLOT
set xlabel 'angle of the viewer, degrees'; set ylabel 'reflectance times cos(theta)'; set key top left
plot [-90:90] '$data/lobes' using 1:2 lc rgb '#999999' lw 2 title 'Phong, n = 20', \
    '' using 1:3 lc rgb '#1f4e9c' lw 2 dt 2 title 'Blinn-Phong, n = 80', \
    '' using 1:4 lc rgb '#d95f02' lw 2 title 'Torrance-Sparrow, m = 0.3'
GNUPLOT

curve distributions lobes 40 cook-torrance:roughness=0.25 cook-torrance-gaussian:roughness=0.25 cook-torrance:roughness=0.5 \
    cook-torrance-gaussian:roughness=0.5
figure R4 "Cook-Torrance: metals and plastics" \
    "kd / pi + ks F G D / (4 pi (n l)(n v)) with Beckmann's distribution of slopes m. A pure conductor has kd = 0 and ks = 1, so that all its colour comes of Fresnel's equations with the measured index of each metal. A dielectric shares its light between the two, kd + ks = 1: of this plastic kd is 0.4 times its colour, (1, 0.15, 0.075), and ks 0.6. Its index is 1.5 in all channels, so that its highlight has the light's colour, not its own; the copper's has its own."
picture metal_vases 800x260 "Gold, silver, copper, aluminium, iron" $scenes/metal_vases.json
picture plastic_vase 480x300 "Plastic, kd = 0.4 and ks = 0.6, beside copper, kd = 0 and ks = 1" $scenes/plastic_vase.json
picture copper_vases 900x260 "Copper, m = 0.1, 0.2 ... 0.6" $scenes/copper_vases.json
plot distributions "The two distributions of facets, nearly alike while m is small; light from 40 degrees" <<GNUPLOT
set xlabel 'angle of the viewer, degrees'; set ylabel 'reflectance times cos(theta)'; set key top left
plot [-90:90] '$data/distributions' using 1:2 lc rgb '#1f4e9c' lw 2 title 'Beckmann, m = 0.25', \
    '' using 1:3 lc rgb '#d95f02' lw 2 dt 2 title 'Gaussian, m = 0.25', \
    '' using 1:4 lc rgb '#1f4e9c' lw 1 title 'Beckmann, m = 0.5', '' using 1:5 lc rgb '#d95f02' lw 1 dt 2 title 'Gaussian, m = 0.5'
GNUPLOT

row_of 200 $scenes/clay_vases.json --camera-focal-point -1.1,0.95,0 --camera-position -1.1,0.95,16 --camera-view-angle 7 >"$data/lambert"
row_of 200 $scenes/clay_vases.json --camera-focal-point 1.1,0.95,0 --camera-position 1.1,0.95,16 --camera-view-angle 7 >"$data/oren_nayar"
figure R5 "Oren-Nayar: clay" \
    "By Lambert's law a vase that is lit from the viewer darkens towards its outline. A clay vase does not: its roughness has facets that face the light even there. Oren and Nayar's model is nearly flat across the vase, as the photographs are."
picture clay_vases 480x300 "Lambert left, Oren-Nayar with sigma = 0.5 right" $scenes/clay_vases.json
from+="; for the left vase with -1.1 instead of 1.1"
plot clay_curve "The light across the widest part of both vases" <<GNUPLOT
set xlabel 'pixel'; set ylabel 'radiance, red channel'; set key bottom center
plot [30:370] '$data/lambert' using 1:2 lc rgb '#1f4e9c' lw 2 dt 2 title 'Lambert', \
    '$data/oren_nayar' using 1:2 lc rgb '#d95f02' lw 2 title 'Oren-Nayar'
GNUPLOT

figure R6 "He-Torrance: from a mirror to matt" \
    "The model of 1991 has no coefficients to choose: the height and the correlation length of the roughness give a mirror part, a directional diffuse part (diffraction) and a uniform diffuse part. The rougher the aluminium, the wider the reflection of the light from behind; at grazing angles even rough metal is a mirror again."
picture he_torrance 900x220 "Facet slope 0.05, 0.1, 0.2, 0.3, 0.4" $scenes/he_torrance.json

figure R7 "Anisotropy: brushed metal, satin, velvet" \
    "Where a surface has a grain, its highlight turns with it. Each pair is one cylinder, upright and turned by 90 degrees under the same light, with a grain that runs along its axis: the highlight is long across the grain, whichever way the cylinder lies. MTL's anisor turns the grain on the surface. Velvet has upright fibres and is bright at its outline from all sides."
picture cylinders 960x210 "Brushed aluminium, satin, velvet: upright and turned" $scenes/cylinders.json
picture grain 640x190 "The same cylinder with its grain turned by 0, 45, 90 and 135 degrees" $scenes/grain.json

figure MTL "Layers: varnish and fibres" \
    "Many surfaces are two: paint below varnish, cloth with fine fibres that stand off. A layer reflects first, and what is below it gets the rest, once on the way in and once on the way out: varnished clay is darker where the varnish mirrors, most of all at the outline. Varnish is colourless, so that its highlight on copper is white; fibres glow where one looks along the surface. These are the keys Pc, Pcr and Ps of MTL files."
picture layers 960x190 "Red clay: bare, under smooth and rough varnish, under fibres; rough copper: bare, under varnish" $scenes/layers.json

figure R8 "Measured surfaces: tables" \
    "Who does not trust a formula measures: a table has what a surface reflects for 90 half angles, 90 difference angles and 180 of their azimuths, times three colours, 4,374,000 numbers. The public MERL database has a hundred such files of real nickel, paint and felt; they are not in this tree, so the tables here are baked, in the same layout, of models that look like three of them, and read back as a downloaded file would be. The curves are what the tables give (points) beside the models that they were made of (lines), light from 45 degrees."
table nickel.binary iron:roughness=0.18
picture measured_nickel 300x225 "Like nickel: a metal's highlight" models/teapot.obj --material "brdf=$data/nickel.binary"
table paint.binary plastic:diffuse=0.55,0.42,0.05:roughness=0.25
picture measured_paint 300x225 "Like gold paint: colour below, a highlight above" models/teapot.obj --material "brdf=$data/paint.binary"
table felt.binary velvet:diffuse=0.45,0.12,0.2:specular=0.35,0.25,0.3:roughness=0.7
picture measured_felt 300x225 "Like pink felt: fibres" models/teapot.obj --material "brdf=$data/felt.binary"
before=
curve tables lobes 45 iron:roughness=0.18 plastic:diffuse=0.55,0.42,0.05:roughness=0.25 \
    velvet:diffuse=0.45,0.12,0.2:specular=0.35,0.25,0.3:roughness=0.7 \
    "brdf=$data/nickel.binary" "brdf=$data/paint.binary" "brdf=$data/felt.binary"
plot measured_curve "Table against model, light from 45 degrees, red" <<GNUPLOT
set xlabel 'angle of the viewer, degrees'; set ylabel 'reflectance times cos(theta)'; set key top left
set logscale y
plot [-90:90] [0.005:30] '$data/tables' using 1:2 lc rgb '#666666' lw 1.5 title 'nickel: model', \
    '' using 1:3 lc rgb '#d9a400' lw 1.5 title 'paint: model', '' using 1:4 lc rgb '#c0408a' lw 1.5 title 'felt: model', \
    '' using 1:5 every 4 with points pt 7 ps 0.4 lc rgb '#666666' title 'tables', \
    '' using 1:6 every 4 with points pt 7 ps 0.4 lc rgb '#d9a400' notitle, \
    '' using 1:7 every 4 with points pt 7 ps 0.4 lc rgb '#c0408a' notitle
GNUPLOT

set_of=(plastic:diffuse=0.1,0.3,0.6:roughness=0.15 plastic:roughness=0.1 plastic:diffuse=0.05,0.4,0.1:roughness=0.3
    rubber paper:diffuse=0.8 clay plaster moon glazed-clay gold copper silver:roughness=0.2 iron velvet marble skin)
figure R9 "Measured surfaces: principal components" \
    "Tables are too large to be kept and all too much alike to need it. The 16 of this set (plastics, metals, matt things, velvet, marble, skin) span a space whose principal components are found by Eigen, in the logarithm of reflectance; a table becomes its share of each component. The first of the set, blue plastic, from 1, 2, 4 and 8 of the 15 components and as it is: with few the highlight is a compromise of all the set. The error is counted in reflectance and the components in its logarithm, so that it falls on the whole but not with each."
: >"$data/components"
for k in 0 1 2 3 4 5 6 8 10 12 15; do
    table few.binary "${set_of[@]}" --table-size 60x60x60 --components $k
    echo "$k $said" | sed 's/ [^ ]*few.binary.* components with / /; s/ of the variance, relative error / /' >>"$data/components"
    case $k in
        1 | 2 | 4 | 8)
            picture components_$k 240x180 "k = $k" models/teapot.obj --material "brdf=$data/few.binary"
            ;;
    esac
done
table whole.binary "${set_of[0]}" --table-size 60x60x60
picture components_all 240x180 "The table" models/teapot.obj --material "brdf=$data/whole.binary"
before=
from="raster brdf ${set_of[*]} --table-size 60x60x60 --components K -o few.binary, for each K"
plot components_curve "The variance of the set that k components keep, and the error of the first table" <<GNUPLOT
set xlabel 'components'; set ylabel 'part'; set key center right
plot [0:15] [0:*] '$data/components' using 1:2 with linespoints pt 7 ps 0.5 lc rgb '#1f4e9c' lw 2 title 'variance kept', \
    '' using 1:3 with linespoints pt 7 ps 0.5 lc rgb '#d95f02' lw 2 title 'relative error'
GNUPLOT

figure R10 "Light below the surface" \
    "Marble and skin let light in, which comes out again elsewhere. Jensen's BSSRDF, taken as a BRDF under even light, is F Rd / pi plus single scattering: it softens the terminator and whitens the outline. What a BRDF cannot show is light that leaves at another place than where it came in. The dipole of the paper says how much does at each distance, and summed over all of a sphere's surface it shows what is left out: light creeps beyond the terminator, red farther than blue (the dipole is that of a flat half space, and near the truth on a sphere that is large beside the light's way). On a plane half of which is lit the BRDF has a step at the edge, the BSSRDF a slope some millimetres wide."
picture translucent 720x370 "Marble, skin, milk, ketchup; below them the same colours by Lambert" $scenes/translucent.json
"$bssrdf" spheres >"$data/spheres.obj"
before="raster_bssrdf spheres >spheres.obj"
picture bssrdf 720x200 "Spheres of 20 mm, lit from the left: marble by its BRDF and by its BSSRDF, skin by its BRDF and by its BSSRDF" "$data/spheres.obj" --material color=1:specular=0 --light ambient:color=1 --display srgb --background 0.1 --camera-position 0,0,30 --camera-focal-point 0,0,0 --camera-view-angle 4.7
before=
"$bssrdf" edge >"$data/edge"
from="raster_bssrdf edge"
plot bssrdf_edge "What leaves a plane that is lit on the left of 0, over what arrives" <<GNUPLOT
set xlabel 'mm'; set ylabel 'radiosity over irradiance'; set key top right
plot [-8:8] [0:1] '$data/edge' using 1:8 lc rgb '#999999' lw 1.5 dt 2 title 'marble, BRDF, green', \
    '' using 1:2 lc rgb '#c00000' lw 2 title 'marble, red', '' using 1:3 lc rgb '#008000' lw 2 title 'green', \
    '' using 1:4 lc rgb '#0000c0' lw 2 title 'blue', '' using 1:9 lc rgb '#999999' lw 1.5 dt 3 title 'skin, BRDF, green', \
    '' using 1:5 lc rgb '#c00000' lw 1.5 dt 4 title 'skin, red', '' using 1:6 lc rgb '#008000' lw 1.5 dt 4 title 'green', \
    '' using 1:7 lc rgb '#0000c0' lw 1.5 dt 4 title 'blue'
GNUPLOT

# physical.sh: reflectance by physics, in the order of the lectures. Sourced by gallery.sh, after figures.sh.

"$curves" fresnel >"$data/fresnel"
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

"$curves" lobes 65 phong:20 blinn-phong:80 glazed-clay:0.3 >"$data/lobes"
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

figure R4 "Cook-Torrance: metals" \
    "kd / pi + ks F G D / (4 pi (n l)(n v)) with Beckmann's distribution of slopes m. A pure conductor has kd = 0 and ks = 1, so that all its colour comes of Fresnel's equations with the measured index of each metal."
picture metal_vases 800x260 "Gold, silver, copper, aluminium, iron" $scenes/metal_vases.json
picture copper_vases 900x260 "Copper, m = 0.1, 0.2 ... 0.6" $scenes/copper_vases.json

row_of 200 $scenes/clay_vases.json --camera-focal-point -1.1,0.95,0 --camera-position -1.1,0.95,16 --camera-view-angle 7 >"$data/lambert"
row_of 200 $scenes/clay_vases.json --camera-focal-point 1.1,0.95,0 --camera-position 1.1,0.95,16 --camera-view-angle 7 >"$data/oren_nayar"
figure R5 "Oren-Nayar: clay" \
    "By Lambert's law a vase that is lit from the viewer darkens towards its outline. A clay vase does not: its roughness has facets that face the light even there. Oren and Nayar's model is nearly flat across the vase, as the photographs are."
picture clay_vases 480x300 "Lambert left, Oren-Nayar with sigma = 0.5 right" $scenes/clay_vases.json
plot clay_curve "The light across the widest part of both vases" <<GNUPLOT
set xlabel 'pixel'; set ylabel 'radiance, red channel'; set key bottom center
plot [30:370] '$data/lambert' using 1:2 lc rgb '#1f4e9c' lw 2 dt 2 title 'Lambert', \
    '$data/oren_nayar' using 1:2 lc rgb '#d95f02' lw 2 title 'Oren-Nayar'
GNUPLOT

figure R6 "He-Torrance: from a mirror to matt" \
    "The model of 1991 has no coefficients to choose: the height and the correlation length of the roughness give a mirror part, a directional diffuse part (diffraction) and a uniform diffuse part. The rougher the aluminium, the wider the reflection of the light from behind; at grazing angles even rough metal is a mirror again."
picture he_torrance 900x220 "Facet slope 0.05, 0.1, 0.2, 0.3, 0.4" $scenes/he_torrance.json

figure R7 "Anisotropy: brushed metal, satin, velvet" \
    "Where a surface has a grain, its highlight turns with it. Each pair is one cylinder, upright and turned by 90 degrees under the same light; the grain runs upwards in both. Velvet has upright fibres and is bright at its outline from all sides."
picture cylinders 960x210 "Brushed aluminium, satin, velvet: upright and turned" $scenes/cylinders.json

figure R10 "Light below the surface" \
    "Marble and skin let light in, which comes out again elsewhere. Jensen's BSSRDF, taken as a BRDF under even light, is F Rd / pi plus single scattering: it softens the terminator and whitens the outline. What a BRDF cannot show, light that leaves at another place than where it came in, is missing: shadows do not bleed and thin parts do not glow."
picture translucent 720x370 "Marble, skin, milk, ketchup; below them the same colours by Lambert" $scenes/translucent.json

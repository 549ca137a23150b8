# figures.sh: lights, materials and shading by the empirical models, in the order of the lectures. Sourced by gallery.sh,
# which has the functions.
scenes=demos/scenes
sun=(--light directional:dir=-0.5,-0.6,-1)
ball=(shape:sphere --reflectance phong "${sun[@]}")

# ---- light and material, by the empirical models

figure L1 "Diffuse reflection: Lambert" \
    "A matt surface looks equally bright from every side; it is I kd (n l), and kd is how much of the light it gives back."
picture diffuse_row 720x260 "kd = 0.3, 0.6 and 0.9" $scenes/diffuse_row.json

figure L2 "Specular reflection: Phong" \
    "The highlight is I ks (r v)^n: ks says how strong it is and n how small. It is where the viewer looks along the mirrored ray of light, r."
picture phong_5 360x270 "Exponent 5" models/teapot.obj --reflectance phong --material color=0.6,0.2,0.1:specular=0.5:shininess=5
picture phong_50 360x270 "Exponent 50" models/teapot.obj --reflectance phong --material color=0.6,0.2,0.1:specular=0.5:shininess=50
picture phong_grid 600x600 "n = 1, 20, 200 from left to right; ks = 0.1, 0.25, 0.5 from top to bottom" $scenes/phong_grid.json

figure L3 "Phong beside Blinn-Phong" \
    "Blinn takes the half vector h between light and viewer: (n h)^n. It turns half as fast as r, so that the same exponent gives a wider highlight, and an exponent four times as large gives about Phong's; the courses that divide by 4 have this in mind. With the light behind the viewer, r and v can be more than 90 degrees apart while n and h are not: there Phong's highlight ends, and Blinn's goes on."
picture phong_30 300x300 "Phong, n = 30" "${ball[@]}" --material color=0.1,0.3,0.6:specular=0.5:shininess=30
picture blinn_30 300x300 "Blinn-Phong, n = 30" shape:sphere --reflectance blinn-phong "${sun[@]}" --material color=0.1,0.3,0.6:specular=0.5:shininess=30
picture blinn_quarter 300x300 "Blinn-Phong with (n h)^(alpha/4), alpha = 120" shape:sphere --reflectance blinn-phong-quarter "${sun[@]}" --material color=0.1,0.3,0.6:specular=0.5:shininess=120
picture blinn_120 300x300 "Blinn-Phong, n = 120" shape:sphere --reflectance blinn-phong "${sun[@]}" --material color=0.1,0.3,0.6:specular=0.5:shininess=120
low=(shape:sphere --light directional:dir=-Z:space=eye --material color=0:specular=1:shininess=1)
picture low_phong 450x300 "The light at the viewer's back, kd = 0, ks = 1, n = 1: Phong's highlight ends where r and v are 90 degrees apart" "${low[@]}" --reflectance phong
picture low_blinn 450x300 "Blinn-Phong's goes on to the outline" "${low[@]}" --reflectance blinn-phong

figure L4 "Ambient light and emission" \
    "What no light reaches is black, which looks unnatural; a constant glow Ia ka from everywhere stands in for all light that is reflected to and fro. Alone it shows outlines only. Emission Ie is added in the same way: a glowing thing is bright itself, but in a local model it lights nothing else."
picture ambient_only 300x225 "Ambient light alone" models/teapot.obj --light ambient:color=0.4
picture ambient_without 300x225 "Without ambient light" models/teapot.obj "${sun[@]}"
picture ambient_with 300x225 "With Ia = 0.2" models/teapot.obj "${sun[@]}" --light ambient:color=0.2
for ia in 0 0.1 0.3; do
    picture ambient_$ia 720x260 "Ia = $ia; kd = 0.3, 0.6, 0.9" $scenes/diffuse_row.json "${sun[@]}" --light ambient:color=$ia
done
picture emission 480x300 "The left sphere glows; its neighbour does not notice" $scenes/emission.json

white=(--material color=1:specular=0)
green=(--material color=0,1,0:specular=0)
red_light=(--light directional:dir=-Z:space=eye:color=1,0,0)
figure L5 "Colours of light: three questions" \
    "Each channel is for itself, light times material. If you shine red light (1,0,0) on a diffuse white object, what colour does it have? Red: the pixel in its middle is ($(color_at 50 50 shape:sphere --reflectance phong "${red_light[@]}" "${white[@]}")). And on a green object (0,1,0)? Black, ($(color_at 50 50 shape:sphere --reflectance phong "${red_light[@]}" "${green[@]}")): there is nothing that it could reflect. If the object is shiny, what colour is the highlight? The light's: here, on the green sphere, ($(color_at 50 50 shape:sphere --reflectance phong "${red_light[@]}" --material color=0,1,0:specular=0.8:shininess=20)). What colour is a mirror? None of its own, kd = 0 and ks = 1 in all channels: it has the colour of what it reflects, and in a local model that is the lights alone. Several lights add up, and what is above 1 is shown as 1: red and green light together are yellow."
question=(shape:sphere --reflectance phong --background 0.1)
picture red_on_white 240x240 "Red light on white" "${question[@]}" --light directional:dir=-0.5,-0.6,-1:color=1,0,0 "${white[@]}"
picture red_on_green 240x240 "Red light on green: black" "${question[@]}" --light directional:dir=-0.5,-0.6,-1:color=1,0,0 "${green[@]}"
picture red_on_shiny 240x240 "Red light on shiny green" "${question[@]}" --light directional:dir=-0.5,-0.6,-1:color=1,0,0 --material color=0,1,0:specular=0.8:shininess=20
picture white_on_shiny 240x240 "White light on shiny green" "${question[@]}" "${sun[@]}" --material color=0,0.6,0:specular=0.8:shininess=20
picture mirror 240x240 "A mirror under a red, a green and a blue light" "${question[@]}" --light directional:dir=-0.6,-0.3,-1:color=1,0,0 --light directional:dir=0.6,-0.3,-1:color=0,1,0 --light directional:dir=0,0.6,-1:color=0.1,0.3,1 --material color=0:specular=1:shininess=60
picture lights_add 240x240 "Red and green light add up to yellow" "${question[@]}" --light directional:dir=-0.7,-0.3,-1:color=1,0,0 --light directional:dir=0.7,-0.3,-1:color=0,1,0 --material color=1:specular=0

figure L6 "Behind the surface: clamp or turn the normal" \
    "Where n l is below 0 the light is behind the surface, and the term is clamped to 0. Whoever looks into an open bowl sees back faces, whose normals point away: either they stay as dark as that says, or the normal is turned to the viewer first."
picture bowl_two_sided 360x270 "The normal is turned" shape:bowl "${sun[@]}" --light ambient:color=0.08 --camera-elevation-angle 20 --cull none --two-sided
picture bowl_one_sided 360x270 "The normal stays" shape:bowl "${sun[@]}" --light ambient:color=0.08 --camera-elevation-angle 20 --cull none --no-two-sided

figure L7 "Attenuation" \
    "Two parallel planes of one material that face one light are nearly one grey: nothing says which is nearer. With f = min(1/(c1 + c2 d + c3 d^2), 1) for the distance d from the light, the farther one is darker."
picture planes_alike 360x270 "A point light at the eye: no attenuation" $scenes/two_planes.json --light point:pos=0,0,7
picture planes_apart 360x270 "The same light, c = (0, 0.14, 0)" $scenes/two_planes.json --light point:pos=0,0,7:decay=0,0.14,0

figure L8 "Kinds of light" \
    "Ambient light comes from everywhere. A point light sends it to all sides and may weaken with the distance. A directional one is so far away that its rays are parallel. A spot has a cone, and within it weakens with the angle from its axis."
picture light_ambient 450x300 "Ambient" $scenes/lights.json
picture light_point 450x300 "Point, weakened by 1/(0.5 + 0.1 d^2)" $scenes/lights.json --light point:pos=-1,3.5,2.5:decay=0.5,0,0.1:ambient=0.05:intensity=1.5
picture light_directional 450x300 "Directional" $scenes/lights.json --light directional:dir=-1,-1,-0.7:ambient=0.08
picture light_spot 450x300 "Spot, a cone of 22 degrees to each side" $scenes/lights.json --light spot:pos=0,6,4:dir=0,-5,-4:cutoff=22:ambient=0.05
picture light_spot_falloff 450x300 "Spot, weakened by cos^20 of the angle" $scenes/lights.json --light spot:pos=0,6,4:dir=0,-5,-4:cutoff=40:falloff=20:ambient=0.05
picture three_spheres 500x300 "Three spheres on a floor under one point light" $scenes/three_spheres.json

row_of 200 $scenes/irradiance.json >"$data/irradiance"
"$raster" render $scenes/irradiance.json -o "$data/flux.pfm" --quiet
flux=$(floats_of "$data/flux.pfm" | awk '{ sum += $1 } END { side = 40 * 0.24932800 / 401
    printf "%.1f", sum * 3.14159265 * side * side }')
figure L9 "Irradiance under a point light" \
    "A point source of the intensity I (watts per steradian) gives a surface the irradiance E = I cos(theta) / r^2 (watts per square metre). A white plane 2 m below a source of 4 W/sr, seen from above: a picture is radiance L (watts per square metre and steradian), and a Lambertian surface sends out the radiosity B = pi L. Of a white one that is E: pi L along the middle row, and the closed form. Of the radiant flux of 4 pi I = 50.3 W, what is seen of the plane, 9.97 m by 9.97 m, gets I times its solid angle: $flux W, added up over the pixels; 4 I atan(a^2 / (d sqrt(2 a^2 + d^2))) = 16.6 W by the closed form."
picture irradiance 300x300 "The plane from above" $scenes/irradiance.json
plot irradiance_curve "pi L along the middle row, and I cos(theta) / r^2" <<GNUPLOT
set xlabel 'distance from the foot of the light, m'; set ylabel 'E, W/m^2'
half = 20 * tan(14 * pi / 180)
x(i) = (i - 200) / 200.5 * half
plot [-5:5] '$data/irradiance' every 5 using (x(\$1)):(pi * \$2) with points pt 7 ps 0.35 lc rgb '#d95f02' title 'rendered', \
    4 * 2 / (x**2 + 4)**1.5 lc rgb '#1f4e9c' lw 1.5 title '4 cos(theta) / r^2'
GNUPLOT

figure L10 "The display" \
    "Light is linear: twice the number is twice the light. A screen is not: byte 128 is about a fifth of the light of 255. Stored plainly, equal steps of light look unequal, and middle tones come out too dark; encoded by sRGB's transfer function they are what they should be. The lectures' empirical models are shown plainly, as the lectures do; what is physical is encoded. Exposure doubles the light before."
picture ramp_plain 640x80 "Equal steps of light, stored plainly" $scenes/ramp.json --display plain
picture ramp_srgb 640x80 "The same, encoded for the screen" $scenes/ramp.json --display srgb
picture display_plain 300x225 "The teapot, plainly" models/teapot.obj --display plain
picture display_srgb 300x225 "Encoded" models/teapot.obj --display srgb
picture display_exposure 300x225 "Encoded, one stop less" models/teapot.obj --display srgb --exposure -1

coarse=(shape:icosphere:divisions=3 --light directional:dir=-0.35,-0.45,-1 --light ambient:color=0.1
    --material color=0.1,0.3,0.6:specular=0.7:shininess=60 --reflectance phong)
figure S1 "Flat, Gouraud, Phong shading" \
    "The same light and the same 180 triangles. Flat shading lights each triangle once; Gouraud's lights its corners and interpolates the colours; Phong's interpolates the normals and lights every pixel. A highlight that falls between the corners is missed by the first two, and Gouraud's shows the triangles where it hits one."
picture shade_flat 300x300 "Flat" "${coarse[@]}" --shade flat
picture shade_gouraud 300x300 "Gouraud" "${coarse[@]}" --shade gouraud
picture shade_phong 300x300 "Phong" "${coarse[@]}" --shade phong
picture missed_gouraud 300x225 "One quad under a point light: Gouraud misses the highlight" shape:plane:divisions=1 --camera-elevation-angle 25 --light point:pos=0,0.6,0 --material color=0.2,0.3,0.5:specular=0.8:shininess=30 --shade gouraud
picture missed_phong 300x225 "Phong shows it" shape:plane:divisions=1 --camera-elevation-angle 25 --light point:pos=0,0.6,0 --material color=0.2,0.3,0.5:specular=0.8:shininess=30 --shade phong

// readme_check.cpp: whether the picture that README.md's triangle program wrote is the one it should write.
#include <cmath>
#include <cstdio>

#include <raster/image/decode.h>

namespace {

/// How far (px, py) is above the line from a to b, in square pixels; the picture's y goes down.
double side(double ax, double ay, double bx, double by, double px, double py) {
    return (px - ax) * (by - ay) - (py - ay) * (bx - ax);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    const raster::Result<raster::Image8> image = raster::load_image8(argv[1]);
    if (!image) {
        std::printf("%s\n", image.error().message.c_str());
        return 1;
    }
    if (image->width != 640 || image->height != 480 || image->channels != 4) {
        std::printf("%d x %d, %d channels\n", image->width, image->height, image->channels);
        return 1;
    }

    // The corners in the window: red, green and blue. Away from the edges each pixel is background or the mix of the
    // corners' colours by its barycentric coordinates.
    const double x[] = {64, 576, 320}, y[] = {408, 408, 72};
    const int background[] = {26, 26, 38, 255};
    const double area = side(x[0], y[0], x[1], y[1], x[2], y[2]);
    int wrong = 0, inside = 0, outside = 0;
    for (int row = 0; row < 480; ++row) {
        for (int column = 0; column < 640; ++column) {
            double weight[3];
            bool in = true, near_edge = false;
            for (int i = 0; i < 3; ++i) {
                const int a = (i + 1) % 3, b = (i + 2) % 3;
                weight[i] = side(x[a], y[a], x[b], y[b], column + 0.5, row + 0.5) / area;
                in = in && weight[i] > 0;
                near_edge = near_edge || std::abs(weight[i]) < 0.01;
            }
            if (near_edge) continue;
            ++(in ? inside : outside);
            const std::uint8_t* pixel = image->pixel(column, row);
            for (int channel = 0; channel < 4; ++channel) {
                const double expected = !in            ? background[channel]
                                        : channel == 3 ? 255.0
                                                       : 255.0 * weight[channel];
                wrong += std::abs(pixel[channel] - expected) > 1.0;
            }
        }
    }
    std::printf("%d pixels inside, %d outside, %d samples wrong\n", inside, outside, wrong);
    return wrong == 0 && inside > 80000 && outside > 200000 ? 0 : 1;
}

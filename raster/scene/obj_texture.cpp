// obj_texture.cpp: finding, decoding and replacing textures.
#include <raster/scene/obj_texture.h>

#include <raster/image/decode.h>

namespace raster {

Image8 missing_texture() {
    Image8 checker(8, 8, 3);
    for (int y = 0; y < checker.height; ++y)
        for (int x = 0; x < checker.width; ++x)
            if ((x + y) % 2 == 0) checker.pixel(x, y)[0] = checker.pixel(x, y)[2] = 255;
    return checker;
}

namespace obj {

void Textures::load(const MaterialEntry& entry, Material& material) {
    for (const TextureUse& use : entry.textures) {
        if (log_.failed()) return;
        material.*use.slot = load(use, entry);
    }
}

int Textures::load(const TextureUse& use, const MaterialEntry& entry) {
    // Beside the material file, else beside the model.
    Result<std::string> path = Error{ErrorKind::bad_input, "not opened"};
    if (finder_) {
        path = finder_->find(use.name, entry.folder);
        if (!path && entry.folder != finder_->folder())
            if (Result<std::string> other = finder_->find(use.name, finder_->folder())) path = other;
    }
    const std::string key = path ? *path : "\n" + entry.folder + "\n" + use.name;
    if (const auto found = known_.find(key); found != known_.end()) return found->second;

    Result<Image8> image = path ? read(*path) : Result<Image8>(path.error());
    if (!image) {
        log_.warn({entry.file, use.line},
                  "texture " + in_quotes(use.name) + ": " + image.error().message + "; a checker takes its place");
        image = missing_texture();
    }
    bytes_ += image->samples.size();
    const int index = int(model_.textures.size());
    model_.textures.push_back({use.name, std::move(*image)});
    known_.emplace(key, index);
    return index;
}

Result<Image8> Textures::read(const std::string& path) {
    ImageLimits limits = options_.texture_limits;
    const std::size_t left = options_.max_texture_bytes - std::min(bytes_, options_.max_texture_bytes);
    limits.max_pixels =
        std::min(limits.max_pixels, std::int64_t(std::min<std::uint64_t>(left, std::uint64_t(1) << 40)) / 4);
    Result<AnyImage> image = load_image(path, limits);
    if (!image) {
        // The sentence around it names the file already.
        std::string why = image.error().message;
        if (why.starts_with(path + ": ")) why.erase(0, path.size() + 2);
        return Error{ErrorKind::bad_input, why};
    }
    if (std::holds_alternative<Image16>(*image))
        return Error{ErrorKind::bad_input, "16 bits a channel; 8 are expected"};
    if (std::holds_alternative<ImageF>(*image))
        return Error{ErrorKind::bad_input, "floats; 8 bits a channel are expected"};
    return std::get<Image8>(std::move(*image));
}

}  // namespace obj
}  // namespace raster

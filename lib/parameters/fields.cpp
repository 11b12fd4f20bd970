#include "parameters/fields.hpp"

namespace delabole {

std::string joined_path(const std::string& path, std::string_view key) {
    return path + (path.empty() || key.empty() ? "" : ".") + std::string(key);
}

std::string indexed(const std::string& key, std::size_t index) {
    return key + "[" + std::to_string(index + 1) + "]";
}

}  // namespace delabole

#include "core/measure/mat/mat_hdf.hpp"

#include <hdf5.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace analogon::mat {

namespace {

/// What HDF5 gives and wants back.
class Handle {
public:
    Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
    ~Handle() {
        if (id_ >= 0) close_(id_);
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    operator hid_t() const { return id_; }

private:
    hid_t id_;
    herr_t (*close_)(hid_t);
};

std::string nameAt(hid_t root, hsize_t index) {
    std::array<char, 512> name{};
    const auto length =
        H5Lget_name_by_idx(root, ".", H5_INDEX_NAME, H5_ITER_INC, index, name.data(), name.size(), H5P_DEFAULT);
    return length > 0 && static_cast<std::size_t>(length) < name.size() ? std::string(name.data()) : std::string();
}

/// What MATLAB writes beside a variable; empty: nothing.
std::string classOf(hid_t object) {
    if (H5Aexists(object, "MATLAB_class") <= 0) return {};
    const Handle attribute(H5Aopen(object, "MATLAB_class", H5P_DEFAULT), H5Aclose);
    const Handle type(H5Aget_type(attribute), H5Tclose);
    const std::size_t size = H5Tget_size(type);
    std::array<char, 256> text{};
    if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) > 0 || size >= text.size()) return {};
    return H5Aread(attribute, type, text.data()) >= 0 ? std::string(text.data()) : std::string();
}

bool isPlain(std::string_view name) {
    constexpr std::array<std::string_view, 16> plain{
        "",       "double", "single", "int8",    "uint8", "int16",  "uint16", "int32",
        "uint32", "int64",  "uint64", "logical", "char",  "struct", "cell",   "function_handle"};
    return std::find(plain.begin(), plain.end(), name) != plain.end();
}

}  // namespace

Check checkLevel73(const std::string& file) {
    Check check;
    const Handle opened(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    const Handle root(opened >= 0 ? H5Gopen2(opened, "/", H5P_DEFAULT) : hid_t{-1}, H5Gclose);
    H5G_info_t info{};
    if (opened < 0 || root < 0 || H5Gget_info(root, &info) < 0) {
        check.fault = phrase("the file is damaged or ends too early: it begins as MATLAB 7.3 and cannot be opened");
        return check;
    }
    constexpr hsize_t most = 10'000;
    for (hsize_t i = 0; i < std::min(info.nlinks, most); ++i) {
        const std::string name = nameAt(root, i);
        if (name.empty() || name.front() == '#') continue;  // "#refs#", "#subsystem#"
        const Handle object(H5Oopen(root, name.c_str(), H5P_DEFAULT), H5Oclose);
        if (object < 0) continue;
        if (const std::string className = classOf(object); !isPlain(className))
            check.opaque.push_back({name, className});
    }
    return check;
}

}  // namespace analogon::mat

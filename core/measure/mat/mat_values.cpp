#include "core/measure/mat/mat_values.hpp"

#include <cstdint>
#include <map>

#include "core/measure/encoding.hpp"

namespace analogon::mat {

namespace {

template <class T>
std::vector<double> pick(const void* data, std::size_t first, std::size_t step, std::size_t count) {
    const T* values = static_cast<const T*>(data) + first;
    std::vector<double> out(count);
    for (std::size_t i = 0; i < count; ++i) out[i] = static_cast<double>(values[i * step]);
    return out;
}

}  // namespace

bool isNumeric(const matvar_t& variable) {
    return variable.class_type >= MAT_C_DOUBLE && variable.class_type <= MAT_C_UINT64;
}

std::size_t valuesOf(const matvar_t& variable) {
    std::size_t count = variable.rank > 0 ? 1 : 0;
    for (int i = 0; i < variable.rank; ++i) count *= variable.dims[i];
    return count;
}

std::vector<double> numbers(const matvar_t& variable, std::size_t first, std::size_t step, std::size_t count) {
    const std::size_t there = valuesOf(variable);
    if (!variable.data || variable.isComplex || variable.data_size <= 0 ||
        variable.nbytes / static_cast<std::size_t>(variable.data_size) < there)
        return {};
    if (count == 0 || first + (count - 1) * step >= there) return {};
    const void* data = variable.data;
    switch (variable.data_type) {
        case MAT_T_DOUBLE:
            return pick<double>(data, first, step, count);
        case MAT_T_SINGLE:
            return pick<float>(data, first, step, count);
        case MAT_T_INT8:
            return pick<std::int8_t>(data, first, step, count);
        case MAT_T_UINT8:
            return pick<std::uint8_t>(data, first, step, count);
        case MAT_T_INT16:
            return pick<std::int16_t>(data, first, step, count);
        case MAT_T_UINT16:
            return pick<std::uint16_t>(data, first, step, count);
        case MAT_T_INT32:
            return pick<std::int32_t>(data, first, step, count);
        case MAT_T_UINT32:
            return pick<std::uint32_t>(data, first, step, count);
        case MAT_T_INT64:
            return pick<std::int64_t>(data, first, step, count);
        case MAT_T_UINT64:
            return pick<std::uint64_t>(data, first, step, count);
        default:
            return {};
    }
}

std::vector<std::string> textRows(const matvar_t& variable) {
    std::vector<std::string> rows;
    if (variable.class_type != MAT_C_CHAR || variable.rank != 2 || !variable.data || variable.data_size <= 0)
        return rows;
    const std::size_t height = variable.dims[0], width = variable.dims[1];
    if (height > 65536) return rows;
    const auto size = static_cast<std::size_t>(variable.data_size);
    const auto* bytes = static_cast<const char*>(variable.data);
    const bool isUtf8Text = size == 1 && height == 1;
    const std::size_t there = variable.nbytes / size;
    if (!isUtf8Text && there < height * width) return rows;
    for (std::size_t row = 0; row < height; ++row) {
        std::string text;
        if (isUtf8Text) {
            text.assign(bytes, there);
        } else {
            std::string wide;
            for (std::size_t column = 0; column < width; ++column)
                wide.append(bytes + (column * height + row) * size, std::min<std::size_t>(size, 2));
            text = size == 1 ? wide : decodeText(wide, Encoding::Utf16LittleEndian);
        }
        text = inUtf8(text);
        text = text.substr(0, text.find('\0'));
        while (!text.empty() && text.back() == ' ') text.pop_back();
        rows.push_back(std::move(text));
    }
    return rows;
}

std::vector<std::string> textList(const matvar_t& variable) {
    if (variable.class_type != MAT_C_CELL) return textRows(variable);
    std::vector<std::string> texts;
    if (!variable.data) return texts;
    for (std::size_t i = 0; i < valuesOf(variable); ++i) {
        const matvar_t* cell = static_cast<matvar_t**>(variable.data)[i];
        const std::vector<std::string> rows = cell ? textRows(*cell) : std::vector<std::string>();
        if (rows.size() != 1) return {};
        texts.push_back(rows.front());
    }
    return texts;
}

const matvar_t* fieldOf(const matvar_t& structure, const std::string& name, std::size_t index) {
    // libmatio only reads what it is given, whatever its signature says
    return Mat_VarGetStructFieldByName(const_cast<matvar_t*>(&structure), name.c_str(), index);
}

Outcome<std::vector<ChannelValues>> readPlaces(const std::string& name, const std::vector<VariablePlace>& places,
                                               const Progress& progress) {
    const FilePtr file(Mat_Open(name.c_str(), MAT_ACC_RDONLY));
    if (!file) return fileError(phrase("the file cannot be read"), name);
    std::map<std::string, VariablePtr> variables;  // each is read once
    std::vector<ChannelValues> values;
    for (const VariablePlace& place : places) {
        if (progress.stopRequested()) return fileError(phrase("reading was stopped"), name);
        VariablePtr& variable = variables[place.variable];
        if (!variable) variable.reset(Mat_VarRead(file.get(), place.variable.c_str()));
        const matvar_t* found = variable.get();
        for (const FieldStep& step : place.steps) found = found ? fieldOf(*found, step.field, step.index) : nullptr;
        std::vector<double> read =
            found ? numbers(*found, place.first, place.stride, place.count) : std::vector<double>();
        if (read.size() != place.count)
            return fileError(phrase("variable \"{}\" cannot be read", place.variable), name);
        if (place.scale != 1 || place.offset != 0)
            for (double& x : read) x = x * place.scale + place.offset;
        values.push_back({std::move(read), {}});
    }
    return values;
}

}  // namespace analogon::mat

#include "core/flat/table_file.hpp"

#include <hdf5.h>
#include <matio.h>

#include <charconv>
#include <cstring>
#include <memory>
#include <optional>
#include <sstream>

#include "core/base/apart.hpp"
#include "core/base/regular_file.hpp"

namespace analogon {

namespace {

constexpr std::uint64_t largestFile = 256u << 20;  // [byte]

std::optional<double> numberAt(std::string_view text, std::size_t& at) {
    while (at < text.size() && (std::isspace(static_cast<unsigned char>(text[at])) || text[at] == ',' ||
                                text[at] == ';' || text[at] == '+'))
        ++at;
    double value = 0;
    const auto [end, problem] = std::from_chars(text.data() + at, text.data() + text.size(), value);
    if (problem != std::errc{}) return std::nullopt;
    at = static_cast<std::size_t>(end - text.data());
    return value;
}

Outcome<Matrix> fromText(const std::string& text, const std::string& file, const std::string& name) {
    std::istringstream lines(text);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        const auto word = line.find_first_not_of(" \t");
        if (word == std::string::npos) continue;
        const bool isMatrix = line.compare(word, 6, "double") == 0 || line.compare(word, 5, "float") == 0;
        if (!isMatrix) continue;
        const auto open = line.find('('), close = line.find(')');
        const auto begin = line.find_first_not_of(" \t", line.find_first_of(" \t", word));
        if (open == std::string::npos || close == std::string::npos || begin > open) continue;
        std::string own = line.substr(begin, open - begin);
        while (!own.empty() && own.back() == ' ') own.pop_back();
        if (own != name) continue;
        std::size_t at = 0;
        const std::string sizes = line.substr(open + 1, close - open - 1);
        const auto rows = numberAt(sizes, at), columns = numberAt(sizes, at);
        if (!rows || !columns || *rows < 1 || *columns < 1 || *rows * *columns > 1e7)
            return fileError(phrase("the size of the table \"{}\" cannot be read", name), file, number);
        Matrix matrix{static_cast<std::size_t>(*rows), static_cast<std::size_t>(*columns), {}};
        while (matrix.values.size() < matrix.rows * matrix.columns && std::getline(lines, line)) {
            ++number;
            line = line.substr(0, line.find('#'));
            if (const auto comment = line.find("//"); comment != std::string::npos) line.resize(comment);
            for (std::size_t place = 0; const auto value = numberAt(line, place);) matrix.values.push_back(*value);
        }
        if (matrix.values.size() < matrix.rows * matrix.columns)
            return fileError(phrase("the table \"{}\" ends after {} of {} values", name, matrix.values.size(),
                                    matrix.rows * matrix.columns),
                             file, number);
        matrix.values.resize(matrix.rows * matrix.columns);
        return matrix;
    }
    return fileError(phrase("the file holds no table \"{}\"", name), file);
}

Outcome<Matrix> fromCsv(const std::string& text, const std::string& file, char delimiter, int headerLines) {
    std::istringstream lines(text);
    std::string line;
    Matrix matrix;
    for (int number = 1; std::getline(lines, line); ++number) {
        if (number <= headerLines || line.find_first_not_of(" \t\r") == std::string::npos) continue;
        std::istringstream cells(line);
        std::size_t count = 0;
        for (std::string cell; std::getline(cells, cell, delimiter); ++count) {
            std::size_t at = 0;
            const auto value = numberAt(cell, at);
            if (!value) return fileError(phrase("\"{}\" is no number", cell), file, number);
            matrix.values.push_back(*value);
        }
        if (matrix.rows > 0 && count != matrix.columns)
            return fileError(phrase("the row has {} values, the first one {}", count, matrix.columns), file, number);
        matrix.columns = count;
        ++matrix.rows;
    }
    if (matrix.rows == 0) return fileError(phrase("the file holds no table \"{}\"", "Values"), file);
    return matrix;
}

struct CloseMat {
    void operator()(mat_t* file) const { Mat_Close(file); }
};
struct FreeMat {
    void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};

enum class MatlabTable : char { NoFile = 'f', NoTable = 'n', Matrix = 'm' };

std::string only(MatlabTable what) { return {static_cast<char>(what)}; }

const matvar_t* variableOf(const matvar_t* variable, const std::string& name) {
    for (std::size_t dot = name.find('.'); variable && dot != std::string::npos;) {
        const std::size_t next = name.find('.', dot + 1);
        const std::string field = name.substr(dot + 1, next == std::string::npos ? next : next - dot - 1);
        variable = variable->class_type == MAT_C_STRUCT
                       ? Mat_VarGetStructFieldByName(const_cast<matvar_t*>(variable), field.c_str(), 0)
                       : nullptr;
        dot = next;
    }
    return variable;
}

/// MatlabTable; of a matrix behind it rows and columns as doubles, and its values column by column.
std::string readMatlab(const std::string& file, const std::string& name) {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // what is wrong is told, not printed
    const std::unique_ptr<mat_t, CloseMat> opened(Mat_Open(file.c_str(), MAT_ACC_RDONLY));
    if (!opened) return only(MatlabTable::NoFile);
    const std::unique_ptr<matvar_t, FreeMat> variable(
        Mat_VarRead(opened.get(), name.substr(0, name.find('.')).c_str()));
    const matvar_t* found = variableOf(variable.get(), name);
    if (!found || found->rank != 2 || found->isComplex || !found->data) return only(MatlabTable::NoTable);
    const std::size_t count = found->dims[0] * found->dims[1];
    const bool isDouble = found->class_type == MAT_C_DOUBLE && found->data_type == MAT_T_DOUBLE;
    if ((!isDouble && found->class_type != MAT_C_SINGLE) ||
        count * static_cast<std::size_t>(found->data_size) > found->nbytes)
        return only(MatlabTable::NoTable);
    std::vector<double> numbers{static_cast<double>(found->dims[0]), static_cast<double>(found->dims[1])};
    for (std::size_t i = 0; i < count; ++i)
        numbers.push_back(isDouble ? static_cast<const double*>(found->data)[i]
                                   : static_cast<double>(static_cast<const float*>(found->data)[i]));
    std::string bytes = only(MatlabTable::Matrix);
    return bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double));
}

/// A matrix of a MATLAB file; `name.field` for a field of a structure. A damaged file can bring its library down.
Outcome<Matrix> fromMatlab(const std::string& file, const std::string& name) {
    const Outcome<std::string> bytes =
        runApart([&] { return readMatlab(file, name); }, mostReadingTime(file),
                 fileError(phrase("the file is damaged: it cannot be read as a MATLAB file"), file));
    if (!bytes) return bytes.diagnostics();
    if (*bytes == only(MatlabTable::NoFile)) return fileError(phrase("the file is no MATLAB file"), file);
    if (*bytes == only(MatlabTable::NoTable)) return fileError(phrase("the file holds no table \"{}\"", name), file);
    std::vector<double> numbers((bytes->size() - 1) / sizeof(double));
    std::memcpy(numbers.data(), bytes->data() + 1, numbers.size() * sizeof(double));
    Matrix matrix{static_cast<std::size_t>(numbers[0]), static_cast<std::size_t>(numbers[1]), {}};
    for (std::size_t i = 0; i < matrix.rows; ++i)
        for (std::size_t j = 0; j < matrix.columns; ++j) matrix.values.push_back(numbers[2 + j * matrix.rows + i]);
    return matrix;
}

}  // namespace

Outcome<Matrix> readTableFile(const std::string& file, const std::string& name, const std::string& delimiter,
                              int headerLines) {
    if (file.ends_with(".mat")) return fromMatlab(file, name);
    Outcome<std::string> text = readRegularFile(file, largestFile);
    if (!text) return text.diagnostics();
    if (file.ends_with(".csv")) return fromCsv(*text, file, delimiter.empty() ? ',' : delimiter[0], headerLines);
    return fromText(*text, file, name);
}

}  // namespace analogon

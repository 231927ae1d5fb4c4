#include "core/measure/xlsx/workbook.hpp"

#include <quazip/quazip.h>
#include <quazip/quazipfile.h>

#include <QXmlStreamReader>
#include <algorithm>
#include <map>
#include <set>

namespace analogon::xlsx {

namespace {

constexpr std::size_t mostCells = 20'000'000;
constexpr std::size_t mostSharedTexts = 5'000'000;
constexpr std::uint32_t mostColumns = 16384, mostRows = 1048576;

/// One file of the archive, read as XML while it is unpacked.
class Part {
public:
    Part(QuaZip& archive, const QString& name) : file_(&archive) {
        isOpen_ = archive.setCurrentFile(name) && file_.open(QIODevice::ReadOnly);
        if (isOpen_) xml.setDevice(&file_);
    }
    bool isOpen() const { return isOpen_; }
    /// Behind damage the parser would wait for more, which an archive never gives.
    bool isAtEnd() const { return xml.atEnd() || xml.hasError(); }
    /// The next element that begins; false at the end, or where the XML is damaged.
    bool next() {
        while (!isAtEnd())
            if (xml.readNext() == QXmlStreamReader::StartElement) return true;
        return false;
    }
    /// Read to its end, with the checksum that the archive tells.
    bool isWhole() {
        if (xml.hasError()) return false;
        while (!file_.atEnd() && !file_.read(1 << 16).isEmpty()) {
        }
        file_.close();
        return file_.getZipError() == UNZ_OK;
    }
    QString attribute(const char* name) const { return xml.attributes().value(QLatin1String(name)).toString(); }

private:
    QuaZipFile file_;
    bool isOpen_{};

public:
    QXmlStreamReader xml;
};

bool isDateFormat(int id, const QString& code) {
    if ((id >= 14 && id <= 22) || (id >= 27 && id <= 36) || (id >= 45 && id <= 47) || (id >= 50 && id <= 58))
        return true;
    bool isQuoted = false, isBracketed = false;
    for (const QChar c : code) {
        if (c == '"') isQuoted = !isQuoted;
        if (isQuoted) continue;
        if (c == '[') isBracketed = true;
        if (c == ']') isBracketed = false;
        if (isBracketed) continue;
        if (QString("ymdhsYMDHS").contains(c)) return true;
    }
    return false;
}

class WorkbookReader {
public:
    explicit WorkbookReader(const std::string& file) : file_(file), archive_(QString::fromStdString(file)) {}

    Outcome<std::vector<Sheet>> read() {
        if (!archive_.open(QuaZip::mdUnzip))
            return fileError(phrase("the archive is damaged: it cannot be opened"), file_);
        std::map<QString, QString> targets;
        if (Part part(archive_, "xl/_rels/workbook.xml.rels"); part.isOpen())
            while (part.next())
                if (part.xml.name() == QLatin1String("Relationship"))
                    targets[part.attribute("Id")] = part.attribute("Target");
        std::vector<std::pair<QString, QString>> sheets;  // name, target
        {
            Part part(archive_, "xl/workbook.xml");
            if (!part.isOpen())
                return fileError(phrase("no Excel workbook is in this archive"), file_, 0, 0,
                                 phrase("save the table as .xlsx or as CSV"));
            while (part.next()) {
                if (part.xml.name() == QLatin1String("workbookPr")) {
                    const QString is1904 = part.attribute("date1904");
                    dateShift_ = is1904 == QLatin1String("1") || is1904 == QLatin1String("true") ? 1462 : 0;
                }
                if (part.xml.name() == QLatin1String("sheet"))
                    sheets.emplace_back(part.attribute("name"), targets[part.attribute("r:id")]);
            }
            check(part, "xl/workbook.xml");
        }
        readSharedTexts();
        readStyles();
        std::vector<Sheet> read;
        for (const auto& [name, target] : sheets) {
            Sheet sheet;
            sheet.name = name.toStdString();
            const QString path = target.startsWith('/') ? target.mid(1) : "xl/" + target;
            readSheet(path, sheet);
            read.push_back(std::move(sheet));
        }
        if (!damaged_.isEmpty())
            return fileError(phrase("the archive is damaged: its part '{}' cannot be read as it was written",
                                    damaged_.toStdString()),
                             file_, 0, 0, phrase("copy it again from where it was saved"));
        return read;
    }

private:
    /// Text of an <si> or <is>, without the pronunciation that may stand beside it.
    static std::string richText(Part& part) {
        QString text;
        int depth = 1;
        while (depth > 0 && !part.isAtEnd()) {
            const auto token = part.xml.readNext();
            if (token == QXmlStreamReader::StartElement) {
                if (part.xml.name() == QLatin1String("t")) {
                    text += part.xml.readElementText();
                } else if (part.xml.name() == QLatin1String("rPh")) {
                    part.xml.skipCurrentElement();
                } else {
                    ++depth;
                }
            } else if (token == QXmlStreamReader::EndElement) {
                --depth;
            }
        }
        return text.toStdString();
    }

    void readSharedTexts() {
        Part part(archive_, "xl/sharedStrings.xml");
        if (!part.isOpen()) return;
        while (part.next() && shared_.size() < mostSharedTexts)
            if (part.xml.name() == QLatin1String("si")) shared_.push_back(richText(part));
        if (shared_.size() < mostSharedTexts) check(part, "xl/sharedStrings.xml");
    }

    void readStyles() {
        Part part(archive_, "xl/styles.xml");
        if (!part.isOpen()) return;
        std::map<int, QString> codes;
        bool isWithin = false;
        while (!part.isAtEnd()) {
            const auto token = part.xml.readNext();
            const bool isList = part.xml.name() == QLatin1String("cellXfs");
            if (isList && token != QXmlStreamReader::Characters) isWithin = token == QXmlStreamReader::StartElement;
            if (token != QXmlStreamReader::StartElement) continue;
            if (part.xml.name() == QLatin1String("numFmt"))
                codes[part.attribute("numFmtId").toInt()] = part.attribute("formatCode");
            if (!isWithin || part.xml.name() != QLatin1String("xf")) continue;
            const int id = part.attribute("numFmtId").toInt();
            const QString code = codes[id];
            const bool isPercent = id == 9 || id == 10 || code.endsWith('%');
            styles_.push_back(isPercent                ? Cell::Kind::Percent
                              : isDateFormat(id, code) ? Cell::Kind::Date
                                                       : Cell::Kind::Number);
        }
        check(part, "xl/styles.xml");
    }

    void check(Part& part, const QString& name) {
        if (damaged_.isEmpty() && !part.isWhole()) damaged_ = name;
    }

    void readSheet(const QString& path, Sheet& sheet) {
        Part part(archive_, path);
        if (!part.isOpen()) return;
        std::uint32_t row = 0, column = 0;
        while (part.next()) {
            if (part.xml.name() == QLatin1String("row")) {
                bool isTold = false;
                const std::uint32_t told = part.attribute("r").toUInt(&isTold);
                row = isTold ? told : row + 1;
                column = 0;
                if (row == 0 || row > mostRows) return;
            } else if (part.xml.name() == QLatin1String("c")) {
                if (cells_ == mostCells) {
                    sheet.isCut = true;
                    return;
                }
                Cell cell;
                cell.column = columnOf(part.attribute("r"), column);
                column = cell.column + 1;
                if (cell.column >= mostColumns || !readCell(part, cell)) continue;
                if (sheet.rows.empty() || sheet.rows.back().number < row) sheet.rows.push_back({row, {}});
                auto& cells = sheet.rows.back().cells;
                if (!cells.empty() && cells.back().column >= cell.column) continue;  // out of order: damaged
                cells.push_back(std::move(cell));
                ++cells_;
            }
        }
        check(part, path);
    }

    static std::uint32_t columnOf(const QString& reference, std::uint32_t next) {
        std::uint32_t column = 0;
        for (const QChar c : reference) {
            if (c < 'A' || c > 'Z' || column > mostColumns) break;
            column = column * 26 + static_cast<std::uint32_t>(c.unicode() - 'A' + 1);
        }
        return column == 0 ? next : column - 1;
    }

    /// False: there is nothing in it.
    bool readCell(Part& part, Cell& cell) {
        const QString type = part.attribute("t");
        const std::size_t style = part.attribute("s").toUInt();
        QString value;
        bool hasInline = false, hasFormula = false;
        while (!part.isAtEnd()) {
            const auto token = part.xml.readNext();
            if (token == QXmlStreamReader::EndElement && part.xml.name() == QLatin1String("c")) break;
            if (token != QXmlStreamReader::StartElement) continue;
            if (part.xml.name() == QLatin1String("v")) {
                value = part.xml.readElementText();
            } else if (part.xml.name() == QLatin1String("is")) {
                cell.text = richText(part);
                hasInline = true;
            } else {
                hasFormula = hasFormula || part.xml.name() == QLatin1String("f");
                part.xml.skipCurrentElement();
            }
        }
        if (hasFormula && value.isEmpty() && type != QLatin1String("str")) {
            cell.kind = Cell::Kind::Uncalculated;
            return true;
        }
        if (type == QLatin1String("s")) {
            const std::size_t index = value.toUInt();
            if (index < shared_.size()) cell.text = shared_[index];
        } else if (type == QLatin1String("str") || type == QLatin1String("d")) {
            cell.text = value.toStdString();
        } else if (type == QLatin1String("e")) {
            cell.kind = Cell::Kind::Error;
            return true;
        } else if (!hasInline) {
            bool isNumber = false;
            cell.number = value.toDouble(&isNumber);
            cell.kind = style < styles_.size() ? styles_[style] : Cell::Kind::Number;
            if (cell.kind == Cell::Kind::Date) cell.number += dateShift_;
            return isNumber;
        }
        cell.kind = Cell::Kind::Text;
        return cell.text.find_first_not_of(" \t\r\n") != std::string::npos;
    }

    std::string file_;
    QuaZip archive_;
    QString damaged_;  // the first part that is; empty: none
    std::vector<std::string> shared_;
    std::vector<Cell::Kind> styles_;
    double dateShift_{};
    std::size_t cells_{};
};

}  // namespace

Outcome<std::vector<Sheet>> readWorkbook(const std::string& file) { return WorkbookReader(file).read(); }

std::string columnLetters(std::uint32_t column) {
    std::string letters;
    for (std::uint32_t rest = column + 1; rest > 0; rest = (rest - 1) / 26)
        letters.insert(letters.begin(), static_cast<char>('A' + (rest - 1) % 26));
    return letters;
}

}  // namespace analogon::xlsx

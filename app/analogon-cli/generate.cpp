#include "app/analogon-cli/generate.hpp"

#include <ostream>

#include "core/archive/archive.hpp"
#include "core/base/distinct.hpp"
#include "core/measure/open/read_table.hpp"
#include "core/study/generate.hpp"
#include "core/study/study_with.hpp"
#include "core/study/validate.hpp"

namespace analogon::cli {

namespace {

Outcome<GenerateRequest> requestOf(const Options& options) {
    GenerateRequest request;
    Diagnostics remarks;
    request.domains = options.domains;
    if (!options.className.empty()) request.className = options.className;
    for (const std::filesystem::path& file : options.data) {
        Outcome<Table> table = readTable(file);
        if (!table) return table.diagnostics();
        remarks.insert(remarks.end(), table.diagnostics().begin(), table.diagnostics().end());
        request.recordings.push_back(std::make_shared<const Table>(std::move(*table)));
    }
    return {std::move(request), std::move(remarks)};
}

}  // namespace

int generate(const Options& options, std::ostream& out, std::ostream& err) {
    const auto fails = [&err](const Diagnostics& faults) {
        err << format(faults) << std::endl;
        return static_cast<int>(inputAtFault);
    };
    if (const Outcome<Done> isNew = checkNewPlace(options.out); !isNew) return fails(isNew.diagnostics());
    const Outcome<GenerateRequest> request = requestOf(options);
    if (!request) return fails(request.diagnostics());
    Outcome<Library> library = builtInLibrary();
    for (const std::filesystem::path& path : options.libraries)
        if (library) library = library->withPath(path);
    if (!library) return fails(library.diagnostics());
    const Outcome<GeneratedStudy> generated = generateStudy(*library, *request);
    if (!generated) return fails(generated.diagnostics());
    const Outcome<Done> written = saveStudy(generated->study, options.out);
    if (!written) return fails(written.diagnostics());
    const std::string directory = options.out.string();
    const Outcome<ValidStudy> valid = validated(withLibraries(generated->study, options.libraries), Purpose::Discover);
    Diagnostics said = request.diagnostics();
    for (const Diagnostics& more : {written.diagnostics(), generated.diagnostics(), valid.diagnostics()})
        said.insert(said.end(), more.begin(), more.end());
    if (said = distinct(std::move(said)); !said.empty()) err << format(said) << std::endl;
    out << "study: " << directory << "\n\nassumed\n";
    for (const Text& assumption : generated->assumptions) out << "  - " << assumption << '\n';
    if (!valid) {
        out << "\nnext: mend what is told above, then analogon-cli check " << directory << std::endl;
        return inputAtFault;
    }
    out << "\nnext: analogon-cli discover " << directory << " --out " << directory << "-result" << std::endl;
    return done;
}

}  // namespace analogon::cli

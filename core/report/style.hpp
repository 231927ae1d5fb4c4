#pragma once

namespace analogon {

/// The style sheet of the report page: light, dark (by the reader's setting) and print.
const char* reportStyle();

}  // namespace analogon

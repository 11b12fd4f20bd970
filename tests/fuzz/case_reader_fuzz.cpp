// Any bytes are either a case or a CaseError. What is read can be written and read again.
#include "cases/program/case/case_file.hpp"
#include "cases/program/case/case_writer.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::optional<delabole::CaseFile> read;
    try {
        read = delabole::parse_case({reinterpret_cast<const char*>(data), size}, "fuzz");
    } catch (const delabole::CaseError&) {
        return 0;
    }
    const std::string resolved = delabole::resolved_toml(*read);
    if (delabole::resolved_toml(delabole::parse_case(resolved, "resolved")) != resolved) {
        std::cerr << "the resolved case is not stable:\n" << resolved;
        std::abort();
    }
    return 0;
}

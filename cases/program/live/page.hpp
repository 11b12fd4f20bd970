// The page, as page/ was when the program was built: one file that needs no other. Its style and script run if
// "@nonce@" is replaced by the nonce of the server's content security policy.
#pragma once

#include <string_view>

namespace delabole {

extern const std::string_view live_page;

}  // namespace delabole

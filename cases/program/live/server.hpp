// The local server of `delabole live`. It listens on 127.0.0.1 only and answers only clients that know its token.
//
// It refuses, each with a status:
//     400  what is not JSON or not a possible request; a body or an answer in parts or compressed
//     401  a request without the token
//     403  a Host that is not this address (DNS rebinding), or an Origin that is not this page
//     404  any other path
//     413  a body of more than 256 kB
// For all but 400, which the page shows, it prints a line on standard error, at most one a second. Clients that are not
// admitted are refused before the body is read. A connection that is silent for 1 s is closed, and at most eight are
// served at a time.
#pragma once

#include "cases/program/live/session.hpp"

#include <functional>
#include <memory>
#include <string>

namespace delabole {

class LiveServer {
  public:
    // Throws OutputError if no port is free.
    explicit LiveServer(LiveSession& session);
    ~LiveServer();
    LiveServer(const LiveServer&) = delete;
    LiveServer& operator=(const LiveServer&) = delete;

    // http://127.0.0.1:43567/#<token>. Browsers do not send the part behind #: no log and no other page sees the token.
    std::string address() const;

    // Serves until `ended`, which is called several times a second, returns true. Ends the program, as end_work() does,
    // if an answer is still computed or a request still sent 1.8 s later.
    void serve(const std::function<bool()>& ended);

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace delabole

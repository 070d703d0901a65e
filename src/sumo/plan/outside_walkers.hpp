// Persons whom another program walks: who is let go for it, and who comes back.
#pragma once

#include <string>

#include "sumo/plan/bystanders.hpp"

namespace pedzone {

/// From `time` [s] on another program walks the person. `declared`: its parameter pedzone.external
/// says so; otherwise it was noticed.
void leave_to_others(Bystander& person, double time, bool declared);

/// Whether at `time` [s] SUMO is to be asked if the person, whom another program walks, is declared
/// to be that program's. Who was declared: twice a second. Who was noticed: once it has stood for
/// 3 s at the place where it was put last, and twice a second from then on.
bool is_to_be_asked(Bystander& person, double time);

/// What SUMO has answered. True: no other program walks it any more.
bool comes_back(Bystander& person, bool is_declared);

/// Whether somebody who has come back, and cannot be taken over, is put on a lane of SUMO's at
/// once: there it would stand for ever. SUMO has it on `edge`. Not while it moves, nor within a
/// junction, where SUMO cannot put it back.
bool is_to_be_put_back(const Bystander& person, const std::string& edge);

}  // namespace pedzone

#include "app/command_line/command_line.hpp"
#include "app/command_line/terminal.hpp"

int main(int argc, char** argv) {
  pedzone::end_when_nobody_reads();
  return pedzone::command_line(argc, argv);
}

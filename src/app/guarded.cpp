#include "app/guarded.hpp"

#include "app/command_line/terminal.hpp"
#include "core/error.hpp"

namespace pedzone {

int guarded(const std::function<void()>& work) {
  const auto report = [](const std::exception& error, int code) {
    print_error(error.what());
    return code;
  };
  try {
    work();
    return 0;
  } catch (const InputError& error) {
    return report(error, kExitInput);
  } catch (const SumoError& error) {
    return report(error, kExitSumo);
  } catch (const std::exception& error) {
    return report(error, 1);
  }
}

int guarded_code(const std::function<int()>& work) {
  int code = 0;
  const int error = guarded([&] { code = work(); });
  return error != 0 ? error : code;
}

}  // namespace pedzone

#include "app/guarded.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace pedzone {

int guarded(const std::function<void()>& work) {
  const auto report = [](const std::exception& error, int code) {
    fmt::print(stderr, "Error: {}\n", error.what());
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

}  // namespace pedzone

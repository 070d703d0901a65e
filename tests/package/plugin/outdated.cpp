// What is left of a plug-in that was built for an interface before the first.
#include "model/plugin.hpp"

extern "C" {
extern const pedzone::PluginEntry pedzone_walking_model;
const pedzone::PluginEntry pedzone_walking_model = {
    pedzone::kModelInterface - 1, pedzone::kModelLayout,
    []() -> pedzone::WalkingModel* { return nullptr; }};
}

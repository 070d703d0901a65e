#include "results/geo_frame.hpp"

#include <proj.h>

#include <cmath>
#include <utility>

#include "core/error.hpp"

namespace pedzone {
namespace {

InputError location_error(const GeoReference& geo, const std::string& problem) {
  return {problem,
          {geo.file, 0, "<location> attribute projParameter", geo.projection,
           "a projection of PROJ such as '+proj=utm +zone=32 +datum=WGS84'; netconvert writes it "
           "for data with longitudes and latitudes"}};
}

}  // namespace

struct GeoFrame::Projection {
  explicit Projection(const std::string& definition)
      : projection(proj_create(context, definition.c_str())) {}
  ~Projection() {
    proj_destroy(projection);
    proj_context_destroy(context);
  }
  Projection(const Projection&) = delete;
  Projection& operator=(const Projection&) = delete;

  /// From metres to angles.
  bool leads_back() const {
    return projection != nullptr && proj_pj_info(projection).has_inverse != 0 &&
           proj_angular_output(projection, PJ_INV) != 0;
  }

  PJ_CONTEXT* context = silent();
  PJ* projection = nullptr;

 private:
  static PJ_CONTEXT* silent() {
    PJ_CONTEXT* const made = proj_context_create();
    proj_log_level(made, PJ_LOG_NONE);  // what fails is told by the caller
    return made;
  }
};

GeoFrame::GeoFrame(GeoReference geo) : geo_(std::move(geo)) {
  const std::string& definition = geo_.projection;
  if (definition.empty() || definition == "!") {
    throw location_error(geo_, "is no projection: where the network lies on Earth is not known");
  }
  projection_ = std::make_unique<Projection>(definition);
  if (!projection_->leads_back()) {
    throw location_error(geo_, "is no projection that leads back to longitude and latitude");
  }
}

GeoFrame::~GeoFrame() = default;

Vec2 GeoFrame::lon_lat(const Vec2& place) const {
  const Vec2 projected = place - geo_.offset;
  const PJ_COORD angles = proj_trans(projection_->projection, PJ_INV,
                                     proj_coord(projected.x(), projected.y(), 0.0, HUGE_VAL));
  const Vec2 found(proj_todeg(angles.lp.lam), proj_todeg(angles.lp.phi));
  if (!(std::abs(found.x()) <= 180.0) || !(std::abs(found.y()) <= 90.0)) {
    throw location_error(geo_, "leads to places that are not on Earth");
  }
  return found;
}

std::optional<Vec2> GeoFrame::place(const Vec2& lon_lat) const {
  if (!(std::abs(lon_lat.x()) <= 180.0) || !(std::abs(lon_lat.y()) <= 90.0)) return std::nullopt;
  const PJ_COORD there =
      proj_trans(projection_->projection, PJ_FWD,
                 proj_coord(proj_torad(lon_lat.x()), proj_torad(lon_lat.y()), 0.0, HUGE_VAL));
  const Vec2 found = Vec2(there.xy.x, there.xy.y) + geo_.offset;
  if (!found.allFinite()) return std::nullopt;
  return found;
}

}  // namespace pedzone
